// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "shape.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

// Elementary shapes. Their signed distances are exact.
namespace scree {

namespace detail {
void check_length(bool good, char const* what, char const* allowed, double value);
}  // namespace detail

/// A disc in 2D, a sphere in 3D.
template <int Dim>
struct Ball {
  static constexpr int dim = Dim;
  static constexpr char const* name = "Ball";
  Vec<Dim, double> centre;  ///< m
  double radius = 0;        ///< m, above 0

  /// Throws std::invalid_argument if a parameter is out of its range.
  void check() const {
    detail::check_length(radius > 0, "the radius (m) of a Ball", "above 0", radius);
    detail::check_length(centre.allFinite(), "the centre (m) of a Ball", "finite", centre.sum());
  }
  double signed_distance(Vec<Dim, double> const& x) const { return (x - centre).norm() - radius; }
  bool contains(Vec<Dim, double> const& x) const { return signed_distance(x) < 0; }
  Box<Dim> bounds() const { return detail::grown(Box<Dim>{centre, centre}, radius); }
  Vec<Dim, double> outward_normal(Vec<Dim, double> const& x) const { return (x - centre).normalized(); }
};

/// A circular cylinder along a coordinate axis, between two planes perpendicular to it.
struct Cylinder {
  static constexpr int dim = 3;
  static constexpr char const* name = "Cylinder";
  int axis = 1;             ///< 0, 1 or 2
  Vec<3, double> centre;    ///< any point of the axis, m
  double radius = 0;        ///< m, above 0
  double from = 0, to = 0;  ///< coordinates of the planes along the axis, m; from < to

  double signed_distance(Vec<3, double> const& x) const {
    check_axis();
    double const along = std::max(from - x[axis], x[axis] - to), across = distance_from_axis(x) - radius;
    if (along > 0 && across > 0) return std::hypot(along, across);
    return std::max(along, across);
  }
  bool contains(Vec<3, double> const& x) const { return signed_distance(x) < 0; }
  Box<3> bounds() const;
  /// Throws std::invalid_argument if a parameter is out of its range.
  void check() const;

 private:
  void check_axis() const;
  double distance_from_axis(Vec<3, double> const& x) const {
    return std::hypot(x[(axis + 1) % 3] - centre[(axis + 1) % 3], x[(axis + 2) % 3] - centre[(axis + 2) % 3]);
  }
};

/// The half-space on the side of a plane opposite to its normal.
template <int Dim>
struct HalfSpace {
  static constexpr int dim = Dim;
  Vec<Dim, double> point;   ///< a point of the plane, m
  Vec<Dim, double> normal;  ///< pointing out of the shape, of any length above 0

  /// Throws std::invalid_argument if a parameter is out of its range.
  void check() const;
  double signed_distance(Vec<Dim, double> const& x) const;
  bool contains(Vec<Dim, double> const& x) const { return signed_distance(x) < 0; }
  /// Returns bounds that are finite on one side if the plane is perpendicular to an axis, and otherwise infinite.
  Box<Dim> bounds() const;
  Vec<Dim, double> outward_normal(Vec<Dim, double> const&) const { return normal.normalized(); }
};

template <int Dim>
void HalfSpace<Dim>::check() const {
  detail::check_length(normal.norm() > 0, "the length of the normal of a HalfSpace", "above 0", normal.norm());
  detail::check_length(point.allFinite(), "the point (m) of a HalfSpace", "finite", point.sum());
}
template <int Dim>
double HalfSpace<Dim>::signed_distance(Vec<Dim, double> const& x) const {
  return (x - point).dot(normal) / normal.norm();
}
template <int Dim>
Box<Dim> HalfSpace<Dim>::bounds() const {
  Box<Dim> box = whole_space<Dim>();
  for (int axis = 0; axis < Dim; ++axis) {
    if (std::abs(normal[axis]) != normal.norm()) continue;
    (normal[axis] > 0 ? box.high : box.low)[axis] = point[axis];
  }
  return box;
}

}  // namespace scree

#ifdef SCREE_COMPILED
SCREE_INSTANCE struct scree::HalfSpace<2>;
SCREE_INSTANCE struct scree::HalfSpace<3>;
#else
#include "primitives.ipp"
#endif
