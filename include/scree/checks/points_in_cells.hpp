// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// Points on the host, sorted by the cells of a grid, for checks of positions.
namespace scree::detail {

/// The indices of a cell of a grid.
using CellIndex = std::array<std::int64_t, 3>;
/// Whether two cells are the same; the operator == of arrays would call a function that compares bytes.
inline bool is_same(CellIndex const& a, CellIndex const& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

/// The cells of a grid, numbered in the order in which they were added, and found by a hash.
class CellNumbers {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  CellNumbers() : slots_(64, 0) {}
  std::size_t size() const { return cells_.size(); }
  /// Returns the number of a cell, which is added if it is new.
  std::size_t add(CellIndex const& cell);
  /// Returns the number of a cell; `none` if it was not added.
  std::size_t find(CellIndex const& cell) const { return slots_[place_of(cell)] - 1; }

 private:
  std::size_t place_of(CellIndex const& cell) const;
  void grow();

  std::vector<CellIndex> cells_;
  std::vector<std::size_t> slots_;  // the number of a cell + 1, or 0
};

/// Points sorted by cells. Within a cell, they are in ascending order of their numbers.
class PointsInCells {
 public:
  using Point = std::array<double, 3>;
  struct Numbered {
    Point x;
    std::size_t number;
  };
  /// A box around points.
  struct Hull {
    Point low, high;
    Hull() { low.fill(std::numeric_limits<double>::infinity()), high.fill(-low[0]); }
    void add(Point const& x) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        low[axis] = std::min(low[axis], x[axis]), high[axis] = std::max(high[axis], x[axis]);
    }
    double squared_distance(Point const& x) const;
  };

  /// Sorts the points numbered from `first` up to, but not including, `last`; only those in the cells `some`, if given.
  PointsInCells(std::vector<Point> const& points, std::size_t first, std::size_t last, double width,
                CellNumbers const* some = nullptr);

  /// Returns the cell of a point, m. Positions that are not finite, or too far away for an index, are treated as very
  /// far.
  static CellIndex cell_of(Point const& x, double width);
  static double squared_distance(Point const& a, Point const& b) {
    double const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
  }
  /// Returns the number of cells with points.
  std::size_t size() const { return cells_.size(); }
  Numbered const* begin(std::size_t cell) const { return sorted_.data() + starts_[cell]; }
  Numbered const* end(std::size_t cell) const { return sorted_.data() + starts_[cell + 1]; }
  Hull hull_of(std::size_t cell) const;
  /// Adds to `found` each point, displaced by `shift` (m), that is nearer to a box than `reach` (m).
  void add_near(Hull const& box, double reach, Point const& shift, std::vector<Numbered>& found) const;
  /// Returns all cells that are nearer than `reach` (m) to one of the points, and perhaps others.
  CellNumbers cells_near(double reach) const;

 private:
  template <class Visit>
  static void visit_cells(Point const& low, Point const& high, double width, Visit const& visit) {
    CellIndex const first = cell_of(low, width), last = cell_of(high, width);
    CellIndex cell;
    for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0])
      for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1])
        for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) visit(cell);
  }

  double width_;
  CellNumbers cells_;
  std::vector<std::size_t> starts_;
  std::vector<Numbered> sorted_;
  Hull hull_;  // of all points
};

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "points_in_cells.ipp"
#endif
