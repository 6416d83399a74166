// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "adami.hpp"

#include <array>
#include <tuple>
#include <type_traits>

// Walls that show means of the stress, like those of adami.hpp, and keep the energy of the material: the strain rates
// next to them are the adjoint of their forces.
namespace scree {

/// $\langle \partial u'/\partial x\rangle$ in a wall, of the velocity u' relative to the wall.
struct SlipGradient : Tensor<"slip gradient", "1/s"> {};

/// The velocity of a wall in strain rates: its own, along a slip wall the mean of the material, m/s.
struct StrainVelocity : Vector<"strain velocity", "m/s"> {};

/// $\langle \nabla \cdot \sigma\rangle$ along a slip wall, of the stress along it, N/m^3.
struct SlipForce : Vector<"slip force", "N/m^3"> {};

namespace fields {
inline constexpr SlipGradient slip_gradient{};
inline constexpr StrainVelocity strain_velocity{};
inline constexpr SlipForce slip_force{};
}  // namespace fields

namespace conserving {

/// $\sum_m V_m u'_m \otimes \nabla_d W_{dm}$ over the material, with u' = u_m - u_w(x_m).
struct SlipGradientSum {
  using reads = Fields<>;
  using reads_i = Fields<Velocity, VelocityGradient>;
  using reads_j = Fields<Volume, Velocity>;
  using adds = Fields<SlipGradient>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& wall, J const& m, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const slip = m[velocity] - wall[velocity] + wall[velocity_gradient] * ij.x;
    sum[slip_gradient] += outer(m[volume] * slip, ij.gradW());
  }
};

/// The share that the form for material at rest has along a slip wall: 1 where material slides more slowly than half of
/// `sliding_speed` (m/s), 0 from `sliding_speed` on, and smooth in between.
template <class X>
SCREE_FN typename X::Scalar share_at_rest(X const& slip, X const& n, double sliding_speed) {
  using Real = typename X::Scalar;
  Real const speed = norm(X(slip - dot(n, slip) * n)), limit = Real(sliding_speed);
  if (speed >= limit) return Real(0);
  Real const above = Kokkos::max(Real(0), 2 * speed / limit - 1);
  return 1 - above * above * (3 - 2 * above);
}

/// The mirrored velocity of adami::ExtrapolateVelocity, for the viscosity; the velocity in strain rates; the gradient
/// of u': that sum over the sum of V W, at a slip wall without shear along it.
struct Velocities {
  double sliding_speed;  ///< m/s
  using reads = adami::ExtrapolateVelocity::reads;
  using writes = Fields<DummyVelocity, StrainVelocity, SlipGradient>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(wall[velocity])>;
    using Matrix = std::remove_cvref_t<decltype(out[slip_gradient])>;
    adami::ExtrapolateVelocity{}(wall, total, out);
    out[strain_velocity] = wall[velocity];
    out[slip_gradient] = zero<Matrix>();
    auto const w = total[weight];
    if (!(w > 0)) return;
    Matrix const G = total[slip_gradient] / w;
    out[slip_gradient] = G;
    vector const n = wall[slip_normal];
    if (!(squared_norm(n) > 0)) return;
    vector const slip = adami::mean_slip(wall, total);
    vector const column = G * n, row = transposed(G) * n;
    auto const rest = share_at_rest<vector>(slip, n, sliding_speed), across = dot(n, column);
    out[strain_velocity] = wall[velocity] + (1 - rest) * (slip - dot(n, slip) * n);
    out[slip_gradient] =
        rest * (G - outer(column - across * n, n) - outer(n, row - across * n)) + outer((1 - rest) * across * n, n);
  }
};

/// The sum over the wall in the velocity gradient: $\sum_d V_d [(u_d - u_i) \otimes \nabla W_{id} + W_{id} G_d]$ with
/// the velocity of the wall in strain rates and the slip gradient G, at a slip wall without shear along the wall.
struct WallStrain {
  using reads = Fields<>;
  using reads_i = Fields<Velocity>;
  using reads_j = Fields<Volume, StrainVelocity, SlipNormal, SlipGradient>;
  using adds = Fields<VelocityGradient>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    sum[velocity_gradient] += (j[volume] * ij.W()) * j[slip_gradient];
    auto const d = j[volume] * (j[strain_velocity] - i[velocity]);
    auto const g = ij.gradW();
    sum[velocity_gradient] += outer(d, g);
    auto const n = j[slip_normal];
    if (any_positive(squared_norm(n))) {
      auto const d_n = dot(d, n), g_n = dot(g, n);
      sum[velocity_gradient] += outer((d_n * n - d) * g_n, n) + outer(n, (g_n * n - g) * d_n);
    }
  }
};

/// $\sum_m V_m \sigma_m \nabla_d W_{dm}$ over the material, at slip walls with the gradient along the wall.
struct SlipForceSum {
  using reads = Fields<>;
  using reads_i = Fields<SlipNormal>;
  using reads_j = Fields<Volume, Stress>;
  using adds = Fields<SlipForce>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& wall, J const& m, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    auto const n = wall[slip_normal];
    if (!any_positive(squared_norm(n))) return;
    auto const g = ij.gradW();
    sum[slip_force] += m[volume] * product(m[stress], g - dot(g, n) * n);
  }
};

/// The stress of adami::ExtrapolateStress and the slip force, that sum over the sum of V W, of a slip wall each with
/// its share along the wall.
template <class Rho>
struct Stresses {
  adami::ExtrapolateStress<Rho> mean;
  double sliding_speed;  ///< m/s
  using reads = Merge<reads_of<adami::ExtrapolateStress<Rho>>, Fields<Velocity, VelocityGradient>>;
  using writes = Fields<Stress, SlipForce>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(wall[slip_normal])>;
    using Packed = std::remove_cvref_t<decltype(out[stress])>;
    mean(wall, total, out);
    out[slip_force] = zero<vector>();
    vector const n = wall[slip_normal], sum = total[slip_force];
    if (!(total[weight] > 0 && squared_norm(n) > 0)) return;
    auto const rest = share_at_rest<vector>(adami::mean_slip(wall, total), n, sliding_speed);
    Packed const sigma = out[stress];
    vector const half = ((1 - rest) * dot(n, vector(product(sigma, n))) / 2) * n;
    out[stress] = walls::with_shear<Packed, vector>(Packed(rest * sigma), half, n);
    out[slip_force] = ((1 - rest) / total[weight]) * (sum - dot(sum, n) * n);
  }
};

/// The mirrored mean velocity and the mean stress of the material; at a slip wall the stress whose sum with that of i
/// has no shear along the wall.
struct Lens {
  using provides = Fields<Velocity, Stress>;
  using reads = Fields<DummyVelocity, Stress, SlipNormal>;
  using reads_i = Fields<Stress>;
  static constexpr bool takes_packs = true;
  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const&, J const& j) const {
    return j[fields::dummy_velocity];
  }
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using namespace fields;
    using namespace math;
    using vector = std::remove_cvref_t<decltype(j[slip_normal])>;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    vector const n = j[slip_normal];
    Packed sigma = j[stress];
    if (any_positive(squared_norm(n))) {
      vector const traction = product(Packed(i[stress] + j[stress]), n);
      sigma = walls::with_shear<Packed, vector>(sigma, dot(n, traction) * n - traction, n);
    }
    return sigma;
  }
};

/// The part of a slip wall in the divergence of the stress along it: $\sum_d V_d W_{id} H_d/\rho_i$, with the slip
/// force H.
template <class Rho>
struct AlongWall {
  Rho rho;
  using reads = Fields<>;
  using reads_i = typename Rho::reads;
  using reads_j = Fields<Volume, SlipForce>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[acceleration] += (rho.inverse_of(i) * j[volume] * ij.W()) * j[slip_force];
  }
};

}  // namespace conserving

/// Walls of dummy particles that show the mean stress of the material in front of them, as AdamiWalls, and keep its
/// energy. The force of a wall on i is $\sum_d V_d \langle\sigma\rangle_d \nabla W_{id}$; its work is taken from the
/// elastic energy if the velocity gradient at k has $\sum_d V_d [(u_w(x_d) - u_k) \otimes \nabla W_{kd} + W_{kd} G_d]$
/// with $G_d = \sum_m V_m u'_m \otimes \nabla_d W_{dm}/\sum_m V_m W_{dm}$ in place of the difference from a mirrored
/// velocity. It is exact for velocities that grow linearly from the wall. At walls with a `slip_normal` shear along the
/// wall is left out of stress and strain alike, and where material slides, both change their parts along the wall:
/// strain rates are those towards the mean velocity of the material, and the force has the mean gradient of the stress.
/// Then the stress acts across the wall only, and what slides past it is not strained, however stiff; at rest uniform
/// stress is kept in its corners. Energy is kept with PlainStrain, the default, and ObjectiveStrain; CorrectedStrain
/// takes the mirrored velocities of AdamiWalls. These walls are the default of Granular.
struct ConservingWalls : ExtrapolatedWalls<adami::ExtrapolateStress> {
  double sliding_speed = 0.01;  ///< m/s: from here on material slides along slip walls; below half of it, it is at rest

  static constexpr auto parameters() {
    return std::array{parameter("sliding_speed", &ConservingWalls::sliding_speed, "m/s",
                                "speed along slip walls from which they bear nothing along themselves",
                                allowed::at_least_or_infinite(0))};
  }
  /// Throws std::invalid_argument if the parameter is out of range.
  void check() const { check_parameters(*this, "ConservingWalls"); }

  auto velocity_passes() const {
    return std::tuple(pair_pass_then<Wall>(
        "scree::wall_velocity", conserving::Velocities{sliding_speed},
        over<Material>(adami::Weights{}, adami::Weighted<Velocity>{}, conserving::SlipGradientSum{})));
  }
  template <class Rho>
  auto stress_passes(Rho const& rho, Gravity const& gravity) const {
    return adami::mean_stress_passes<Rho>(conserving::Stresses<Rho>{{rho, gravity}, sliding_speed},
                                          adami::Weighted<Velocity>{}, conserving::SlipForceSum{});
  }
  template <class Rho>
  conserving::Lens lens(Rho const&, Gravity const&) const {
    return {};
  }
  conserving::WallStrain strain_term() const { return {}; }
  template <class Rho>
  conserving::AlongWall<Rho> force_term(Rho const& rho) const {
    return {rho};
  }
};

}  // namespace scree
