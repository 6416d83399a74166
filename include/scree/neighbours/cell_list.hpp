// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/words.hpp"
#include "grid.hpp"

namespace scree {
namespace detail {

/// A source and its place, to be read in one go.
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

/// Sources sorted by cell: those of cell c are order(start(c)) ... order(start(c + 1) - 1), by ascending index.
template <class P>
struct CellOrder {
  using Indices = Kokkos::View<int*, memory_of<P>>;
  Positions<P> x;
  Grid<P::dim, typename P::real> grid;
  Indices start, filled, order;
  Kokkos::View<Placed<P>*, memory_of<P>> sorted;

  struct Count {};
  struct Fill {};
  struct SortWithinCell {};
  struct Place {};
  SCREE_FN void operator()(Count, int j) const { Kokkos::atomic_inc(&start(grid.index(x(j)) + 1)); }
  SCREE_FN void operator()(Fill, int j) const {
    int const cell = grid.index(x(j));
    order(start(cell) + Kokkos::atomic_fetch_add(&filled(cell), 1)) = j;
  }
  // Which thread came first must not be seen in any sum.
  SCREE_FN void operator()(SortWithinCell, int cell) const {
    for (int k = start(cell) + 1; k < start(cell + 1); ++k) {
      int const moved = order(k);
      int hole = k;
      for (; hole > start(cell) && order(hole - 1) > moved; --hole) order(hole) = order(hole - 1);
      order(hole) = moved;
    }
  }
  SCREE_FN void operator()(Place, int k) const {
    auto const place = value_of(x(order(k)));
    Placed<P> source{};
    for (int axis = 0; axis < P::dim; ++axis) source.x[axis] = place[axis];
    source.index = order(k);
    sorted(k) = source;
  }
};

template <class Indices>
struct RunningSum {
  Indices values;
  SCREE_FN void operator()(int k, int& sum, bool last) const {
    sum += values(k);
    if (last) values(k) = sum;
  }
};

}  // namespace detail

/// Cells of the search radius; the candidates of a target are the sources in its own and the adjacent cells (Green
/// 2010) as far as they lie within the radius. Cells are cut in four along the first axis; of a row of them a target
/// looks at what the ball around it cuts out, in 3D at 14.5 of 27 cells. Places are kept in the order of the cells, so
/// that those beyond the radius cost one read from beside the one before. Built anew at every update.
template <class P>
class CellList {
 public:
  using Indices = Kokkos::View<int*, memory_of<P>>;
  struct View {
    Grid<P::dim, typename P::real> grid;
    Indices start;
    Kokkos::View<detail::Placed<P>*, memory_of<P>> sorted;  // sources in the order of their cells
    typename P::real squared_radius = 0;
    template <class F>
    SCREE_LOOP_FN void for_each(int, Vec<P::dim, typename P::real> const& xi, F const& f, Share share = {}) const {
      grid.for_each_row_around(xi, [&](int first, int last) {
        int const end = start(last + 1);
        for (int from = start(first) + share.lane; from < end; from += 32 * share.lanes) {
          // Most are too far: found first, so that threads of a warp do not wait for f of each of them in turn.
          auto hits = near(xi, from, end, share.lanes);
          for (; hits != 0; hits &= hits - 1) f(sorted(from + Kokkos::countr_zero(hits) * share.lanes).index);
        }
      });
    }

   private:
    /// Which of the next 32 sources of a lane lie within the radius, as bits.
    SCREE_LOOP_FN std::uint32_t near(Vec<P::dim, typename P::real> const& xi, int from, int end, int lanes) const {
      std::uint32_t hits = 0, bit = 1;
      for (int k = from; k < end && bit != 0; k += lanes, bit <<= 1) {
        auto const source = detail::read_words(&sorted(k));
        hits |= (xi - source.place()).squaredNorm() < squared_radius ? bit : 0;
      }
      return hits;
    }
  };

  explicit CellList(double radius) : radius_(radius) {
    // Not less than a loop with other rounding takes for the square of the radius.
    view_.squared_radius =
        typename P::real(sq(radius) * (1 + 8 * double(Kokkos::Experimental::epsilon_v<typename P::real>)));
  }

  void update(Positions<P> const&, Positions<P> const& sources) {
    using Order = detail::CellOrder<P>;
    int const n = static_cast<int>(sources.extent(0));
    view_.grid = make_grid<P>(sources, radius_, parts);
    int const cells = view_.grid.size();
    reserve(view_.start, cells + 1);
    reserve(view_.sorted, n);
    reserve(order_, n);
    reserve(filled_, cells);
    Kokkos::deep_copy(view_.start, 0);
    Kokkos::deep_copy(filled_, 0);
    Order const cell_order{sources, view_.grid, view_.start, filled_, order_, view_.sorted};
    using Space = typename P::space;
    Kokkos::parallel_for("scree::cell_count", Kokkos::RangePolicy<Space, typename Order::Count>(0, n), cell_order);
    Kokkos::parallel_scan("scree::cell_start", Kokkos::RangePolicy<Space>(0, cells + 1),
                          detail::RunningSum<Indices>{view_.start});
    Kokkos::parallel_for("scree::cell_fill", Kokkos::RangePolicy<Space, typename Order::Fill>(0, n), cell_order);
    Kokkos::parallel_for("scree::cell_sort", Kokkos::RangePolicy<Space, typename Order::SortWithinCell>(0, cells),
                         cell_order);
    Kokkos::parallel_for("scree::cell_places", Kokkos::RangePolicy<Space, typename Order::Place>(0, n), cell_order);
    ++builds_;
  }
  View view() const { return view_; }
  long builds() const { return builds_; }

 private:
  // Device memory is slow to get, so it is kept.
  template <class Array>
  static void reserve(Array& array, int size) {
    if (static_cast<int>(array.extent(0)) < size)
      array = Array(Kokkos::view_alloc("scree::cell_list", Kokkos::WithoutInitializing), size + size / 8);
  }

  static constexpr int parts = 4;

  double radius_;
  long builds_ = 0;
  Indices filled_, order_;
  View view_;
};

}  // namespace scree
