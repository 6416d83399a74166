// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/types.hpp"

namespace scree {

/// The unit vector along gravity; zero without gravity.
struct GravityDirection {
  double first = 0, last = -1;  ///< components along the first and the last coordinate, -

  /// Returns the component of a vector along gravity.
  template <class X>
  SCREE_FN typename X::Scalar component(X const& x) const {
    using Real = typename X::Scalar;
    return Real(first) * x[0] + Real(last) * x[X::RowsAtCompileTime - 1];
  }
};

/// Gravity, which acts downwards, against the last coordinate. For slopes, its direction is inclined from there towards
/// the first coordinate.
struct Gravity {
  double magnitude = 9.81;  ///< m/s^2, 0 or more; for upward gravity set the inclination to pi
  double inclination = 0;   ///< rad, from -pi to pi

  bool operator==(Gravity const&) const = default;
  static constexpr auto parameters() {
    constexpr double half_turn = 3.141592653589794;  // pi and its rounding
    return std::array{
        parameter("magnitude", &Gravity::magnitude, "m/s^2", "acceleration of gravity",
                  allowed::at_least(0, "0 or more, because it acts downwards already")),
        parameter(
            "inclination", &Gravity::inclination, "rad", "angle from the vertical towards the first coordinate",
            ParameterRange{-half_turn, half_turn, false, false, "from -pi to pi, in radians and not in degrees"})};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "Gravity"); }
  /// Whether gravity acts upwards, as it may if the inclination was given in degrees.
  bool acts_upwards() const { return magnitude > 0 && Kokkos::cos(inclination) < -1e-9; }
  /// Returns the acceleration of gravity, m/s^2, as a vector of type X.
  template <class X>
  SCREE_FN X vector() const {
    using Real = typename X::Scalar;
    X g = zero<X>();
    g[0] = Real(magnitude * Kokkos::sin(inclination));
    g[X::RowsAtCompileTime - 1] = Real(-magnitude * Kokkos::cos(inclination));
    return g;
  }
  /// Returns the unit vector along gravity; zero without gravity.
  GravityDirection direction() const {
    double const sign = magnitude > 0 ? 1 : magnitude < 0 ? -1 : 0;
    return {sign * Kokkos::sin(inclination), -sign * Kokkos::cos(inclination)};
  }
};

namespace detail {
template <class Physics>
concept HasGravity = requires(Physics const& physics) {
  physics.gravity;
};
}  // namespace detail

/// Returns the gravity of a physics model or of the mechanics of a combined model.
template <class Physics>
Gravity const& gravity_of(Physics const& physics) {
  if constexpr (requires { physics.mechanics; })
    return gravity_of(physics.mechanics);
  else
    return physics.gravity;
}

}  // namespace scree
