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

namespace fields {
inline constexpr SlipGradient slip_gradient{};
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

/// d g^T without its shear along planes across n, a unit vector or none: all of it but $d_t n^T g_n + n g_t^T d_n$.
template <class X>
SCREE_FN auto without_shear(X const& d, X const& g, X const& n) {
  auto const d_n = dot(d, n), g_n = dot(g, n);
  return outer(d, g) - outer((d - d_n * n) * g_n, n) - outer(n, (g - g_n * n) * d_n);
}

/// The mirrored velocity of adami::ExtrapolateVelocity, for the viscosity, and the gradient of u': that sum over the
/// sum of V W, at a slip wall without shear along the wall.
struct VelocityAndGradient {
  using reads = adami::ExtrapolateVelocity::reads;
  using writes = Fields<DummyVelocity, SlipGradient>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    using Matrix = std::remove_cvref_t<decltype(out[slip_gradient])>;
    adami::ExtrapolateVelocity{}(wall, total, out);
    out[slip_gradient] = zero<Matrix>();
    auto const w = total[weight];
    if (!(w > 0)) return;
    Matrix const G = total[slip_gradient] / w;
    auto const n = wall[slip_normal];
    auto const across = G * n, along = transposed(G) * n;
    out[slip_gradient] = G - outer(across - dot(n, across) * n, n) - outer(n, along - dot(n, along) * n);
  }
};

/// The sum over the wall in the velocity gradient: $\sum_d V_d [(u_w(x_d) - u_i) \otimes \nabla W_{id} + W_{id} G_d]$
/// with the slip gradient G, at a slip wall without shear along the wall.
struct WallStrain {
  using reads = Fields<>;
  using reads_i = Fields<Velocity>;
  using reads_j = Fields<Volume, Velocity, SlipNormal, SlipGradient>;
  using adds = Fields<VelocityGradient>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const pair = without_shear(j[velocity] - i[velocity], ij.gradW(), j[slip_normal]);
    sum[velocity_gradient] += j[volume] * (pair + ij.W() * j[slip_gradient]);
  }
};

/// Mean velocity and mean stress of the material; at a slip wall the stress that leaves no shear stress along the wall
/// in its sum with that of i.
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
    using vector = std::remove_cvref_t<decltype(j[slip_normal])>;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    vector const n = j[slip_normal], traction = product(Packed(i[stress] + j[stress]), n);
    return walls::with_shear<Packed, vector>(j[stress], dot(n, traction) * n - traction, n);
  }
};

}  // namespace conserving

/// Walls of dummy particles that show the mean stress of the material in front of them, as AdamiWalls, and keep its
/// energy. The force of a wall on i is $\sum_d V_d \langle\sigma\rangle_d \nabla W_{id}$; its work is taken from the
/// elastic energy if the velocity gradient at k has $\sum_d V_d [(u_w(x_d) - u_k) \otimes \nabla W_{kd} + W_{kd} G_d]$
/// with $G_d = \sum_m V_m u'_m \otimes \nabla_d W_{dm}/\sum_m V_m W_{dm}$ in place of the difference from a mirrored
/// velocity. It is exact for velocities that grow linearly from the wall. At walls with a `slip_normal` shear along the
/// wall is left out of stress and strain alike. Energy is kept with PlainStrain, the default; CorrectedStrain takes the
/// mirrored velocities of AdamiWalls.
struct ConservingWalls : ExtrapolatedWalls<adami::ExtrapolateStress> {
  auto velocity_passes() const {
    return std::tuple(pair_pass_then<Wall>(
        "scree::wall_velocity", conserving::VelocityAndGradient{},
        over<Material>(adami::Weights{}, adami::Weighted<Velocity>{}, conserving::SlipGradientSum{})));
  }
  template <class Rho>
  conserving::Lens lens(Rho const&, Gravity const&) const {
    return {};
  }
  /// The term over the wall that adds to the velocity gradient of strain rates.
  conserving::WallStrain strain_term() const { return {}; }
};

}  // namespace scree
