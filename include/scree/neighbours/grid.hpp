// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/loop.hpp"
#include "neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// A uniform grid of cells over the particles of one body.
namespace scree {

/// A uniform grid that maps positions to cells. Cell numbers increase fastest along the first axis, along which cells
/// may be smaller than along the other axes.
template <int Dim, class Real>
struct Grid {
  Vec<Dim, Real> origin = zero<Vec<Dim, Real>>();  ///< the low corner of the cell with coordinates 0, m
  Vec<Dim, Real> edges = Vec<Dim, Real>::Ones();   ///< the edge lengths of a cell, m
  int cells[Dim] = {};                             ///< number of cells along each axis
  int first[Dim] = {};                             ///< coordinates of the first cell, counted from the origin
  int parts = 1;                                   ///< edge along the other axes / edge along the first axis
  Real slack = 0;                                  ///< for rounding, added to squared distances in edges

  /// Returns the number of cells.
  int size() const {
    int product = 1;
    for (int count : cells) product *= count;
    return product;
  }
  /// Returns the cell coordinate of a position along one axis. A position outside the grid, at any distance, gives -1
  /// or cells[axis].
  SCREE_FN int coordinate(Vec<Dim, Real> const& x, int axis) const {
    Real const place = Kokkos::floor((x[axis] - origin[axis]) / edges[axis]) - Real(first[axis]);
    if (!(place >= 0)) return -1;
    return place < Real(cells[axis]) ? static_cast<int>(place) : cells[axis];
  }
  /// Returns the index of the cell that contains a position inside the grid.
  SCREE_FN int index(Vec<Dim, Real> const& x) const {
    int result = 0;
    for (int axis = Dim - 1; axis >= 0; --axis) result = result * cells[axis] + coordinate(x, axis);
    return result;
  }
  /// Returns the centre of the cell that contains a position inside the grid. The distance from the centre to each
  /// adjacent cell is less than one edge.
  SCREE_FN Vec<Dim, Real> centre(Vec<Dim, Real> const& x) const {
    Vec<Dim, Real> result = origin;
    for (int axis = 0; axis < Dim; ++axis)
      result[axis] += (Real(coordinate(x, axis) + first[axis]) + Real(0.5)) * edges[axis];
    return result;
  }
  /// Calls f(first, last) for runs of cells along the first axis, from `first` to `last`, both included. Together,
  /// these cells contain all positions within one edge length (of the other axes) of x.
  template <class F>
  SCREE_FN void for_each_row_around(Vec<Dim, Real> const& x, F const& f) const {
    Real place[Dim];
    int low[Dim], high[Dim], at[Dim];
    for (int axis = 0; axis < Dim; ++axis) {
      place[axis] = (x[axis] - origin[axis]) / edges[axis] - Real(first[axis]);
      int const centre = coordinate(x, axis), reach = axis == 0 ? parts : 1;
      low[axis] = Kokkos::max(centre - reach, 0);
      high[axis] = Kokkos::min(centre + reach, cells[axis] - 1);
      if (low[axis] > high[axis]) return;
      at[axis] = low[axis];
    }
    for (;;) {
      int row = 0;
      Real left = 1 + slack;  // what is left of the squared edge
      for (int axis = Dim - 1; axis > 0; --axis) {
        row = (row + at[axis]) * cells[axis - 1];
        left -= sq(gap(place[axis], at[axis]));
      }
      if (left > 0) {
        Real const half = Real(parts) * Kokkos::sqrt(left);
        Real const from = Kokkos::max(place[0] - half, Real(low[0]));
        Real const to = Kokkos::min(place[0] + half, Real(high[0] + 1));
        if (from < to) f(row + static_cast<int>(from), row + Kokkos::min(static_cast<int>(to), high[0]));
      }
      int axis = 1;
      for (; axis < Dim && ++at[axis] > high[axis]; ++axis) at[axis] = low[axis];
      if (axis >= Dim) return;
    }
  }

 private:
  /// Returns the distance of a coordinate from a cell along one axis, in edges.
  SCREE_FN static Real gap(Real place, int cell) {
    return Kokkos::max(Real(0), Kokkos::max(Real(cell) - place, place - Real(cell + 1)));
  }
};

/// The bounding box (m) and the number of the particles for which a grid is made. Two grids with the same frame have
/// the same cells, even if they cover different particles.
template <int Dim>
struct Frame {
  double low[Dim], high[Dim];  ///< low > high if there are no particles
  double count = 0;

  /// Makes a frame without particles.
  Frame() {
    for (int axis = 0; axis < Dim; ++axis) {
      low[axis] = std::numeric_limits<double>::infinity();
      high[axis] = -low[axis];
    }
  }
  /// Extends the frame to include the particles of another frame.
  void add(Frame const& other) {
    for (int axis = 0; axis < Dim; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
    count += other.count;
  }
};

namespace detail {

/// A function for reduce() that finds the bounding box of the positions and the number of coordinates that are not
/// finite.
template <class P>
struct BoundingBox {
  static constexpr int dim = P::dim;
  using real = typename P::real;
  struct value_type {
    real low[dim], high[dim];
    int invalid;
  };
  PositionSpan<P> x;

  SCREE_FN void init(value_type& box) const {
    for (int axis = 0; axis < dim; ++axis) {
      box.low[axis] = Kokkos::Experimental::finite_max_v<real>;
      box.high[axis] = Kokkos::Experimental::finite_min_v<real>;
    }
    box.invalid = 0;
  }
  SCREE_FN void join(value_type& box, value_type const& other) const {
    for (int axis = 0; axis < dim; ++axis) {
      box.low[axis] = Kokkos::min(box.low[axis], other.low[axis]);
      box.high[axis] = Kokkos::max(box.high[axis], other.high[axis]);
    }
    box.invalid += other.invalid;
  }
  SCREE_FN void operator()(int i, value_type& box) const {
    for (int axis = 0; axis < dim; ++axis) {
      if (!Kokkos::isfinite(x(i)[axis])) box.invalid += 1;
      box.low[axis] = Kokkos::min(box.low[axis], x(i)[axis]);
      box.high[axis] = Kokkos::max(box.high[axis], x(i)[axis]);
    }
  }
};

/// Throws std::runtime_error for positions with coordinates that are not finite; the message names the first such
/// position.
template <class X>
[[gnu::cold]] void refuse_positions(std::vector<X> const& all, int invalid) {
  auto const first = std::find_if(all.begin(), all.end(), [](auto const& each) { return !each.allFinite(); });
  std::string place;
  for (int axis = 0; first != all.end() && axis < int(X::RowsAtCompileTime); ++axis)
    place += (axis == 0 ? "" : ", ") + short_text(double((*first)[axis]));
  throw std::runtime_error("scree: " + std::to_string(invalid) + " coordinates of " + std::to_string(all.size()) +
                           " particles are not finite; the first is number " + std::to_string(first - all.begin()) +
                           " in memory, at (" + place + ") m");
}

}  // namespace detail

/// Returns the frame of the particles at given positions. Throws std::runtime_error if a position is not finite.
template <class P>
Frame<P::dim> frame_of(Positions<P> const& x) {
  int const n = x.size();
  Frame<P::dim> frame;
  if (n == 0) return frame;
  auto const box = reduce(x.space(), "scree::bounding_box", n, detail::BoundingBox<P>{x});
  if (box.invalid > 0) detail::refuse_positions(values_of(x), box.invalid);
  for (int axis = 0; axis < P::dim; ++axis) frame.low[axis] = double(box.low[axis]), frame.high[axis] = box.high[axis];
  frame.count = n;
  return frame;
}

/// Returns a grid over the positions of `here` with the cells of `frame`. The edges of cells are at least `edge` (m),
/// and cells are divided into `parts` along the first axis. Cells are enlarged if a few distant particles would
/// otherwise need too many cells (more than 65536 plus 8 per particle).
template <class P>
Grid<P::dim, typename P::real> make_grid(Frame<P::dim> const& frame, Frame<P::dim> const& here, double edge,
                                         int parts = 1) {
  using real = typename P::real;
  Grid<P::dim, real> grid;
  grid.parts = parts;
  if (here.count == 0) return grid;

  auto const length = [&](int axis) { return frame.high[axis] - frame.low[axis]; };
  double const most_cells = 8.0 * frame.count + (1 << 16);
  for (;; edge *= 2) {
    double cells = parts;
    for (int axis = 0; axis < P::dim; ++axis) cells *= std::floor(length(axis) / edge) + 2;
    if (cells <= most_cells) break;
  }
  double const rounding = double(Kokkos::Experimental::epsilon_v<real>);
  double longest = 0;
  for (int axis = 0; axis < P::dim; ++axis) longest = std::max(longest, length(axis));
  // Each of three coordinates, in edges, may be wrong by twice its rounding error, on both sides.
  grid.slack = real(32 * rounding * (longest / edge + 2));
  for (int axis = 0; axis < P::dim; ++axis) {
    // Rounding must not separate two particles within the radius by more than one cell.
    double const part = axis == 0 ? edge / parts : edge;
    double const wide = part * (1 + 4 * rounding * (longest / part + 2));
    grid.edges[axis] = real(wide);
    grid.origin[axis] = real(frame.low[axis]);
    // The grid has only the cells that `here` needs.
    auto const cell = [&](double x) { return std::floor((real(x) - grid.origin[axis]) / grid.edges[axis]); };
    grid.first[axis] = static_cast<int>(cell(here.low[axis]));
    int const cells = static_cast<int>(std::floor((here.high[axis] - here.low[axis]) / wide)) + 2;
    grid.cells[axis] = std::max(cells, static_cast<int>(cell(here.high[axis])) - grid.first[axis] + 1);
  }
  return grid;
}
/// Returns a grid around given positions. Throws std::runtime_error if a position is not finite.
template <class P>
Grid<P::dim, typename P::real> make_grid(Positions<P> const& x, double edge, int parts = 1) {
  auto const frame = frame_of<P>(x);
  return make_grid<P>(frame, frame, edge, parts);
}

}  // namespace scree
