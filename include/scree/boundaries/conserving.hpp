// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "adami.hpp"

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

/// The mirrored velocity of adami::ExtrapolateVelocity, for the viscosity; the velocity in strain rates; the gradient
/// of u': that sum over the sum of V W, at a slip wall across it only.
struct Velocities {
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
    out[slip_gradient] = total[slip_gradient] / w;
    vector const n = wall[slip_normal];
    if (!(squared_norm(n) > 0)) return;
    vector const seen = out[dummy_velocity];
    out[strain_velocity] = seen - dot(n, vector(seen - wall[velocity])) * n;
    out[slip_gradient] = outer((dot(n, Matrix(total[slip_gradient]) * n) / w) * n, n);
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

/// The stress of adami::ExtrapolateStress, and that sum along a slip wall over the sum of V W.
template <class Rho>
struct Stresses : adami::ExtrapolateStress<Rho> {
  using Mean = adami::ExtrapolateStress<Rho>;
  using writes = Merge<typename Mean::writes, Fields<SlipForce>>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(wall[slip_normal])>;
    Mean::operator()(wall, total, out);
    out[slip_force] = zero<vector>();
    vector const n = wall[slip_normal], sum = total[slip_force];
    if (total[weight] > 0 && squared_norm(n) > 0) out[slip_force] = (sum - dot(sum, n) * n) / total[weight];
  }
};

/// Mean velocity and mean stress of the material; at a slip wall the stress that leaves, in its sum with that of i, no
/// shear stress along the wall and along the wall that of i.
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
    auto const slips = squared_norm(n);
    Packed sigma = j[stress];
    if (any_positive(slips)) {
      vector const of_i = product(i[stress], n), of_wall = product(sigma, n);
      vector const s = (dot(n, of_wall) / 2 + dot(n, of_i)) * n - of_i;
      sigma = walls::with_shear<Packed, vector>(Packed((1 - slips) * sigma), s, n);
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
/// wall is left out of stress and strain alike, and along the wall both change their parts: strain rates are those
/// towards the mean velocity of the material, and the force has the gradient of the stress. So a slip wall has no force
/// along itself, and material that slides past it is not strained. Energy is kept with PlainStrain, the default;
/// CorrectedStrain takes the mirrored velocities of AdamiWalls.
struct ConservingWalls : ExtrapolatedWalls<conserving::Stresses, conserving::SlipForceSum> {
  auto velocity_passes() const {
    return std::tuple(pair_pass_then<Wall>(
        "scree::wall_velocity", conserving::Velocities{},
        over<Material>(adami::Weights{}, adami::Weighted<Velocity>{}, conserving::SlipGradientSum{})));
  }
  template <class Rho>
  conserving::Lens lens(Rho const&, Gravity const&) const {
    return {};
  }
  /// The term over the wall that adds to the velocity gradient of strain rates.
  conserving::WallStrain strain_term() const { return {}; }
  template <class Rho>
  conserving::AlongWall<Rho> force_term(Rho const& rho) const {
    return {rho};
  }
};

}  // namespace scree
