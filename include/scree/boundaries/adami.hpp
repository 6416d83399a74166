// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/pass.hpp"
#include "../terms/density.hpp"
#include "../terms/gravity.hpp"
#include "../terms/shepard.hpp"
#include "wall.hpp"

// Walls of dummy particles that take velocity and stress from the material in front of them: Adami, Hu & Adams (2012);
// Zhu et al. (2024), section 4.1. Wall particles move with the wall; the wall velocity used by the material is a
// separate field.
namespace scree {

/// The velocity of a wall particle as used by the material, m/s.
struct DummyVelocity : Vector<"dummy velocity", "m/s"> {};

/// The kernel-weighted offset of a wall particle from the material, $\sum_m V_m W_{dm} (x_d - x_m)$, m.
struct WeightedOffset : Vector<"weighted offset", "m"> {};

namespace fields {
inline constexpr DummyVelocity dummy_velocity{};
inline constexpr WeightedOffset weighted_offset{};
}  // namespace fields

namespace adami {

/// Pair term for the kernel sum and the weighted offset of a wall particle over the material.
struct Weights {
  using reads = Fields<>;
  using reads_j = Fields<Volume>;
  using adds = Fields<Weight, WeightedOffset>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const w = j[volume] * ij.W();
    sum[weight] += w;
    sum[weighted_offset] += w * ij.x;
  }
};
/// Pair term for the kernel-weighted sum of a field of the material at a wall particle.
template <Field F>
struct Weighted {
  using reads = Fields<>;
  using reads_j = Fields<Volume, F>;
  using adds = Fields<WeightedSum<F>>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    sum[WeightedSum<F>{}] += j[fields::volume] * ij.W() * j[F{}];
  }
};

/// Returns the mean velocity of the material relative to the wall, <u_m - u_w(x_m)>, m/s, from the weighted sums of a
/// wall particle that has material in front of it.
template <class I, class T>
SCREE_FN auto mean_slip(I const& wall, T const& total) {
  using namespace fields;
  using vector = std::remove_cvref_t<decltype(wall[velocity])>;
  typename vector::Scalar const w = total[weight];
  vector const wall_there = wall[velocity] - wall[velocity_gradient] * (total[weighted_offset] / w);
  return vector(total[WeightedSum<Velocity>{}] / w - wall_there);
}

/// Computes the velocity u_d of a wall particle, which mirrors the slip of the material: u_d = u_w(x_d) - <u_m -
/// u_w(x_m)>. This is eq. (4.1) for a wall at rest and exact for rigid motion; at a slip wall only the normal part is
/// mirrored.
struct ExtrapolateVelocity {
  using reads = Fields<Velocity, VelocityGradient, SlipNormal>;
  using writes = Fields<DummyVelocity>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(wall[velocity])>;
    out[dummy_velocity] = wall[velocity];
    if (!(total[weight] > 0)) return;
    out[dummy_velocity] = walls::mirrored<vector>(wall[velocity], mean_slip(wall, total), wall[slip_normal]);
  }
};

/// Returns the mean density, kg/m^3, of the material in front of a wall particle, from its weighted sums.
template <class Rho, class T>
SCREE_FN auto mean_density([[maybe_unused]] Rho const& rho, T const& total) {
  using namespace fields;
  using Real = std::remove_cvref_t<decltype(total[weight])>;
  if constexpr (OneOf<Density, typename Rho::reads>)
    return Real(total[WeightedSum<Density>{}] / total[weight]);
  else
    return Real(rho.value);
}

/// Computes the stress sigma_d of a wall particle: <sigma_m> extrapolated over <x_d - x_m> by walls::extrapolated(), in
/// place of eq. (4.3), which omits the shear stress. At a slip wall the mirror image of <sigma_m> is extrapolated, and
/// the weight changes its normal stresses only.
template <class Rho>
struct ExtrapolateStress {
  Rho rho;  ///< of the material
  Gravity gravity;
  using reads = Fields<Acceleration, SlipNormal>;
  using writes = Fields<Stress>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(wall[acceleration])>;
    using Packed = std::remove_cvref_t<decltype(out[stress])>;
    using Real = typename vector::Scalar;
    out[stress] = zero<Packed>();
    Real const w = total[weight];
    if (!(w > 0)) return;
    vector const weight_force = mean_density(rho, total) * (gravity.vector<vector>() - wall[acceleration]);
    Packed const mean = walls::reflected<Packed, vector>(total[WeightedSum<Stress>{}] / w, wall[slip_normal]);
    bool const holds = !(squared_norm(wall[slip_normal]) > 0);
    out[stress] = walls::extrapolated<Packed, vector>(mean, weight_force, total[weighted_offset] / w, holds);
  }
};

/// Lens through which the material reads the extrapolated velocity of a wall particle. The stress field of the wall
/// particle already holds the extrapolated stress.
struct Seen {
  static constexpr bool takes_packs = true;
  using provides = Fields<Velocity>;
  using reads = Fields<DummyVelocity>;
  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const&, J const& j) const {
    return j[fields::dummy_velocity];
  }
};

/// Returns the pass that runs `then` on wall particles, with the weighted sums of stress and, if it varies, density of
/// the material in front, and with the sums `also`.
template <class Rho, class Then, class... Also>
auto mean_stress_passes(Then const& then, Also const&... also) {
  auto const sums = [&] {
    if constexpr (OneOf<Density, typename Rho::reads>)
      return over<Material>(Weights{}, Weighted<Stress>{}, Weighted<Density>{}, also...);
    else
      return over<Material>(Weights{}, Weighted<Stress>{}, also...);
  };
  return std::tuple(pair_pass_then<Wall>("scree::wall_stress", then, sums()));
}

}  // namespace adami

/// Wall scheme by extrapolation. StressOfWall<Rho>{rho, gravity} computes the stress of a wall particle from weighted
/// sums, like adami::ExtrapolateStress.
template <template <class Rho> class StressOfWall>
struct ExtrapolatedWalls {
  static constexpr bool shows_means = true;
  auto velocity_passes() const {
    return std::tuple(pair_pass_then<Wall>("scree::wall_velocity", adami::ExtrapolateVelocity{},
                                           over<Material>(adami::Weights{}, adami::Weighted<Velocity>{})));
  }
  template <class Rho>
  auto stress_passes(Rho const& rho, Gravity const& gravity) const {
    return adami::mean_stress_passes<Rho>(StressOfWall<Rho>{rho, gravity});
  }
  template <class Rho>
  adami::Seen lens(Rho const&, Gravity const&) const {
    return {};
  }
};
/// Walls of dummy particles that take velocity and stress from the material in front of them: Adami et al. (2012); Zhu
/// et al. (2024), section 4.1, with the corrections in docs/theory/granular.md. These walls do not conserve the energy
/// of the material, see ConservingWalls.
struct AdamiWalls : ExtrapolatedWalls<adami::ExtrapolateStress> {};

}  // namespace scree

#include "instances.hpp"
