// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "grid.hpp"

namespace scree {
namespace detail {

/// Sources sorted by cell: those of cell c are order(start(c)) ... order(start(c + 1) - 1), by ascending index.
template <class P>
struct CellOrder {
  using Indices = Kokkos::View<int*, memory_of<P>>;
  Positions<P> x;
  Grid<P::dim, typename P::real> grid;
  Indices start, filled, order;

  struct Count {};
  struct Fill {};
  struct SortWithinCell {};
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
/// 2010). Built anew at every update.
template <class P>
class CellList {
 public:
  using Indices = Kokkos::View<int*, memory_of<P>>;
  struct View {
    Grid<P::dim, typename P::real> grid;
    Indices start, order;
    template <class F>
    SCREE_LOOP_FN void for_each(int, Vec<P::dim, typename P::real> const& xi, F const& f, Share share = {}) const {
      grid.for_each_row_around(xi, [&](int first, int last) {
        for (int k = start(first) + share.lane; k < start(last + 1); k += share.lanes) f(order(k));
      });
    }
  };

  explicit CellList(double radius) : radius_(radius) {}

  void update(Positions<P> const&, Positions<P> const& sources) {
    using Order = detail::CellOrder<P>;
    int const n = static_cast<int>(sources.extent(0));
    view_.grid = make_grid<P>(sources, radius_);
    int const cells = view_.grid.size();
    reserve(view_.start, cells + 1);
    reserve(view_.order, n);
    reserve(filled_, cells);
    Kokkos::deep_copy(view_.start, 0);
    Kokkos::deep_copy(filled_, 0);
    Order const cell_order{sources, view_.grid, view_.start, filled_, view_.order};
    using Space = typename P::space;
    Kokkos::parallel_for("scree::cell_count", Kokkos::RangePolicy<Space, typename Order::Count>(0, n), cell_order);
    Kokkos::parallel_scan("scree::cell_start", Kokkos::RangePolicy<Space>(0, cells + 1),
                          detail::RunningSum<Indices>{view_.start});
    Kokkos::parallel_for("scree::cell_fill", Kokkos::RangePolicy<Space, typename Order::Fill>(0, n), cell_order);
    Kokkos::parallel_for("scree::cell_sort", Kokkos::RangePolicy<Space, typename Order::SortWithinCell>(0, cells),
                         cell_order);
    ++builds_;
  }
  View view() const { return view_; }
  long builds() const { return builds_; }

 private:
  // Device memory is slow to get, so it is kept.
  static void reserve(Indices& indices, int size) {
    if (static_cast<int>(indices.extent(0)) < size)
      indices = Indices(Kokkos::view_alloc("scree::cell_list", Kokkos::WithoutInitializing), size + size / 8);
  }

  double radius_;
  long builds_ = 0;
  Indices filled_;
  View view_;
};

}  // namespace scree
