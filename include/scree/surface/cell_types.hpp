// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../neighbours/grid.hpp"
#include "../solver/system.hpp"
#include "surface.hpp"

namespace scree {
namespace detail {

/// Types of the cells of a grid, in three sweeps over particles: mark the filled ones, then those next to an empty one,
/// then read off the type of each particle's cell.
template <class P>
struct ClassifyCells {
  static constexpr int dim = P::dim;
  using real = typename P::real;
  Positions<P> x;
  Grid<dim, real> grid;
  Kokkos::View<int*, memory_of<P>> filled, outermost;
  Column<P, CellType> type;

  struct MarkFilled {};
  struct MarkOutermost {};
  struct Assign {};

  // Several threads store the same value.
  SCREE_FN void operator()(MarkFilled, int i) const { Kokkos::atomic_store(&filled(grid.index(x(i))), 1); }
  SCREE_FN void operator()(MarkOutermost, int i) const {
    int const around = count(filled, x(i));
    if (around < power<dim>(3)) Kokkos::atomic_store(&outermost(grid.index(x(i))), 1);
  }
  SCREE_FN void operator()(Assign, int i) const {
    type(i) = outermost(grid.index(x(i))) ? 1 : count(outermost, x(i)) > 0 ? 2 : 3;
  }

 private:
  SCREE_FN int count(Kokkos::View<int*, memory_of<P>> const& marks, Vec<dim, real> const& place) const {
    int sum = 0;
    grid.for_each_row_around(grid.centre(place), [&](int first, int last) {
      for (int cell = first; cell <= last; ++cell) sum += marks(cell);
    });
    return sum;
  }
};

}  // namespace detail

/// Pass: sorts the material's particles by the type of their cell (edge: the radius of the support), the rough stage of
/// the surface search. Cells beyond the edge of the grid are empty.
struct ClassifyCells {
  template <class Body>
  using fields = std::conditional_t<std::is_same_v<Body, Material>, Fields<Position, CellType>, Fields<>>;

  template <class Sys>
  void run(Sys& system) const {
    using P = typename Sys::policy;
    using Cells = detail::ClassifyCells<P>;
    auto const& material = system.template body<Material>();
    system.template refresh_ghosts<Material>(Fields<Position>{});
    Positions<P> const x = material[position];
    auto const grid = make_grid<P>(x, system.kernel().radius());
    Cells const cells{x, grid, Kokkos::View<int*, memory_of<P>>("scree::cells_filled", grid.size()),
                      Kokkos::View<int*, memory_of<P>>("scree::cells_outermost", grid.size()),
                      material.select(Fields<CellType>{})[cell_type]};
    using Space = typename P::space;
    int const all = material.extent();
    Kokkos::parallel_for("scree::cells_filled", Kokkos::RangePolicy<Space, typename Cells::MarkFilled>(0, all), cells);
    Kokkos::parallel_for("scree::cells_outermost", Kokkos::RangePolicy<Space, typename Cells::MarkOutermost>(0, all),
                         cells);
    Kokkos::parallel_for("scree::cell_types", Kokkos::RangePolicy<Space, typename Cells::Assign>(0, material.size()),
                         cells);
  }
};

}  // namespace scree
