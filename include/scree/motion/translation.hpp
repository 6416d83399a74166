// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

namespace scree {

/// A translation of all points with the velocity u = speed + growth t.
template <int Dim>
struct Translation {
  static constexpr int dim = Dim;
  Vec<Dim, double> speed = Vec<Dim, double>::Zero();   ///< velocity at time zero, m/s
  Vec<Dim, double> growth = Vec<Dim, double>::Zero();  ///< acceleration, m/s^2

  static constexpr auto parameters() {
    return std::array{
        parameter("speed", &Translation::speed, "m/s", "velocity at time zero", allowed::finite()),
        parameter("growth", &Translation::growth, "m/s^2", "growth of the velocity in time", allowed::finite())};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "Translation"); }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    Vec<Dim, double> const by = speed * (to - from) + growth * ((to - from) * (to + from) / 2);
    return x + by.template cast<typename X::Scalar>();
  }
  template <class X>
  SCREE_FN X velocity(X const&, double time) const {
    return (speed + growth * time).template cast<typename X::Scalar>();
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return growth.template cast<typename X::Scalar>();
  }
  /// Returns infinity: the motion is exact at any time step, and the limits of the physics model cover the response of
  /// the material.
  double time_step() const { return Kokkos::Experimental::infinity_v<double>; }
};

}  // namespace scree
