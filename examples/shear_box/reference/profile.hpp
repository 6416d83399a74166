// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shear_box::reference {

/// Cubic Lagrange interpolation between cell centres (i + 1/2) h, one-sided next to a wall: fourth order, so that it
/// does not add to the error of a second-order solution. Needs at least four cells.
struct CubicStencil {
  int first;  // of four cells
  std::array<double, 4> weight;

  CubicStencil(double position, double h, int cells) {
    double const s = position / h - 0.5;
    first = std::clamp(static_cast<int>(std::floor(s)) - 1, 0, cells - 4);
    double const a = s - first, b = a - 1.0, c = a - 2.0, d = a - 3.0;
    weight = {-b * c * d / 6.0, 0.5 * a * c * d, -0.5 * a * b * d, a * b * c / 6.0};
  }
};

/// A function of height z in 0..1, by its values in cells of size h.
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

  // Height of the centre of the small grains.
  double centre_of_small_grains() const {
    double moment = 0.0;
    for (int i = 0; i < cells(); ++i) moment += values[i] * centre(i);
    return moment / (mean() * cells());
  }

  // Mean concentration of the lower half.
  double mean_of_lower_half() const {
    double sum = 0.0;
    for (int i = 0; i < cells(); ++i) sum += values[i] * std::clamp((0.5 - i * h) / h, 0.0, 1.0);
    return sum / (0.5 * cells());
  }
};

}  // namespace shear_box::reference
