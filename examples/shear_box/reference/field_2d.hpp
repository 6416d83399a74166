// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "profile.hpp"

#include <cstddef>
#include <vector>

namespace shear_box::reference {

/// C on the rectangle 0 <= X <= width, 0 <= Z <= 1 of material coordinates (X = x - z gamma(t), Z = z), by its values
/// at the centres of square cells, row by row from the bottom.
struct Field2d {
  double h = 0.0;
  int columns = 0;
  int rows = 0;
  std::vector<double> values;

  double width() const { return columns * h; }
  double centre(int cell) const { return (cell + 0.5) * h; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  double& value(int column, int row) { return values[index(column, row)]; }
  double value(int column, int row) const { return values[index(column, row)]; }

  // Concentration at a material point: bicubic. At sharp fronts it may leave [0, 1] by the interpolation error.
  double operator()(double X, double Z) const {
    CubicStencil const across(X, h, columns), along(Z, h, rows);
    double C = 0.0;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) C += along.weight[j] * across.weight[i] * value(across.first + i, along.first + j);
    return C;
  }

  // Mean over the width, a function of height.
  Profile width_mean() const {
    Profile profile{.h = h, .values = std::vector<double>(rows, 0.0)};
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) profile.values[j] += value(i, j);
      profile.values[j] /= columns;
    }
    return profile;
  }

  // Along the vertical through the middle of the box.
  Profile centre_column() const {
    Profile profile{.h = h, .values = std::vector<double>(rows)};
    for (int j = 0; j < rows; ++j) profile.values[j] = (*this)(0.5 * width(), centre(j));
    return profile;
  }

  double mean() const { return width_mean().mean(); }
};

}  // namespace shear_box::reference
