// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "shape.hpp"

#include <cmath>

namespace scree {

/// The section of a shape in space with the plane y = const, as a shape in the plane of x and z, for a two-dimensional
/// run with a body from a file. Its signed distance is that of the shape in space: exact where the shape does not
/// change along y over this distance; elsewhere, its magnitude is a lower bound.
template <Shape S>
requires(S::dim == 3) struct Section {
  static constexpr int dim = 2;
  static constexpr bool costly_distance = detail::is_costly<S>;
  S shape;       ///< the shape in space
  double y = 0;  ///< m

  void check() const {
    check_shape(shape);
    check_setting(std::isfinite(y), "the y (m) of a Section", y, "finite");
  }
  double signed_distance(Vec<2, double> const& x) const { return shape.signed_distance({x[0], y, x[1]}); }
  bool has_jumps() const { return detail::has_jumps(shape); }
  auto walk() const requires(costly_distance) {
    return [there = detail::walk(shape), y = y](Vec<2, double> const& x) mutable {
      return there(Vec<3, double>(x[0], y, x[1]));
    };
  }
  bool contains(Vec<2, double> const& x) const { return shape.contains({x[0], y, x[1]}); }
  /// Returns the bounds of the whole shape along x and z.
  Box<2> bounds() const {
    Box<3> const box = shape.bounds();
    return {{box.low[0], box.low[2]}, {box.high[0], box.high[2]}};
  }
};

/// Returns the section of a shape with the plane at y (m).
template <Shape S>
Section<S> section(S const& shape, double y) {
  return {shape, y};
}

}  // namespace scree
