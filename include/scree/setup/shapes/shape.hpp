// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/setting.hpp"
#include "../../core/types.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <stdexcept>

namespace scree {

/// A block aligned with the axes, m. Its sides may be at infinity.
template <int Dim>
struct Box {
  static constexpr int dim = Dim;
  static constexpr char const* name = "Box";
  Vec<Dim, double> low;   ///< the corner with the lowest coordinates, m
  Vec<Dim, double> high;  ///< the opposite corner, m

  /// Throws std::invalid_argument unless the high corner is at or beyond the low one along each axis.
  void check() const {
    for (int axis = 0; axis < Dim; ++axis)
      if (!(high[axis] >= low[axis]))
        throw std::invalid_argument(
            detail::formatted("set-up: high[%d] (m) of a Box must be %g or more, as low[%d] is, "
                              "not %g",
                              axis, low[axis], axis, high[axis]));
  }
  bool contains(Vec<Dim, double> const& x) const {
    return (x.array() > low.array()).all() && (x.array() < high.array()).all();
  }
  /// Returns the exact signed distance of x, m.
  double signed_distance(Vec<Dim, double> const& x) const {
    Vec<Dim, double> const beyond = (low - x).cwiseMax(x - high);
    double const nearest = beyond.maxCoeff();
    return nearest > 0 ? beyond.cwiseMax(0.0).norm() : nearest;
  }
  Box bounds() const { return *this; }
};

/// A region of space, open (its boundary is not part of it):
///   dim                  the number of dimensions, 2 or 3
///   signed_distance(x)   the distance of x (m) from the boundary, negative inside, m; its magnitude never exceeds the
///                        true distance
///   contains(x)          whether x is inside: the signed distance is negative
///   bounds()             a box around the shape, m; infinite where the shape is
/// and optionally
///   outward_normal(x)    the unit vector along the gradient of the signed distance at x
///   costly_distance      whether fillings should avoid evaluations of the signed distance: they rely on its slope,
///                        which is at most one, and distribute the other evaluations over the threads of the host;
///                        signed_distance() must be thread-safe and must not start a Kokkos kernel
///   has_jumps()          whether the signed distance may change faster than with a slope of one, as at the holes of a
///                        mesh; fillings then avoid fewer evaluations
///   walk()               a function that returns signed_distance(x) and is faster if successive points are close
///   check()              throws std::invalid_argument if a parameter is out of its range; all functions that use a
///                        shape call it first
///   exact_volume_below(level)   the volume (m^dim) below a level of the last coordinate (m), a std::optional<double>
template <class S>
concept Shape = requires(S const& shape, Vec<S::dim, double> const& x) {
  { shape.signed_distance(x) } -> std::same_as<double>;
  { shape.contains(x) } -> std::same_as<bool>;
  { shape.bounds() } -> std::same_as<Box<S::dim>>;
};

/// Throws std::invalid_argument if a parameter of a shape, or of a part of it, is out of its range.
template <Shape S>
void check_shape(S const& shape) {
  if constexpr (requires { shape.check(); }) shape.check();
}

/// Returns all of space as a shape.
template <int Dim>
Box<Dim> whole_space() {
  double const infinity = std::numeric_limits<double>::infinity();
  return {Vec<Dim, double>::Constant(-infinity), Vec<Dim, double>::Constant(infinity)};
}

namespace detail {
/// Returns the intersection of two boxes; a box without extent if it is empty.
template <int Dim>
Box<Dim> overlap(Box<Dim> const& a, Box<Dim> const& b) {
  Box<Dim> both;  // element-wise code compiles faster
  for (int axis = 0; axis < Dim; ++axis) {
    both.low[axis] = std::max(a.low[axis], b.low[axis]);
    both.high[axis] = std::max(std::min(a.high[axis], b.high[axis]), both.low[axis]);
  }
  return both;
}
/// Returns the smallest box around two boxes.
template <int Dim>
Box<Dim> hull(Box<Dim> const& a, Box<Dim> const& b) {
  Box<Dim> both;
  for (int axis = 0; axis < Dim; ++axis) {
    both.low[axis] = std::min(a.low[axis], b.low[axis]);
    both.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return both;
}
/// Returns a box with every side moved outwards by a distance, m.
template <int Dim>
Box<Dim> grown(Box<Dim> const& box, double distance) {
  Box<Dim> larger;
  for (int axis = 0; axis < Dim; ++axis) {
    larger.low[axis] = box.low[axis] - distance;
    larger.high[axis] = box.high[axis] + distance;
  }
  return larger;
}

/// Whether a shape declares that its signed distance is costly.
template <class S>
inline constexpr bool is_costly = false;
template <class S>
requires(S::costly_distance) inline constexpr bool is_costly<S> = true;

template <Shape S>
bool has_jumps(S const& shape) {
  if constexpr (requires { shape.has_jumps(); })
    return shape.has_jumps();
  else
    return false;
}
/// Returns the signed distance from a shape (m) as a function that is called with successive points close to each
/// other. The function may refer to the shape; each thread needs its own.
template <class S>
auto walk(S const& shape) {
  if constexpr (requires { shape.walk(); })
    return shape.walk();
  else
    return [&shape](Vec<S::dim, double> const& x) { return shape.signed_distance(x); };
}

template <class S>
concept OffersNormal = requires(S const& shape, Vec<S::dim, double> const& x) {
  shape.outward_normal(x);
};

/// Returns the step of central differences, m: the largest length that occurs times the cube root of the rounding
/// error.
template <Shape S>
double difference_step(S const& shape, Vec<S::dim, double> const& x) {
  Box<S::dim> const box = shape.bounds();
  double length = x.cwiseAbs().maxCoeff();
  for (int axis = 0; axis < S::dim; ++axis)
    for (double const edge : {box.low[axis], box.high[axis]})
      if (std::isfinite(edge)) length = std::max(length, std::abs(edge));
  return 6e-6 * (length > 0 ? length : 1);
}
}  // namespace detail

/// Returns the normalised gradient of the signed distance at x; zero where it is undefined, as in the middle of a
/// shape.
template <Shape S>
Vec<S::dim, double> outward_normal(S const& shape, Vec<S::dim, double> const& x) {
  if constexpr (detail::OffersNormal<S>) {
    return shape.outward_normal(x);
  } else {
    double const step = detail::difference_step(shape, x);
    Vec<S::dim, double> gradient;
    for (int axis = 0; axis < S::dim; ++axis) {
      Vec<S::dim, double> const by = step * Vec<S::dim, double>::Unit(axis);
      gradient[axis] = (shape.signed_distance(x + by) - shape.signed_distance(x - by)) / (2 * step);
    }
    // The gradient has length one, except where several parts of the boundary are equally near: there only rounding
    // errors remain.
    return gradient.norm() > 1e-3 ? gradient.normalized() : Vec<S::dim, double>::Zero();
  }
}

}  // namespace scree
