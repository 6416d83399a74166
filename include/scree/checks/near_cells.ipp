// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "near_cells.hpp"

namespace scree::detail {

SCREE_BODY std::vector<std::uint32_t> marks_around(std::vector<PointsInCells::Point> const& points, double width) {
  CellNumbers known;
  std::vector<CellIndex> cells;
  CellIndex before = {};
  for (auto const& x : points) {
    CellIndex const cell = PointsInCells::cell_of(x, width);
    if (!cells.empty() && is_same(cell, before)) continue;  // neighbours in memory are often in one cell
    before = cell;
    if (known.add(cell) == cells.size()) cells.push_back(cell);
  }
  std::size_t const most = std::size_t(1) << 26;
  std::vector<std::uint32_t> marks(std::min(std::bit_ceil(16 * cells.size() + 1), most), 0);
  for (CellIndex const& at : cells)
    for (int k = 0; k < 27; ++k) {
      std::uint64_t const bit = MaybeNear::hash(at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1) &
                                (std::uint64_t(marks.size()) * 32 - 1);
      marks[std::size_t(bit / 32)] |= std::uint32_t(1) << (bit % 32);
    }
  return marks;
}

}  // namespace scree::detail
