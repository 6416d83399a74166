// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "primitives.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace scree {
namespace detail {
SCREE_BODY void check_length(bool good, char const* what, char const* allowed, double value) {
  if (!good || !std::isfinite(value))
    throw std::invalid_argument(formatted("set-up: %s must be %s, not %g", what, allowed, value));
}
}  // namespace detail

SCREE_BODY Box<3> Cylinder::bounds() const {
  check_axis();
  Box<3> box = detail::grown(Box<3>{centre, centre}, radius);
  box.low[axis] = from;
  box.high[axis] = to;
  return box;
}
SCREE_BODY void Cylinder::check() const {
  check_axis();
  detail::check_length(radius > 0, "the radius (m) of a Cylinder", "above 0", radius);
  detail::check_length(std::isfinite(from), "the first end (m) of a Cylinder, `from`,", "finite", from);
  detail::check_length(to > from, "the second end (m) of a Cylinder, `to`,", "above the first one, `from`", to);
  detail::check_length(centre.allFinite(), "the centre (m) of a Cylinder", "finite", centre.sum());
}
SCREE_BODY void Cylinder::check_axis() const {
  if (axis < 0 || axis > 2)
    throw std::invalid_argument("set-up: the axis of a cylinder is 0, 1 or 2, not " + std::to_string(axis));
}

}  // namespace scree
