// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "quantities.hpp"

#include <map>

namespace shear_box {

/// Material coordinates of each particle, in H; they never change, because the box moves affinely.
struct MaterialPoints {
  std::vector<double> X, Z;        ///< as placed, jitter included
  std::vector<std::size_t> row;    ///< number of its lattice row, from the bottom
  std::vector<bool> central;       ///< in one of the columns closest to the middle of the width
  std::vector<double> row_height;  ///< z/H of each row
};

/// `cells`: lattice positions of the particles; `placed`: their initial positions (m; the last coordinate is the
/// height).
template <class Vector>
MaterialPoints material_points(Options const& o, std::vector<Vector> const& cells, std::vector<Vector> const& placed) {
  constexpr int up = Vector::RowsAtCompileTime - 1;
  double const H = o.geometry.height, middle = o.geometry.width / 2;
  auto const half_spacings = [&](Vector const& cell) { return std::lround(2 * cell[up] / spacing(o)); };
  MaterialPoints m;
  std::map<long, std::size_t> rows;
  for (auto const& cell : cells) rows.emplace(half_spacings(cell), 0);
  for (auto& [height, number] : rows) {
    number = m.row_height.size();
    m.row_height.push_back(double(height) * spacing(o) / 2 / H);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    m.X.push_back(placed[i][0] / H);
    m.Z.push_back(placed[i][up] / H);
    m.row.push_back(rows.at(half_spacings(cells[i])));
    m.central.push_back(std::abs(cells[i][0] - middle) < 0.75 * spacing(o));
  }
  return m;
}

}  // namespace shear_box
