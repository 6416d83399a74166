// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Solutions given by their values in cells: functions of height, and fields in two dimensions.
namespace shear_box::reference {

/// Weights of cubic Lagrange interpolation between cell centres (i + 1/2) h, one-sided next to a wall. Interpolation is
/// of fourth order, so its error is negligible in a second-order solution. At least four cells are needed.
struct CubicStencil {
  int first;  // index of the first of four cells
  std::array<double, 4> weight;

  CubicStencil(double position, double h, int cells) {
    double const s = position / h - 0.5;
    first = std::clamp(static_cast<int>(std::floor(s)) - 1, 0, cells - 4);
    double const a = s - first, b = a - 1.0, c = a - 2.0, d = a - 3.0;
    weight = {-b * c * d / 6.0, 0.5 * a * c * d, -0.5 * a * b * d, a * b * c / 6.0};
  }
};

/// A function of height z from 0 to 1, given by its values in cells of size h.
struct Profile {
  double h = 0.0;
  std::vector<double> values;

  int cells() const { return static_cast<int>(values.size()); }
  double centre(int cell) const { return (cell + 0.5) * h; }

  double operator()(double z) const {
    CubicStencil const stencil(z, h, cells());
    double C = 0.0;
    for (int i = 0; i < 4; ++i) C += stencil.weight[i] * values[stencil.first + i];
    return C;
  }

  double mean() const {
    double sum = 0.0;
    for (double C : values) sum += C;
    return sum / cells();
  }

  // Returns the height of the centre of the small grains.
  double centre_of_small_grains() const {
    double moment = 0.0;
    for (int i = 0; i < cells(); ++i) moment += values[i] * centre(i);
    return moment / (mean() * cells());
  }

  // Returns the mean concentration in the lower half.
  double mean_of_lower_half() const {
    double sum = 0.0;
    for (int i = 0; i < cells(); ++i) sum += values[i] * std::clamp((0.5 - i * h) / h, 0.0, 1.0);
    return sum / (0.5 * cells());
  }
};

/// C on the rectangle 0 <= X <= width, 0 <= Z <= 1 in material coordinates (X = x - z gamma(t), Z = z), given by its
/// values at the centres of square cells, row by row from the bottom.
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

  // Returns the concentration at a material point by bicubic interpolation. At sharp fronts the value may leave [0, 1]
  // by the interpolation error.
  double operator()(double X, double Z) const {
    CubicStencil const across(X, h, columns), along(Z, h, rows);
    double C = 0.0;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) C += along.weight[j] * across.weight[i] * value(across.first + i, along.first + j);
    return C;
  }

  // Returns the mean over the width as a function of height.
  Profile width_mean() const {
    Profile profile{.h = h, .values = std::vector<double>(rows, 0.0)};
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) profile.values[j] += value(i, j);
      profile.values[j] /= columns;
    }
    return profile;
  }

  // Returns the profile along the line X = width/2, through the middle of the box.
  Profile centre_column() const {
    Profile profile{.h = h, .values = std::vector<double>(rows)};
    for (int j = 0; j < rows; ++j) profile.values[j] = (*this)(0.5 * width(), centre(j));
    return profile;
  }

  double mean() const { return width_mean().mean(); }
};

}  // namespace shear_box::reference
