// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "checks.hpp"

namespace scree::detail {

SCREE_BODY std::string fault_of_precision(double farthest, double spacing) {
  double const unit = farthest * double(std::numeric_limits<float>::epsilon());
  if (!(unit > coarsest_unit * spacing) || !std::isfinite(farthest)) return "";
  return formatted(
      "scree: single precision is too coarse for these positions: the largest coordinate is %.6g m, where neighbouring "
      "numbers are up to %.2g m apart, more than a thousandth of the spacing, %.6g m: coordinates may be up to %.4g m; "
      "move the origin to the middle of the case, or use double precision; if this is meant, set `start_checks = "
      "false`",
      farthest, unit, spacing, coarsest_unit * spacing / double(std::numeric_limits<float>::epsilon()));
}

SCREE_BODY void stop_for(std::string const& fault, long steps) {
  if (fault.empty()) return;
  if (steps == 0) throw std::invalid_argument(fault);
  throw OutsideValidity(fault + formatted("; after step %ld", steps));
}

SCREE_BODY std::string warning_of_packing(Packing const& found, double time, long steps) {
  return formatted(
      "scree: warning: after step %ld, at %.6g s, grains under pressure are packed %.3g times as densely as their "
      "volumes say, and %.3g times as densely as the spacing says (medians of sum V W; 0.85 to 1.1 is usual for one of "
      "them): depths and flow rates are %s than they should be; the volume control `FlowConsistency` ties the pressure "
      "to the packing (docs/choosing.md, volume control)",
      steps, time, found.density, found.by_number, found.by_number < 1 ? "larger" : "smaller");
}

}  // namespace scree::detail
