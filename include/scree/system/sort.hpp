// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "../neighbours/cell_list.hpp"

namespace scree {
namespace detail {
/// Returns the indices of the particles sorted by cell, for cells with the given edge (m).
template <class P>
Array<P, int const> order_along_cells(Positions<P> const& x, double edge) {
  CellList<P> cells(edge);
  cells.update(x, x);
  return cells.order();
}
}  // namespace detail

/// Sorts the owned particles of a body by cells of the given edge (m), so that neighbours in space are close in memory.
/// If particles flow, sort again from time to time. Ghosts must be created again afterwards.
template <class P>
void sort_along_cells(AnyParticles<P>& body, double edge) {
  using namespace fields;
  ProfilingRegion const region("scree::sort");
  body.resize(body.size());
  body.reorder(detail::order_along_cells<P>(body[position], edge));
}

}  // namespace scree
