// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/available_memory.hpp"
#include "../core/setting.hpp"
#include "../setup/shapes/primitives.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scree {

/// A grid of cells that fill a box:
///
///     CoarseGrid<2> grid{.box = {{0, 0}, {0.4, 0.2}}, .cell = {0.02, 0.01}};
///
/// Fields are coarse-grained at the centres of the cells.
template <int Dim>
struct CoarseGrid {
  Box<Dim> box;                                      ///< m
  Vec<Dim, double> cell = Vec<Dim, double>::Zero();  ///< edges of a cell, m; the last cells may extend beyond the box
  double width = 0;                                  ///< smoothing length of the kernel, m; 0: as in the solver
  bool linear = true;  ///< true: exact for linear fields; false: only for constant fields; see coarse_grained()

  /// Returns the number of cells along each axis.
  std::array<int, std::size_t(Dim)> cells() const {
    std::array<int, std::size_t(Dim)> numbers{};
    for (int axis = 0; axis < Dim; ++axis)
      numbers[std::size_t(axis)] = int(std::ceil((box.high[axis] - box.low[axis]) / cell[axis] - 1e-9));
    return numbers;
  }
  /// Returns the number of points.
  std::size_t size() const {
    std::size_t product = 1;
    for (int const each : cells()) product *= std::size_t(each);
    return product;
  }
  /// Returns the points (m); the first coordinate varies fastest.
  std::vector<Vec<Dim, double>> points() const {
    auto const numbers = cells();
    std::vector<Vec<Dim, double>> all;
    all.reserve(size());
    for (std::size_t k = 0; k < size(); ++k) {
      Vec<Dim, double> x;
      std::size_t left = k;
      for (int axis = 0; axis < Dim; ++axis) {
        auto const number = std::size_t(numbers[std::size_t(axis)]);
        x[axis] = box.low[axis] + (double(left % number) + 0.5) * cell[axis];
        left /= number;
      }
      all.push_back(x);
    }
    return all;
  }
  /// Throws std::invalid_argument for a box without volume, for cells or a width below the particle spacing (m), and
  /// for 1e8 points or more.
  void check(double spacing) const {
    std::string const least = detail::formatted("the spacing of the particles, %g, or more", spacing);
    double number = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      double const size = box.high[axis] - box.low[axis];
      check_setting(size > 0 && std::isfinite(size),
                    detail::formatted("the size (m) of a coarse grid along axis %d", axis).c_str(), size, "above 0");
      check_setting(cell[axis] >= spacing, detail::formatted("cell[%d] (m) of a coarse grid", axis).c_str(), cell[axis],
                    least.c_str());
      number *= std::ceil(size / cell[axis] - 1e-9);
    }
    check_setting(width == 0 || (width >= spacing && std::isfinite(width)), "width (m) of a coarse grid", width,
                  (least + ", or 0").c_str());
    check_setting(number < 1e8, "the number of points of a coarse grid", number, "below 1e8");
  }
};

}  // namespace scree
