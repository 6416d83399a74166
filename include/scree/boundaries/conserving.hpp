// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "adami.hpp"

#include <array>
#include <tuple>
#include <type_traits>

// Walls with mean stresses, like those of adami.hpp, that conserve the energy of the material: the operator for the
// strain rates next to a wall is the adjoint of the operator for the forces of the wall.
namespace scree {

/// The mean gradient $\langle \partial u'/\partial x\rangle$ at a wall particle of the velocity u' relative to the
/// wall.
struct SlipGradient : Tensor<"slip gradient", "1/s"> {};

/// The velocity of a wall in strain rates, m/s: the velocity of the wall itself; along a slip wall past which material
/// slides, the mean velocity of the material.
struct StrainVelocity : Vector<"strain velocity", "m/s"> {};

/// The mean force $\langle \nabla \cdot \sigma\rangle$ along a slip wall, with derivatives along the wall only, N/m^3.
struct SlipForce : Vector<"slip force", "N/m^3"> {};

namespace fields {
inline constexpr SlipGradient slip_gradient{};
inline constexpr StrainVelocity strain_velocity{};
inline constexpr SlipForce slip_force{};
}  // namespace fields

namespace conserving {

/// Pair term for the sum over the material $\sum_m V_m u'_m \otimes \nabla_d W_{dm}$, with u'_m = u_m - u_w(x_m).
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

/// Returns the weight of the formulation for material at rest along a slip wall: 1 if the material slides more slowly
/// than half of `sliding_speed` (m/s), 0 from `sliding_speed` on, and smooth in between.
template <class X>
SCREE_FN typename X::Scalar share_at_rest(X const& slip, X const& n, double sliding_speed) {
  using Real = typename X::Scalar;
  Real const speed = norm(X(slip - dot(n, slip) * n)), limit = Real(sliding_speed);
  if (speed >= limit) return Real(0);
  Real const above = Kokkos::max(Real(0), 2 * speed / limit - 1);
  return 1 - above * above * (3 - 2 * above);
}

/// Computes three values of a wall particle: the mirrored velocity of adami::ExtrapolateVelocity, for the viscosity;
/// the velocity in strain rates; and the gradient of u', which is SlipGradientSum divided by the sum of V W. At a slip
/// wall the shear along the wall is removed from the gradient; for sliding material only the component normal to the
/// wall remains.
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

/// Pair term for the sum over the wall in the velocity gradient, $\sum_d V_d [(u_d - u_i) \otimes \nabla W_{id} +
/// W_{id} G_d]$, with the StrainVelocity u_d and the SlipGradient G_d. At a slip wall the shear along the wall is
/// removed.
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

/// Pair term for the sum over the material $\sum_m V_m \sigma_m \nabla_d W_{dm}$ for slip walls, with the part of the
/// gradient along the wall.
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

/// Computes the stress of adami::ExtrapolateStress and the slip force, SlipForceSum divided by the sum of V W. At a
/// slip wall share_at_rest() multiplies the stress except its normal component across the wall, and one minus
/// share_at_rest() multiplies the slip force.
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

/// Lens through which the material reads the mirrored mean velocity and the mean stress. At a slip wall the stress is
/// changed so that its sum with the stress of i has no shear along the wall.
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

/// Pair term for the part of a slip wall in the divergence of the stress along the wall, $\sum_d V_d W_{id}
/// H_d/\rho_i$, with the slip force H_d.
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

/// Walls of dummy particles with the mean stress of the material in front of them, like AdamiWalls, that conserve the
/// energy of the material. The force of a wall on i is $\sum_d V_d \langle\sigma\rangle_d \nabla W_{id}$. The work of
/// this force is taken from the elastic energy if the velocity gradient at k contains $\sum_d V_d [(u_w(x_d) - u_k)
/// \otimes \nabla W_{kd} + W_{kd} G_d]$ with $G_d = \sum_m V_m u'_m \otimes \nabla_d W_{dm}/\sum_m V_m W_{dm}$ in place
/// of the difference from a mirrored velocity. This sum is exact for velocities that grow linearly with the distance
/// from the wall. At walls with a `slip_normal`, shear along the wall is removed from both stress and strain. If
/// material slides along such a wall, the strain rates follow from the velocity along the wall relative to the mean
/// velocity of the material, and the force along the wall contains the mean gradient of the stress. The stress then
/// acts only across the wall, and sliding material is not strained, however stiff it is; if the material is at rest, a
/// uniform stress persists in corners between walls. Energy is conserved with PlainStrain, the default, and with
/// ObjectiveStrain; CorrectedStrain uses the mirrored velocities of AdamiWalls. Granular uses ConservingWalls by
/// default.
struct ConservingWalls : ExtrapolatedWalls<adami::ExtrapolateStress> {
  double sliding_speed = 0.01;  ///< m/s: sliding along slip walls from this speed on, rest below half of this speed

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
