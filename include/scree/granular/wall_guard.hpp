// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/parameter.hpp"
#include "../passes/pass.hpp"
#include "../passes/resolution.hpp"
#include "../terms/kernel_sums.hpp"

#include <array>
#include <tuple>

namespace scree {

/// Acceleration by WallGuard.
struct GuardAcceleration : Vector<"guard acceleration", "m/s^2"> {};

namespace fields {
inline constexpr GuardAcceleration guard_acceleration{};
}  // namespace fields

namespace detail {

/// $\sum_j V_j W_{ij} u_j$ over walls.
struct WallMotion : Vector<"wall motion", "m/s"> {};
struct WallMotionSum {
  using reads = Fields<Volume, Velocity>;
  using adds = Fields<WallMotion>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[WallMotion{}] += (j[volume] * ij.W()) * j[velocity];
  }
};

/// Out of the wall, where its share of the support is above `from`.
struct PushOut {
  double speed, from, spacing;  // m/s, -, m
  using reads = Fields<Velocity>;
  using writes = Fields<GuardAcceleration>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    using X = std::remove_cvref_t<decltype(i[velocity])>;
    using Real = typename X::Scalar;
    out[guard_acceleration] = zero<X>();
    Real const share = total[kernel_sum<Wall>], deep = share - Real(from);
    if (!(deep > 0)) return;
    X const inward = math::unit_vector(X(total[kernel_gradient<Wall>]));
    Real const approach = dot(X(i[velocity] - total[WallMotion{}] / share), inward);
    Real const rate = Real(speed / spacing);
    out[guard_acceleration] = -Kokkos::max(Real(0), rate * (Real(speed) * deep + approach)) * inward;
  }
};

}  // namespace detail

/// A force on a material that keeps single grains from passing through walls with steps: rows of wall particles on a
/// lattice along an inclined or curved surface. Stress follows from strain, so that a grain without neighbours that
/// slides over steps may lose its pressure at each of them and sink. This force depends on the position: where walls
/// have more than the share `from` of the support, it acts out of them, like a damped spring,
///   a = speed/spacing (speed (share - from) + approach),
/// and stops grains that hit a wall at up to about half of `speed`: give twice their largest speed, or leave it out for
/// the speed of sound, which the step resolves; above that it may shake grains. On a plane the share is 0.33 at half a
/// spacing from the wall, 0.5 in the plane and 0.7 at 0.4 spacings within; in an edge between two planes 0.55 and in a
/// corner 0.7, at half a spacing from each. It is not part of `wall_force`.
struct WallGuard {
  double speed = 0;   // m/s; 0: the speed of sound of a law of constant stiffness
  double from = 0.7;  // -

  /// Returns this guard with the speed of sound c (m/s) as its speed, unless a speed was given.
  WallGuard with_sound_speed(double c) const { return {speed == 0 ? c : speed, from}; }

  static constexpr auto parameters() {
    return std::array{
        parameter("speed", &WallGuard::speed, "m/s", "stiffness of the guard as a speed, up to the speed of sound",
                  allowed::above(0, "above 0, or left out where the stiffness of the law is constant")),
        parameter("from", &WallGuard::from, "1", "share of walls in the support above which it acts",
                  allowed::from_to(0.5, 0.9))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "WallGuard"); }
  using reads = Fields<GuardAcceleration>;
  /// The pass over the walls near each particle that computes `guard_acceleration`.
  template <class Rho>
  auto passes(Rho const&, Resolution const& resolution) const {
    return std::tuple(pair_pass_then<Material>("scree::wall_guard", detail::PushOut{speed, from, resolution.spacing},
                                               over<Wall>(KernelSums<Wall>{}, detail::WallMotionSum{})));
  }
  /// The acceleration of a particle by the guard, m/s^2.
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    return i[fields::guard_acceleration];
  }
};

}  // namespace scree
