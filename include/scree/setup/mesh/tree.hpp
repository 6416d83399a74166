// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../shapes/shape.hpp"
#include "triangle.hpp"
#include "triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace scree {

/// A point of a surface and its triangle, as an index into `Triangles`; -1 if there is none.
struct SurfacePoint {
  int triangle = -1;
  double distance = std::numeric_limits<double>::infinity();  ///< m
  Vec<3, double> point = Vec<3, double>::Zero();              ///< m
};

/// A tree of boxes around triangles. Each node is divided into halves at the median along the longest side of its box.
class TriangleTree {
 public:
  struct Node {
    Vec<3, double> low, high;  ///< the box, m
    int first = 0, last = 0;   ///< its triangles, in the order of the tree
    int second = 0;            ///< second child; the first one is the next node. 0: a leaf
  };
  static constexpr int leaf_size = 4;

  /// Builds the tree of the triangles of a mesh.
  explicit TriangleTree(Triangles const& mesh) : places_(mesh.size()) {
    std::iota(places_.begin(), places_.end(), 0);
    std::vector<Vec<3, double>> middles;
    for (std::size_t t = 0; t < mesh.size(); ++t)
      middles.push_back((mesh.vertex(t, 0) + mesh.vertex(t, 1) + mesh.vertex(t, 2)) / 3);
    nodes_.reserve(mesh.size());
    build(mesh, middles, 0, int(mesh.size()));
    for (int const t : places_) {
      corners_.push_back(
          {mesh.vertex(std::size_t(t), 0), mesh.vertex(std::size_t(t), 1), mesh.vertex(std::size_t(t), 2)});
      normals_.push_back(detail::certain_normal(corners_.back()));
    }
    rounding_ = sq(2e-9 * extent());
  }

  /// Returns all nodes; the first one has the box around all triangles.
  std::vector<Node> const& nodes() const { return nodes_; }
  /// Returns the largest side of the box around all triangles, m.
  double extent() const { return (nodes_[0].high - nodes_[0].low).maxCoeff(); }
  /// Returns the corners of the triangle with this number in the order of the tree, m.
  detail::Corners const& corners(int in_order) const { return corners_[std::size_t(in_order)]; }
  /// Returns the place in `Triangles` of the triangle with this number in the order of the tree.
  int place(int in_order) const { return places_[std::size_t(in_order)]; }

  /// Returns the point of the surface that is nearest to x. It is found faster if it is known to be within a distance
  /// (m).
  SurfacePoint nearest(Vec<3, double> const& x, double within = std::numeric_limits<double>::infinity()) const {
    SurfacePoint best;
    double least =
        sq(within) * (1 + 1e-9);  // squared distance, with a margin so that a point at exactly this distance is found
    Stack stack;
    stack.push(0, squared_distance(nodes_[0], x));
    while (!stack.empty()) {
      auto const [number, squared] = stack.pop();
      if (squared >= least) continue;
      Node const& node = nodes_[std::size_t(number)];
      if (node.second == 0) {
        for (int k = node.first; k < node.last; ++k) {
          double const from_plane = normals_[std::size_t(k)].dot(x - corners(k)[0]);
          if (sq(from_plane) > least * (1 + 1e-6) + rounding_) continue;
          Vec<3, double> const there = detail::nearest_in_triangle(corners(k), x);
          double const found = (there - x).squaredNorm();
          if (found < least) least = found, best.triangle = k, best.point = there;
        }
        continue;
      }
      double const one = squared_distance(nodes_[std::size_t(number) + 1], x);
      double const other = squared_distance(nodes_[std::size_t(node.second)], x);
      bool const in_order = one <= other;  // the nearer child is visited first
      stack.push(in_order ? node.second : number + 1, std::max(one, other));
      stack.push(in_order ? number + 1 : node.second, std::min(one, other));
    }
    if (best.triangle < 0) return nearest(x);  // the distance was too short
    best.distance = std::sqrt(least);
    best.triangle = place(best.triangle);
    return best;
  }

  /// Returns the nearest triangle along a ray with the unit vector `along`, at a distance between `least` and `most`
  /// (m), for which accept(triangle) is true.
  template <class Accept>
  SurfacePoint first_along(Vec<3, double> const& from, Vec<3, double> const& along, double least, double most,
                           Accept const& accept) const {
    SurfacePoint best{.distance = most};
    Stack stack;
    stack.push(0, 0);
    while (!stack.empty()) {
      auto const [number, entry] = stack.pop();
      if (entry >= best.distance) continue;
      Node const& node = nodes_[std::size_t(number)];
      if (node.second == 0) {
        for (int k = node.first; k < node.last; ++k) {
          double const t = detail::distance_along_ray(corners(k), from, along);
          if (t > least && t < best.distance && accept(place(k))) best = {place(k), t, from + t * along};
        }
        continue;
      }
      double const one = entry_of(nodes_[std::size_t(number) + 1], from, along);
      double const other = entry_of(nodes_[std::size_t(node.second)], from, along);
      bool const in_order = one <= other;
      stack.push(in_order ? node.second : number + 1, std::max(one, other));
      stack.push(in_order ? number + 1 : node.second, std::min(one, other));
    }
    return best;
  }

  /// Returns how many times a segment passes through the surface against the normals, minus how many times along them;
  /// no value if this is uncertain for a triangle (detail::passes()).
  std::optional<int> entries(Vec<3, double> const& from, Vec<3, double> const& to, double margin) const {
    int count = 0;
    bool const certain = visit_box(detail::grown(Box<3>{from.cwiseMin(to), from.cwiseMax(to)}, margin), [&](int k) {
      auto const passed = detail::passes(corners(k), from, to, margin);
      count += passed.value_or(0);
      return passed.has_value();
    });
    return certain ? std::optional(count) : std::nullopt;
  }
  /// Calls visit(k) for the triangles of all leaves whose boxes meet a box (m), in the order of the tree, until a call
  /// returns false. Returns false if a call did, otherwise true.
  template <class Visit>
  bool visit_box(Box<3> const& box, Visit const& visit) const {
    Stack stack;
    stack.push(0, 0);
    while (!stack.empty()) {
      int const number = stack.pop().first;
      Node const& node = nodes_[std::size_t(number)];
      if ((node.low.array() > box.high.array()).any() || (node.high.array() < box.low.array()).any()) continue;
      if (node.second == 0) {
        for (int k = node.first; k < node.last; ++k)
          if (!visit(k)) return false;
        continue;
      }
      stack.push(node.second, 0);
      stack.push(number + 1, 0);
    }
    return true;
  }

  /// A stack of nodes that remain to be visited. A tree of N triangles is at most log2(N) + 1 <= 32 deep.
  class Stack {
   public:
    /// Whether no node is left.
    bool empty() const { return size_ == 0; }
    /// Adds a node with a value, such as its distance.
    void push(int node, double value) { entries_[size_++] = {node, value}; }
    /// Removes the node that was added last, and returns it with its value.
    std::pair<int, double> pop() { return entries_[--size_]; }

   private:
    std::array<std::pair<int, double>, 64> entries_;
    std::size_t size_ = 0;
  };

 private:
  int build(Triangles const& mesh, std::vector<Vec<3, double>> const& middles, int first, int last) {
    int const number = int(nodes_.size());
    auto const infinity = Vec<3, double>::Constant(std::numeric_limits<double>::infinity());
    Node node{infinity, -infinity, first, last, 0};
    for (int k = first; k < last; ++k)
      for (std::size_t corner = 0; corner < 3; ++corner) {
        auto const& x = mesh.vertex(std::size_t(place(k)), corner);
        node.low = node.low.cwiseMin(x), node.high = node.high.cwiseMax(x);
      }
    nodes_.push_back(node);
    if (last - first <= leaf_size) return number;
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    int const middle = first + (last - first) / 2;
    auto const at = places_.begin();
    std::nth_element(at + first, at + middle, at + last,
                     [&](int a, int b) { return middles[std::size_t(a)][axis] < middles[std::size_t(b)][axis]; });
    build(mesh, middles, first, middle);
    int const second = build(mesh, middles, middle, last);
    nodes_[std::size_t(number)].second = second;
    return number;
  }
  static double squared_distance(Node const& node, Vec<3, double> const& x) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
      sum += sq(std::max(std::max(node.low[axis] - x[axis], x[axis] - node.high[axis]), 0.0));
    return sum;
  }
  /// Returns the distance at which a ray enters a box; infinity if it misses the box.
  static double entry_of(Node const& node, Vec<3, double> const& from, Vec<3, double> const& along) {
    double entry = 0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      double one = (node.low[axis] - from[axis]) / along[axis], other = (node.high[axis] - from[axis]) / along[axis];
      if (one > other) std::swap(one, other);
      if (one > entry) entry = one;  // false for a NaN: the ray runs within a side of the box
      if (other < leave) leave = other;
    }
    return entry <= leave * (1 + 1e-14) ? entry : std::numeric_limits<double>::infinity();
  }

  std::vector<int> places_;
  std::vector<detail::Corners> corners_;
  std::vector<Vec<3, double>> normals_;  // of length one, or zero
  double rounding_ = 0;                  // rounding error of a squared distance, m^2
  std::vector<Node> nodes_;
};

}  // namespace scree
