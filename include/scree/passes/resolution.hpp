// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"

namespace scree {

/// The lengths of a discretisation (in m unless noted) and the time step, from which a model makes its passes.
struct Resolution {
  int dimensions = 2;
  double spacing = 0;            ///< initial spacing of the particles
  double smoothing_length = 0;   ///< h
  double support = 0;            ///< radius of the kernel's support
  double lattice_sum = 1;        ///< sum of V W over the initial lattice, -
  double surface_asymmetry = 1;  ///< |h sum V gradW| for a particle on a plane surface, -
  long steps = 0;                ///< time steps taken so far
  double step = 0;               ///< time step of the update that uses the rates, s; 0: none, or unknown to the passes
  /// Whether rates from an earlier step are invalid because particles or fields were changed between steps.
  bool afresh = false;
};

/// Returns a number of steps between two occurrences. Throws std::invalid_argument if it is less than one.
inline int every_so_many(int steps) {
  check_setting(steps >= 1, "period (steps) of a filter or of a transport", steps, "1 or more");
  return steps;
}

}  // namespace scree
