// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <utility>

namespace scree {

/// Agreement of the parts of a case, for a case whose particles are all here.
struct OnePart {
  /// The largest of a number over all parts.
  double largest(double here) const { return here; }
  /// Frames of grids (neighbours/grid.hpp) that contain the particles of all parts.
  template <class Frames>
  void join(Frames&) const {}
  /// The result of survey() over all parts, and their number of particles. The number of the particle with a largest
  /// value is detail::no_particle on other parts.
  template <class Found>
  std::pair<Found, long> joined(Found const& here, long particles) const {
    return {here, particles};
  }
};

}  // namespace scree
