// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "experiments.hpp"
#include "options.hpp"

#include <algorithm>

namespace column_collapse {

/// End of the floor in L0: as given, or twice the largest run-out of the experiments, at least 6.
inline double floor_reach(Options const& o) {
  double const a = o.geometry.aspect;
  double const farthest = (o.numerics.dimension == 2 ? run_out_in_channels(a) : run_out_of_cylinders(a)).greatest;
  return o.numerics.reach.value_or(std::max(6.0, 1 + 2 * farthest));
}

}  // namespace column_collapse
