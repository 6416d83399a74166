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

/// Acceleration of a particle by WallGuard.
struct GuardAcceleration : Vector<"guard acceleration", "m/s^2"> {};

namespace fields {
inline constexpr GuardAcceleration guard_acceleration{};
}  // namespace fields

namespace detail {

/// The kernel-weighted sum of wall velocities, $\sum_j V_j W_{ij} u_j$.
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

/// Computes the acceleration out of the wall for particles in whose support the share of walls exceeds `from`.
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

/// A force on a material that keeps single particles from passing through stepped walls: rows of wall particles on a
/// lattice along an inclined or curved surface. Stress follows from strain, so a particle without neighbours that
/// slides over steps may lose its pressure at each step and sink into the wall. The force of the guard depends on the
/// position: if the share of walls in the support exceeds `from`, it acts out of the wall like a damped spring,
///   a = speed/spacing (speed (share - from) + approach),
/// and stops particles that hit a wall at up to about half of `speed`. Set `speed` to twice the largest speed of such
/// particles, or leave it out to use the speed of sound, which the time step resolves; with a larger value particles
/// may oscillate. Next to a plane wall the share is 0.33 at half a spacing from the wall, 0.5 in the plane of the wall
/// and 0.7 at 0.4 spacings inside the wall. At half a spacing from each plane, it is 0.55 in an edge between two planes
/// and 0.7 in a corner. The force of the guard is not part of `wall_force`.
struct WallGuard {
  double speed = 0;   // m/s; 0: speed of sound of a law of constant stiffness
  double from = 0.7;  // -

  /// Returns this guard with `speed` set to the speed of sound c (m/s), unless a speed was given.
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
  /// Returns the pass that computes `guard_acceleration` from sums over the walls near each particle.
  template <class Rho>
  auto passes(Rho const&, Resolution const& resolution) const {
    return std::tuple(pair_pass_then<Material>("scree::wall_guard", detail::PushOut{speed, from, resolution.spacing},
                                               over<Wall>(KernelSums<Wall>{}, detail::WallMotionSum{})));
  }
  /// Returns the acceleration of a particle by the guard, m/s^2.
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    return i[fields::guard_acceleration];
  }
};

}  // namespace scree
