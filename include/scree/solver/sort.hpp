// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "../neighbours/cell_list.hpp"

namespace scree {
/// Puts the owned particles of a body into the order of cells of an edge (m), so that neighbours in space lie beside
/// each other in memory, and where particles flow, do so again. Ghosts have to be made anew.
template <class Body>
void sort_along_cells(Body& body, double edge) {
  using P = typename Body::policy;
  body.resize(body.size());
  CellList<P> cells(edge);
  cells.update(body[position], body[position]);
  body.reorder(cells.order());
}

}  // namespace scree
