// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/loop.hpp"
#include "../core/words.hpp"
#include "grid.hpp"

#include <type_traits>

namespace scree {
namespace detail {

/// The index and the position of a source, stored together because they are read together.
template <class P>
struct alignas(16) Placed {
  typename P::real x[P::dim];
  int index;

  SCREE_FN Vec<P::dim, typename P::real> place() const {
    Vec<P::dim, typename P::real> result;
    for (int axis = 0; axis < P::dim; ++axis) result[axis] = x[axis];
    return result;
  }
};

/// Sources sorted by cell. Cell c contains the sources order(start(c)) ... order(start(c + 1) - 1), sorted by index or
/// by position.
template <class P>
struct CellOrder {
  PositionSpan<P> x;
  Grid<P::dim, typename P::real> grid;
  Span<int> start, filled, order;
  Span<Placed<P>> sorted;
};
template <class P>
struct CountInCells : CellOrder<P> {
  SCREE_FN void operator()(int j) const { Kokkos::atomic_inc(&this->start(this->grid.index(this->x(j)) + 1)); }
};
template <class P>
struct FillCells : CellOrder<P> {
  SCREE_FN void operator()(int j) const {
    int const cell = this->grid.index(this->x(j));
    this->order(this->start(cell) + Kokkos::atomic_fetch_add(&this->filled(cell), 1)) = j;
  }
};
/// A loop body that sorts the sources within a cell by index, so that their order, and with it every sum, does not
/// depend on the order of the threads.
struct SortWithinCells {
  Span<int const> start;
  Span<int> order;
  SCREE_FN void operator()(int cell) const {
    for (int k = start(cell) + 1; k < start(cell + 1); ++k) {
      int const moved = order(k);
      int hole = k;
      for (; hole > start(cell) && order(hole - 1) > moved; --hole) order(hole) = order(hole - 1);
      order(hole) = moved;
    }
  }
};
/// A loop body that sorts the sources within a cell by position, in lexicographic order of their coordinates. Sums then
/// depend neither on the order of the threads nor on the order of the particles in memory.
template <class P>
struct SortByPosition {
  PositionSpan<P> x;
  Span<int const> start;
  Span<int> order;
  SCREE_FN void operator()(int cell) const {
    for (int k = start(cell) + 1; k < start(cell + 1); ++k) {
      int const moved = order(k);
      auto const place = value_of(x(moved));
      int hole = k;
      for (; hole > start(cell) && comes_after(order(hole - 1), place, moved); --hole) order(hole) = order(hole - 1);
      order(hole) = moved;
    }
  }

 private:
  SCREE_FN bool comes_after(int i, Vec<P::dim, typename P::real> const& place, int of) const {
    auto const other = value_of(x(i));
    for (int axis = 0; axis < P::dim; ++axis)
      if (other[axis] != place[axis]) return other[axis] > place[axis];
    return i > of;
  }
};
template <class P>
struct PlaceInCells : CellOrder<P> {
  SCREE_FN void operator()(int k) const {
    auto const place = value_of(this->x(this->order(k)));
    Placed<P> source{};
    for (int axis = 0; axis < P::dim; ++axis) source.x[axis] = place[axis];
    source.index = this->order(k);
    this->sorted(k) = source;
  }
};

struct SumUp {
  Span<int> values;
  SCREE_FN void operator()(int k, int& sum, bool last) const {
    sum += values(k);
    if (last) values(k) = sum;
  }
};

/// A view of the cells for kernels, valid until the next update or the destruction of the cell list.
template <class P>
struct CellView {
  Grid<P::dim, typename P::real> grid;
  Span<int const> start;
  Span<detail::Placed<P> const> sorted;  // sources in the order of their cells
  typename P::real squared_radius = 0;
  template <class F>
  SCREE_LOOP_FN void for_each(int, Vec<P::dim, typename P::real> const& xi, F const& f, LaneRange range = {}) const {
    grid.for_each_row_around(xi, [&](int first, int last) {
      int const end = start(last + 1);
      for (int from = start(first) + range.lane; from < end; from += 32 * range.lanes) {
        // Most sources are too far away. They are rejected first, so that the threads of a warp do not wait for each
        // other's calls of f.
        auto hits = near(xi, from, end, range.lanes);
        for (; hits != 0; hits &= hits - 1) f(sorted(from + Kokkos::countr_zero(hits) * range.lanes).index);
      }
    });
  }

 private:
  /// Returns bits that mark which of the next 32 sources of a lane lie within the radius.
  SCREE_LOOP_FN std::uint32_t near(Vec<P::dim, typename P::real> const& xi, int from, int end, int lanes) const {
    std::uint32_t hits = 0, bit = 1;
    for (int k = from; k < end && bit != 0; k += lanes, bit <<= 1) {
      auto const source = detail::read_words(&sorted(k));
      hits |= squared_norm(xi - source.place()) < squared_radius ? bit : 0;
    }
    return hits;
  }
};

}  // namespace detail

/// An order in which cells, and the sources within a cell, are sorted by index. The order of summation then depends on
/// the order of the particles in memory.
struct ByIndex {};
/// An order in which cells, and the sources within a cell, are sorted by position. The order of summation then depends
/// only on the positions, as long as no two particles have the same position.
struct ByPosition {};

/// A neighbour search with cells as large as the search radius. The candidates of a target are the sources within the
/// radius in the target's own cell and in the adjacent cells (Green 2010). Cells are divided into four along the first
/// axis, and a target reads only the part of each row of cells that the sphere around it covers; in 3D, this is the
/// volume of 14.5 of 27 cells. Positions are stored in the order of the cells, so that each source beyond the radius
/// costs one contiguous read. The cells are rebuilt at every update.
template <class P, class Order = ByIndex>
class CellList {
 public:
  /// A view of the cells for kernels, valid until the next update or the destruction of the cell list.
  using View = detail::CellView<P>;

  /// Makes a search for sources within a radius, m.
  explicit CellList(double radius);

  void update(Positions<P> const&, Positions<P> const& sources);
  /// Rebuilds the list with the cells of a frame.
  void update_in(Frame<P::dim> const& frame, Positions<P> const& sources);
  View view() const { return view_; }
  /// Returns the indices of the sources of the last update, in the order of their cells.
  Array<P, int const> order() const { return order_.part(0, sources_); }
  long builds() const { return builds_; }

 private:
  void update(Positions<P> const& sources, Grid<P::dim, typename P::real> const& grid);
  // Device allocations are slow, so memory is kept.
  template <class Array>
  static void make_room(typename P::space const& space, Array& array, int size) {
    if (array.size() < size) reserve(space, array, "scree::cell_list", std::size_t(size) + std::size_t(size) / 8);
  }

  static constexpr int parts = 4;

  double radius_;
  long builds_ = 0;
  int sources_ = 0;
  Array<P, int> start_, filled_, order_;
  Array<P, detail::Placed<P>> sorted_;
  View view_;
};

template <class P, class Order>
CellList<P, Order>::CellList(double radius) : radius_(radius) {
  // Enlarged, so that it is not below the squared radius in a loop with different rounding.
  view_.squared_radius =
      typename P::real(sq(radius) * (1 + 8 * double(Kokkos::Experimental::epsilon_v<typename P::real>)));
}

template <class P, class Order>
void CellList<P, Order>::update(Positions<P> const&, Positions<P> const& sources) {
  ProfilingRegion const region("scree::cell_list");
  update(sources, make_grid<P>(sources, radius_, parts));
}

template <class P, class Order>
void CellList<P, Order>::update_in(Frame<P::dim> const& frame, Positions<P> const& sources) {
  ProfilingRegion const region("scree::cell_list");
  update(sources, make_grid<P>(frame, frame_of<P>(sources), radius_, parts));
}

template <class P, class Order>
void CellList<P, Order>::update(Positions<P> const& sources, Grid<P::dim, typename P::real> const& grid) {
  auto const& space = sources.space();
  int const n = sources_ = sources.size();
  view_.grid = grid;
  int const cells = view_.grid.size();
  make_room(space, start_, cells + 1);
  make_room(space, filled_, cells);
  make_room(space, order_, n);
  make_room(space, sorted_, n);
  start_.fill_with_zeros();
  filled_.fill_with_zeros();
  detail::CellOrder<P> const all{sources, view_.grid, start_, filled_, order_, sorted_};
  for_each_index(space, "scree::cell_count", 0, n, detail::CountInCells<P>{all});
  running_sum(space, "scree::cell_start", cells + 1, detail::SumUp{start_});
  for_each_index(space, "scree::cell_fill", 0, n, detail::FillCells<P>{all});
  if constexpr (std::is_same_v<Order, ByPosition>)
    for_each_index(space, "scree::cell_sort", 0, cells, detail::SortByPosition<P>{sources, start_, order_});
  else
    for_each_index(space, "scree::cell_sort", 0, cells, detail::SortWithinCells{start_, order_});
  for_each_index(space, "scree::cell_places", 0, n, detail::PlaceInCells<P>{all});
  view_.start = start_;
  view_.sorted = sorted_;
  ++builds_;
}

}  // namespace scree
