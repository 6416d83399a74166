// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

namespace scree {

/// A motion that begins at a given time and may end at a later time. The time of the delayed motion is counted from its
/// beginning. Before and after the motion, all points are at rest, so the velocity may jump; Tabulated starts and stops
/// smoothly.
template <class Motion>
struct Delayed {
  Motion motion = {};                                      ///< the motion that begins later
  double start = 0;                                        ///< s
  double stop = Kokkos::Experimental::infinity_v<double>;  ///< s, not before `start`

  /// Returns the parameters `start` and `stop`; those of the delayed motion are declared by its class.
  static constexpr auto parameters() {
    return std::array{parameter("start", &Delayed::start, "s", "begin of the motion", allowed::finite()),
                      parameter("stop", &Delayed::stop, "s", "end of the motion",
                                ParameterRange{-allowed::infinity, allowed::infinity, false, false, "start or later"})};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_settings_of(motion);
    check_parameters(*this, "Delayed");
    check_setting(stop >= start, "stop (s) of Delayed", stop, "start or later");
  }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return motion.displaced(x, since_start(from), since_start(to));
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double time) const {
    return moves_at(time) ? X(motion.velocity(x, time - start)) : zero<X>();
  }
  template <class X>
  SCREE_FN X acceleration(X const& x, double time) const {
    return moves_at(time) ? X(motion.acceleration(x, time - start)) : zero<X>();
  }
  template <class X>
  requires GivesVelocityGradient<Motion, X::RowsAtCompileTime, typename X::Scalar> SCREE_FN auto velocity_gradient(
      X const& x, double time) const {
    using Gradient = Mat<X::RowsAtCompileTime, typename X::Scalar>;
    return moves_at(time) ? Gradient(motion.velocity_gradient(x, time - start)) : zero<Gradient>();
  }
  double time_step() const { return motion.time_step(); }

 private:
  SCREE_FN bool moves_at(double time) const { return time >= start && time < stop; }
  /// Returns the time for which the motion has been in progress, s.
  SCREE_FN double since_start(double time) const { return Kokkos::max(0.0, Kokkos::min(time, stop) - start); }
};

}  // namespace scree
