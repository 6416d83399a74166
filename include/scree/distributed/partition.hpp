// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/span.hpp"
#include "../core/types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace scree {

/// The computational work in each cell of a uniform grid. Weights are integers, so that sums do not depend on the order
/// of summation.
template <int Dim>
struct CellWeights {
  Vec<Dim, double> origin = zero<Vec<Dim, double>>();  ///< the low corner, m
  double edge = 1;                                     ///< the edge length of a cell, m
  std::array<int, Dim> cells = {};                     ///< the number of cells along each axis
  std::vector<std::int64_t> weights;                   ///< weights of the cells; the first index runs fastest

  /// Returns a grid over a box (m) with cell edges of at least `edge` (m) and at most `most` cells. All weights are
  /// zero. Throws std::invalid_argument unless the edge is finite and above 0.
  static CellWeights over(Vec<Dim, double> const& low, Vec<Dim, double> const& high, double edge,
                          double most = 1 << 16) {
    check_setting(edge > 0 && std::isfinite(edge), "the edge of a cell (m)", edge, "above 0");
    CellWeights grid{low, edge, {}, {}};
    auto const along = [&](int axis) { return std::floor(std::max(high[axis] - low[axis], 0.0) / grid.edge) + 1; };
    for (;; grid.edge *= 2) {
      double count = 1;
      for (int axis = 0; axis < Dim; ++axis) count *= along(axis);
      if (count <= most) break;
    }
    std::size_t count = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      grid.cells[std::size_t(axis)] = static_cast<int>(along(axis));
      count *= std::size_t(grid.cells[std::size_t(axis)]);
    }
    grid.weights.assign(count, 0);
    return grid;
  }
};

/// A functor for kernels that returns the cell of a position; positions outside the grid belong to its outer cells.
template <int Dim>
struct CellOfPosition {
  double origin[Dim], edge;
  int cells[Dim];

  /// Uses the cells of a grid.
  explicit CellOfPosition(CellWeights<Dim> const& grid) : edge(grid.edge) {
    for (int axis = 0; axis < Dim; ++axis) {
      origin[axis] = grid.origin[axis];
      cells[axis] = grid.cells[std::size_t(axis)];
    }
  }
  template <class X>
  SCREE_FN int operator()(X const& x) const {
    int cell = 0;
    for (int axis = Dim - 1; axis >= 0; --axis) {
      double const place = Kokkos::floor((double(x[axis]) - origin[axis]) / edge);
      double const most = double(cells[axis] - 1);
      int const at = place >= 0 ? static_cast<int>(place < most ? place : most) : 0;  // 0 if not a number
      cell = cell * cells[axis] + at;
    }
    return cell;
  }
};

/// A division of space among ranks by a tree of planes. Work is taken to be spread evenly within a cell of the grid.
/// The outer ranks reach to infinity. A partition depends only on the grid, its weights, the number of ranks and the
/// axis of slabs.
template <int Dim>
class Partition {
 public:
  /// A node of the tree: positions below `cut` belong to the child `below`, the others to the child `above`. A child is
  /// the index of a plane, or -1 - rank.
  struct Plane {
    int axis = 0;
    double cut = 0;  ///< m
    int below = -1, above = -1;
  };

  /// Assigns all of space to rank 0.
  Partition() = default;
  /// Returns a partition by recursive coordinate bisection, which cuts boxes across their longest axis. The weights on
  /// both sides have the same ratio as the numbers of ranks there.
  static Partition bisection(CellWeights<Dim> const& grid, int ranks) { return {grid, ranks, -1}; }
  /// Returns a partition into slabs along an axis. Throws std::invalid_argument if the space does not have this axis.
  static Partition slabs(CellWeights<Dim> const& grid, int ranks, int axis) {
    check_setting(axis >= 0 && axis < Dim, "the axis of slabs", axis, "an axis of the space");
    return {grid, ranks, axis};
  }

  /// Returns the number of ranks among which space is divided.
  int ranks() const { return ranks_; }
  /// Returns the planes of the tree; the first one divides all of space.
  std::vector<Plane> const& planes() const { return planes_; }
  /// The rank that a position belongs to.
  template <class X>
  int owner(X const& x) const {
    return owner_of(Span<Plane const>(planes_.data(), static_cast<int>(planes_.size())), x);
  }
  /// Returns the rank that a position belongs to; for use in kernels.
  template <class X>
  SCREE_FN static int owner_of(Span<Plane const> const& planes, X const& x) {
    if (planes.size() == 0) return 0;
    int at = 0;
    while (at >= 0) {
      Plane const& plane = planes(at);
      at = double(x[plane.axis]) < plane.cut ? plane.below : plane.above;
    }
    return -1 - at;
  }

 private:
  struct Range {
    std::array<double, Dim> low, high;  // in units of the cell edge

    /// Returns the first cell along an axis; end() returns the one after the last.
    int first(std::size_t axis) const { return static_cast<int>(std::floor(low[axis])); }
    int end(std::size_t axis) const { return std::max(first(axis), static_cast<int>(std::ceil(high[axis]))); }
    /// Returns the fraction of a cell, along an axis, that is within the range.
    double part_of(int cell, std::size_t axis) const {
      return std::max(0.0, std::min(high[axis], cell + 1.0) - std::max(low[axis], double(cell)));
    }
  };

  Partition(CellWeights<Dim> const& grid, int ranks, int axis) : ranks_(ranks) {
    check_setting(ranks > 0, "the number of ranks", ranks, "1 or more");
    Range all = {};
    std::copy(grid.cells.begin(), grid.cells.end(), all.high.begin());
    divide(grid, all, 0, ranks, axis);
  }
  /// Divides a range among the ranks [first, first + count). Returns the index of the new plane, or -1 - rank for one
  /// rank.
  int divide(CellWeights<Dim> const& grid, Range const& range, int first, int count, int along) {
    if (count == 1) return -1 - first;
    int const axis = along >= 0 ? along : longest(range), half = count / 2;
    double const cut = place_of_cut(grid, range, std::size_t(axis), double(half) / count);
    auto const number = planes_.size();
    planes_.push_back({axis, grid.origin[axis] + cut * grid.edge});
    Range below = range, above = range;
    below.high[std::size_t(axis)] = above.low[std::size_t(axis)] = cut;
    int const child_below = divide(grid, below, first, half, along);
    int const child_above = divide(grid, above, first + half, count - half, along);
    planes_[number].below = child_below, planes_[number].above = child_above;
    return static_cast<int>(number);
  }
  static int longest(Range const& range) {
    std::size_t best = 0;
    for (std::size_t axis = 1; axis < Dim; ++axis)
      if (range.high[axis] - range.low[axis] > range.high[best] - range.low[best]) best = axis;
    return static_cast<int>(best);
  }
  /// Returns the coordinate of the plane below which a given fraction of the weight of a range lies.
  static double place_of_cut(CellWeights<Dim> const& grid, Range const& range, std::size_t axis, double fraction) {
    auto const layers = weights_along(grid, range, axis);
    double missing = fraction * std::accumulate(layers.begin(), layers.end(), 0.0);
    double cut = range.low[axis];
    for (std::size_t k = 0; k < layers.size() && missing > 0; ++k) {
      if (layers[k] == 0) continue;
      int const cell = range.first(axis) + static_cast<int>(k);
      cut = std::max(range.low[axis], double(cell)) + std::min(1.0, missing / layers[k]) * range.part_of(cell, axis);
      missing -= layers[k];
    }
    return cut;
  }
  /// Returns the weights of the layers of cells normal to an axis.
  static std::vector<double> weights_along(CellWeights<Dim> const& grid, Range const& range, std::size_t axis) {
    std::vector<double> layers(std::size_t(range.end(axis) - range.first(axis)), 0);
    std::array<int, Dim> at = {};
    for (std::size_t k = 0; k < Dim; ++k) {
      if (range.end(k) == range.first(k)) return layers;
      at[k] = range.first(k);
    }
    for (;;) {
      std::size_t cell = 0;
      double fraction = 1;
      for (std::size_t k = Dim; k-- > 0;) {
        cell = cell * std::size_t(grid.cells[k]) + std::size_t(at[k]);
        fraction *= range.part_of(at[k], k);
      }
      layers[std::size_t(at[axis] - range.first(axis))] += fraction * double(grid.weights[cell]);
      std::size_t k = 0;
      for (; k < Dim && ++at[k] == range.end(k); ++k) at[k] = range.first(k);
      if (k == Dim) return layers;
    }
  }

  int ranks_ = 1;
  std::vector<Plane> planes_;
};

/// Returns the largest load over the mean load, or 1 if all loads are zero.
inline double imbalance(std::vector<std::int64_t> const& loads) {
  std::int64_t const total = std::accumulate(loads.begin(), loads.end(), std::int64_t(0));
  if (total == 0) return 1;
  return double(*std::max_element(loads.begin(), loads.end())) * double(loads.size()) / double(total);
}

}  // namespace scree
