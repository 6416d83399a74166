// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/standard.hpp"

#include <cmath>
#include <stdexcept>

namespace scree {
namespace detail {

/// Returns whether a plane through x (m, at time zero) with unit normal n keeps this normal during the motion, which is
/// sampled at times up to about 1000 s.
template <class Motion, class X>
bool keeps_normal(Motion const& motion, X const& x, X const& n) {
  for (double time = 1e-3; time < 1e3; time *= 1.7) {
    X const here = motion.displaced(x, 0.0, time);
    for (int axis = 0; axis < X::RowsAtCompileTime; ++axis) {
      X along = X::Zero();
      along[axis] = 1;
      along -= n * dot(n, along);
      X const there = motion.displaced(X(x + along), 0.0, time);
      if (!(std::abs(dot(n, X(there - here))) < 1e-6 * (1 + norm(x)))) return false;
    }
  }
  return true;
}

}  // namespace detail

/// Unit normal of a slip wall, zero where the wall is no-slip. The normal is fixed in space.
struct SlipNormal : Vector<"slip normal", "1"> {
  static constexpr bool may_stay_zero = true;

  /// Throws std::invalid_argument if the normal n of a wall particle, at x (m) at time zero, is neither zero nor a unit
  /// vector, or if the motion rotates the plane of the wall. Solver::set() calls this function.
  template <class Motion, class X>
  static void check_on_wall(Motion const& motion, X const& x, X const& n) {
    double const length = norm(n);
    auto const refuse = [&](char const* why) {
      throw std::invalid_argument(
          detail::formatted("scree: the wall particle that starts at (%.6g, ..., %.6g) m cannot slip: %s", x[0],
                            x[X::RowsAtCompileTime - 1], why));
    };
    if (!(length == 0 || std::abs(length - 1) < 1e-4)) refuse("its slip normal has neither length 0 nor length 1");
    if (length > 0 && !detail::keeps_normal(motion, x, n))
      refuse("slip normals are fixed in space, and the motion turns this wall");
  }
};

namespace fields {
inline constexpr SlipNormal slip_normal{};
}  // namespace fields

}  // namespace scree
