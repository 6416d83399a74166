// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "cells.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace scree::detail {

SCREE_BODY void check_spacing(double spacing) {
  if (!(spacing > 0) || !std::isfinite(spacing))
    throw std::invalid_argument("set-up: the spacing of particles must be positive, not " + std::to_string(spacing));
}
SCREE_BODY void check_rows(int rows) {
  if (rows < 1) throw std::invalid_argument("set-up: a wall needs at least one row, not " + std::to_string(rows));
}
SCREE_BODY void refuse_empty(char const* shape, std::initializer_list<double> extents, double spacing) {
  std::string size;
  for (double const extent : extents) size += (size.empty() ? "" : " x ") + short_text(extent);
  throw std::invalid_argument(
      formatted("set-up: a %s of %s m has no room for a particle: the spacing must be below "
                "its size, not %g m",
                shape, size.c_str(), spacing));
}
SCREE_BODY long rounded_count(double spacings) {
  if (!(std::abs(spacings) < 1e15))
    throw std::invalid_argument("set-up: a shape or its distance from the anchor measures " + short_text(spacings) +
                                " spacings of particles");
  return std::lround(spacings);
}

}  // namespace scree::detail
