// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tree.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

// The generalised winding number (Jacobson, Kavan & Sorkine-Hornung 2013, ACM Trans. Graph. 32, 33) is the sum of the
// solid angles of all triangles over 4 pi. It is 1 inside and 0 outside of a closed surface, 2 where two closed
// surfaces overlap, and changes smoothly across a hole. Distant triangles contribute as a dipole at their centre with
// its first correction (Barill, Dickson, Schmidt, Levin & Jacobson 2018, ACM Trans. Graph. 37, 43), here with a bound
// on the error:
//
//   w(x) = integral of n . G(y - x) dA,  G(d) = d/(4 pi |d|^3)
//
// With y = p + s around the centre p of a node, d = p - x, R = |d|, r >= |s|, N = integral of n, T = integral of n s^T
// and J = integral of |s|^2,
//
//   w = N . G(d) + T : grad G(d) + error,        T : grad G(d) = (tr T - 3 d . T d/R^2)/(4 pi R^3)
//   |error| <= 6 J/(4 pi) integral of (1 - t)/(R - t r)^4 over t from 0 to 1
//
// by the remainder of Taylor's formula and |grad grad G| <= 6/(4 pi R^4).
namespace scree {

/// The winding numbers of a surface of triangles, computed with a tree, with bounds on their errors.
class WindingNumbers {
 public:
  struct Value {
    double number = 0;  ///< the winding number
    double error = 0;   ///< a bound on its error
  };

  /// Computes the moments of the nodes and triangles of a tree.
  explicit WindingNumbers(TriangleTree const& tree) : nodes_(tree.nodes().size()) {
    collect(tree, 0);
    for (int k = 0; k < tree.nodes()[0].last; ++k) triangles_.push_back(moments_of(tree, k, k + 1));
  }

  /// Returns the winding number at x. Nodes and triangles whose error bound is at most `each` contribute by their
  /// moments.
  Value at(TriangleTree const& tree, Vec<3, double> const& x, double each) const {
    Value sum;
    TriangleTree::Stack stack;
    stack.push(0, 0);
    while (!stack.empty()) {
      int const number = stack.pop().first;
      if (add(sum, nodes_[std::size_t(number)], x, each)) continue;
      auto const& node = tree.nodes()[std::size_t(number)];
      if (node.second == 0) {
        for (int k = node.first; k < node.last; ++k)
          if (!add(sum, triangles_[std::size_t(k)], x, each))
            sum.number += detail::solid_angle_share(tree.corners(k), x);
        continue;
      }
      stack.push(node.second, 0);
      stack.push(number + 1, 0);
    }
    return sum;
  }

  /// Returns the winding number at x. For a closed surface it is a whole number without an error. Otherwise its error
  /// is at most 0.25, and less near 1/2, where the sign of the distance changes.
  double operator()(TriangleTree const& tree, Vec<3, double> const& x, bool closed) const {
    if (closed) return std::round(refined(tree, x, [](Value const& v) { return v.error < 0.49; }).number);
    return refined(tree, x, [](Value const& v) { return v.error < 0.25 && v.error < std::abs(v.number - 0.5); }).number;
  }
  /// Returns the winding number of a closed surface at x; no value on the surface, where the sum is not a whole number.
  std::optional<double> off_surface(TriangleTree const& tree, Vec<3, double> const& x) const {
    constexpr double largest = 0.1;  // deviation from a whole number, and error
    Value const found = refined(tree, x, [](Value const& v) { return v.error < largest; });
    double const whole = std::round(found.number);
    if (std::abs(found.number - whole) > largest + found.error) return std::nullopt;
    return whole;
  }

 private:
  /// Returns the sum with ever smaller error bounds until `enough` accepts it; the exact sum if it never does.
  template <class Enough>
  Value refined(TriangleTree const& tree, Vec<3, double> const& x, Enough const& enough) const {
    for (double each = 2e-3; each > 1e-9; each /= 4)
      if (Value const found = at(tree, x, each); enough(found)) return found;
    return at(tree, x, 0);
  }
  /// The moments p (m) and r (m) of a node, and its N (m^2), T (m^3) and 6 J (m^4) over 4 pi.
  struct Moments {
    Vec<3, double> centre, area;
    Mat<3, double> first;
    double radius = 0, spread = 0;
  };

  static bool add(Value& sum, Moments const& m, Vec<3, double> const& x, double each) {
    Vec<3, double> const d = m.centre - x;
    double const squared = d.squaredNorm(), R = std::sqrt(squared), gap = R - m.radius;
    if (!(gap > 0.1 * R)) return false;
    double const cubed = squared * R;
    double const integral = (1 / (6 * sq(gap)) - 1 / (2 * squared) + gap / (3 * cubed)) / sq(m.radius);
    double const error = m.spread * integral;
    if (error > each) return false;
    double const correction = m.first.trace() - 3 * d.dot(Vec<3, double>(m.first * d)) / squared;
    sum.number += (m.area.dot(d) + correction) / cubed;
    sum.error += error;
    return true;
  }

  static Moments moments_of(TriangleTree const& tree, int first, int last) {
    Moments m{Vec<3, double>::Zero(), Vec<3, double>::Zero(), Mat<3, double>::Zero()};
    double total = 0;
    for (int k = first; k < last; ++k) {
      auto const& [a, b, c] = tree.corners(k);
      Vec<3, double> const area = area_of(tree.corners(k));
      double const size = area.norm();
      m.area += area, total += size, m.centre += size * (a + b + c) / 3;
    }
    m.centre /= total;
    for (int k = first; k < last; ++k) {
      auto const& [a, b, c] = tree.corners(k);
      Vec<3, double> const area = area_of(tree.corners(k)), middle = (a + b + c) / 3;
      m.first += area * (middle - m.centre).transpose();
      double own = 0;
      for (auto const& x : {a, b, c}) {
        own += (x - middle).squaredNorm() / 12;
        m.radius = std::max(m.radius, (x - m.centre).norm());
      }
      m.spread += area.norm() * ((middle - m.centre).squaredNorm() + own);
    }
    double const whole = 4 * std::numbers::pi;
    m.area /= whole, m.first /= whole, m.spread *= 6 / whole;
    return m;
  }
  static Vec<3, double> area_of(detail::Corners const& abc) {
    return Vec<3, double>(abc[1] - abc[0]).cross(Vec<3, double>(abc[2] - abc[0])) / 2;
  }

  /// Computes the moments of a node and of all nodes below it.
  void collect(TriangleTree const& tree, int number) {
    auto const& node = tree.nodes()[std::size_t(number)];
    nodes_[std::size_t(number)] = moments_of(tree, node.first, node.last);
    if (node.second == 0) return;
    collect(tree, number + 1);
    collect(tree, node.second);
  }

  std::vector<Moments> nodes_, triangles_;
};

}  // namespace scree
