// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "shape.hpp"

#include <cmath>

// Shapes composed of other shapes, of which they hold copies.
namespace scree {

/// Whether A and B are shapes of the same dimension.
template <class A, class B>
concept ShapesOfOneSpace = Shape<A> && Shape<B> && int(A::dim) == int(B::dim);

/// The union of two shapes. Its signed distance is exact outside if those of both shapes are; inside it is a lower
/// bound.
template <Shape A, Shape B>
struct Union {
  static constexpr int dim = A::dim;
  static constexpr bool costly_distance = detail::is_costly<A> || detail::is_costly<B>;
  A a;
  B b;
  void check() const { check_shape(a), check_shape(b); }
  double signed_distance(Vec<dim, double> const& x) const {
    return std::min(a.signed_distance(x), b.signed_distance(x));
  }
  bool has_jumps() const { return detail::has_jumps(a) || detail::has_jumps(b); }
  auto walk() const requires(costly_distance) {
    return [one = detail::walk(a), other = detail::walk(b)](Vec<dim, double> const& x) mutable {
      return std::min(one(x), other(x));
    };
  }
  bool contains(Vec<dim, double> const& x) const { return a.contains(x) || b.contains(x); }
  Box<dim> bounds() const { return detail::hull(a.bounds(), b.bounds()); }
};

/// The intersection of two shapes. Its signed distance is exact inside if those of both shapes are; outside it is a
/// lower bound.
template <Shape A, Shape B>
struct Intersection {
  static constexpr int dim = A::dim;
  static constexpr bool costly_distance = detail::is_costly<A> || detail::is_costly<B>;
  A a;
  B b;
  void check() const { check_shape(a), check_shape(b); }
  double signed_distance(Vec<dim, double> const& x) const {
    return std::max(a.signed_distance(x), b.signed_distance(x));
  }
  bool has_jumps() const { return detail::has_jumps(a) || detail::has_jumps(b); }
  auto walk() const requires(costly_distance) {
    return [one = detail::walk(a), other = detail::walk(b)](Vec<dim, double> const& x) mutable {
      return std::max(one(x), other(x));
    };
  }
  bool contains(Vec<dim, double> const& x) const { return a.contains(x) && b.contains(x); }
  Box<dim> bounds() const { return detail::overlap(a.bounds(), b.bounds()); }
};

/// The complement of a shape, without its boundary. Its signed distance is as exact as that of the shape. Its bounds
/// are infinite.
template <Shape A>
struct Complement {
  static constexpr int dim = A::dim;
  static constexpr bool costly_distance = detail::is_costly<A>;
  A a;
  void check() const { check_shape(a); }
  double signed_distance(Vec<dim, double> const& x) const { return -a.signed_distance(x); }
  bool has_jumps() const { return detail::has_jumps(a); }
  auto walk() const requires(costly_distance) {
    return [one = detail::walk(a)](Vec<dim, double> const& x) mutable { return -one(x); };
  }
  bool contains(Vec<dim, double> const& x) const { return signed_distance(x) < 0; }
  Box<dim> bounds() const { return whole_space<dim>(); }
};

/// A shape with its boundary moved outwards by a distance (m), or inwards if the distance is negative. The signed
/// distance is exact where the topology of the boundary does not change and no edge is rounded or sharpened; elsewhere
/// it is a lower bound.
template <Shape A>
struct Offset {
  static constexpr int dim = A::dim;
  static constexpr bool costly_distance = detail::is_costly<A>;
  A a;
  double distance = 0;  ///< m, outwards; negative: inwards
  void check() const {
    check_shape(a);
    check_setting(std::isfinite(distance), "the distance (m) of an Offset", distance, "finite");
    double const least = -Vec<dim, double>(a.bounds().high - a.bounds().low).minCoeff() / 2;
    check_setting(distance >= least, "the distance (m) of an Offset", distance,
                  ("at least " + detail::short_text(least) + ", minus half the extent of its shape").c_str());
  }
  double signed_distance(Vec<dim, double> const& x) const { return a.signed_distance(x) - distance; }
  bool has_jumps() const { return detail::has_jumps(a); }
  auto walk() const requires(costly_distance) {
    return [one = detail::walk(a), by = distance](Vec<dim, double> const& x) mutable { return one(x) - by; };
  }
  bool contains(Vec<dim, double> const& x) const { return signed_distance(x) < 0; }
  Box<dim> bounds() const { return detail::grown(a.bounds(), distance); }
};

/// Returns the union of two shapes: the points that are in a or in b.
template <class A, class B>
requires ShapesOfOneSpace<A, B> Union<A, B> unite(A const& a, B const& b) { return {a, b}; }
/// Returns the intersection of two shapes: the points that are in both a and b.
template <class A, class B>
requires ShapesOfOneSpace<A, B> Intersection<A, B> intersect(A const& a, B const& b) { return {a, b}; }
/// Returns the complement of a shape: the points that are not in a.
template <Shape A>
Complement<A> complement(A const& a) {
  return {a};
}
/// Returns the part of a that is not in b. The signed distance is computed as for an intersection.
template <class A, class B>
requires ShapesOfOneSpace<A, B> Intersection<A, Complement<B>> subtract(A const& a, B const& b) {
  return {a, complement(b)};
}
/// Returns the shape of all points closer to a than `distance` (m); a negative distance makes the shape smaller.
template <Shape A>
Offset<A> offset(A const& a, double distance) {
  return {a, distance};
}

template <class A, class B>
requires ShapesOfOneSpace<A, B> Union<A, B>
operator|(A const& a, B const& b) { return unite(a, b); }
template <class A, class B>
requires ShapesOfOneSpace<A, B> Intersection<A, B>
operator&(A const& a, B const& b) { return intersect(a, b); }
template <class A, class B>
requires ShapesOfOneSpace<A, B> Intersection<A, Complement<B>>
operator-(A const& a, B const& b) { return subtract(a, b); }

}  // namespace scree
