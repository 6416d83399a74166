// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../kernels/default_bases.hpp"
#include "../neighbours/grid.hpp"
#include "../system/system.hpp"
#include "surface.hpp"

namespace scree {
namespace detail {

/// The types of the cells of a grid, computed in three sweeps over the particles: mark the filled cells, mark those
/// next to an empty cell, and set the type of each particle from its cell.
template <class P>
struct CellsByType {
  static constexpr int dim = P::dim;
  using real = typename P::real;
  PositionSpan<P> x;
  Grid<dim, real> grid;
  Span<int> filled, outermost;
  Column<P, CellType> type;

  SCREE_FN int count(Span<int> const& marks, Vec<dim, real> const& place) const {
    int sum = 0;
    grid.for_each_row_around(grid.centre(place), [&](int first, int last) {
      for (int cell = first; cell <= last; ++cell) sum += marks(cell);
    });
    return sum;
  }
};
// Several threads may store the same value in a cell, hence the atomic stores.
template <class P>
struct MarkFilled : CellsByType<P> {
  SCREE_FN void operator()(int i) const { Kokkos::atomic_store(&this->filled(this->grid.index(this->x(i))), 1); }
};
template <class P>
struct MarkOutermost : CellsByType<P> {
  SCREE_FN void operator()(int i) const {
    int const around = this->count(this->filled, this->x(i));
    if (around < math::power<P::dim>(3)) Kokkos::atomic_store(&this->outermost(this->grid.index(this->x(i))), 1);
  }
};
template <class P>
struct AssignType : CellsByType<P> {
  SCREE_FN void operator()(int i) const {
    bool const at_edge = this->outermost(this->grid.index(this->x(i))) != 0;
    this->type(i) = at_edge ? 1 : this->count(this->outermost, this->x(i)) > 0 ? 2 : 3;
  }
};

/// Writes the cell types of the first `owned` particles of x, which are not ghosts. Cells are at least `edge` (m) wide.
template <class P>
void classify_cells(typename P::space const& space, Positions<P> const& x, double edge, int owned,
                    Column<P, CellType> const& type) {
  auto const grid = make_grid<P>(x, edge);
  auto const size = static_cast<std::size_t>(grid.size());
  Array<P, int> const filled(space, "scree::cells_filled", size), outermost(space, "scree::cells_outermost", size);
  CellsByType<P> const cells{x, grid, filled, outermost, type};
  int const all = x.size();
  for_each_index(space, "scree::cells_filled", 0, all, MarkFilled<P>{cells});
  for_each_index(space, "scree::cells_outermost", 0, all, MarkOutermost<P>{cells});
  for_each_index(space, "scree::cell_types", 0, owned, AssignType<P>{cells});
}

}  // namespace detail

/// Pass that classifies the particles of the material by the type of their cell, the coarse stage of surface detection.
/// Cells are at least as wide as the support radius. Cells outside the grid are empty.
struct ClassifyCells {
  template <class Body>
  using fields = std::conditional_t<detail::covers<Material, Body>, Fields<Position, CellType>, Fields<>>;

  /// Writes the cell type of each particle of the material.
  template <class Sys>
  void run(Sys& system) const {
    using namespace fields;
    using P = typename Sys::policy;
    ProfilingRegion const region("scree::cell_types");
    auto const& material = system.template body<Material>();
    system.template refresh_ghosts<Material>(Fields<Position>{});
    detail::classify_cells<P>(material.space(), material[position], double(system.kernel().radius()), material.size(),
                              material.column(cell_type));
  }
};

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_CELL_TYPES(P)                                                                                      \
  SCREE_INSTANCE void scree::detail::classify_cells<P>(P::space const&, scree::Positions<P> const&, double, int, \
                                                       scree::Column<P, scree::CellType> const&)
SCREE_FOR_DEFAULT_BASES(SCREE_CELL_TYPES);
#undef SCREE_CELL_TYPES
#endif
