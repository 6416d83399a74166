// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "../neighbours/cell_list.hpp"

namespace scree {
/// Sorts the owned particles of a body by cells of the given edge (m), so that neighbours in space are close in memory.
/// Repeat it where particles flow. Ghosts must be created again afterwards.
template <class Body>
void sort_along_cells(Body& body, double edge) {
  using namespace fields;
  using P = typename Body::policy;
  ProfilingRegion const region("scree::sort");
  body.resize(body.size());
  CellList<P> cells(edge);
  cells.update(body[position], body[position]);
  body.reorder(cells.order());
}

}  // namespace scree
