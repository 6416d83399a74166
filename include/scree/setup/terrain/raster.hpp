// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/setting.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Rasters of numbers from ESRI ASCII grids (.asc), the text format that all geographic programs write. read_gdal() of
// gdal/read_gdal.hpp reads other formats.
namespace scree {

/// Numbers at the points of a square grid in the plane of x and y. NaN marks a point without a value.
struct Raster {
  std::string name = "raster";      ///< of the file
  int columns = 0, rows = 0;        ///< along x and along y, from low to high
  double x = 0, y = 0;              ///< of the first point, m
  double spacing = 0;               ///< distance between points, m
  std::vector<double> values = {};  ///< row by row, from the lowest y

  /// Returns the value of a point. Columns and rows are numbered from 0, rows from the lowest y; the numbers are not
  /// checked.
  double at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
  /// Returns the coordinate x of the points of a column, m.
  double x_of(int column) const { return x + column * spacing; }
  /// Returns the coordinate y of the points of a row, m.
  double y_of(int row) const { return y + row * spacing; }

  /// Returns the bilinear interpolation between points; NaN outside of the grid and if one of the four points has no
  /// value.
  double operator()(double to_x, double to_y) const {
    double const u = (to_x - x) / spacing, v = (to_y - y) / spacing, rounding = 1e-9;
    if (!(u >= -rounding && v >= -rounding && u <= columns - 1 + rounding && v <= rows - 1 + rounding))
      return std::numeric_limits<double>::quiet_NaN();
    int const i = std::clamp(static_cast<int>(u), 0, columns - 2), j = std::clamp(static_cast<int>(v), 0, rows - 2);
    double const s = std::clamp(u - i, 0.0, 1.0), t = std::clamp(v - j, 0.0, 1.0);
    auto const between = [](double a, double b, double part) {  // a NaN with zero weight is ignored
      return part == 0 ? a : part == 1 ? b : (1 - part) * a + part * b;
    };
    if (t == 0 || t == 1) return between(at(i, j + int(t)), at(i + 1, j + int(t)), s);
    return between(between(at(i, j), at(i + 1, j), s), between(at(i, j + 1), at(i + 1, j + 1), s), t);
  }
  /// Returns the raster moved by a vector (m). Rasters often have coordinates of a million metres, which leave fewer
  /// digits for differences between positions.
  Raster moved(double by_x, double by_y) const {
    Raster result = *this;
    result.x += by_x, result.y += by_y;
    return result;
  }
  /// Returns the points within a rectangle, m. Throws std::runtime_error if there are fewer than two along x or y.
  Raster cropped(double from_x, double from_y, double to_x, double to_y) const {
    auto const first = [&](double from, double low, int most) {
      return static_cast<int>(std::clamp(std::ceil((from - low) / spacing - 1e-9), 0.0, double(most)));
    };
    auto const behind = [&](double to, double low, int most) {
      return static_cast<int>(std::clamp(std::floor((to - low) / spacing + 1e-9) + 1, 0.0, double(most)));
    };
    int const i = first(from_x, x, columns), j = first(from_y, y, rows);
    Raster result{name, behind(to_x, x, columns) - i, behind(to_y, y, rows) - j, x_of(i), y_of(j), spacing};
    if (result.columns < 2 || result.rows < 2)
      throw std::runtime_error(name + ": this rectangle holds less than two points along x or y");
    for (int row = j; row < j + result.rows; ++row)
      for (int column = i; column < i + result.columns; ++column) result.values.push_back(at(column, row));
    return result;
  }
};

namespace detail {
/// The largest magnitude of a height or depth in a raster, m.
inline constexpr double highest = 1e5;
/// Whether a number is a usual marker of a missing value.
bool is_usual_mark(double value);
/// Returns the reason why a number cannot be a height or depth (m); "" if it can.
std::string not_a_height(double value);
/// Throws std::runtime_error if the spacing of a raster is below 0.1 and looks like degrees: it is a whole number of
/// arc seconds, thirds or ninths of one, written with all digits, or heights differ by more than a hundred times the
/// extent.
void check_metres(Raster const& raster);
/// Throws std::runtime_error if a value is -999, 9999, 65535 or 99999 and no other value is within 100 m: such numbers
/// can be heights, but then other heights are close to them.
void check_marks(Raster const& raster);
}  // namespace detail

/// Returns the raster in the text of an ESRI ASCII grid; `name` is the name of the file. The values are at the middle
/// of each cell. The first line of values is the northernmost, with the highest y. Points with the nodata_value
/// (default -9999) or "nan" become NaN. Throws std::runtime_error, with the file and the line, for everything that does
/// not follow the format, for a value beyond 1e5 m, and for a usual mark of points without a value (-9999, -99999,
/// -32768, -32767, 32767) that the head does not declare. Throws std::runtime_error with the file for -999, 9999, 65535
/// or 99999 without another value within 100 m, and for a cellsize that looks like degrees.
Raster read_asc(std::string_view text, std::string const& name);
/// Returns the raster in an .asc file. Throws std::runtime_error if the file cannot be read, and as read_asc() does.
Raster read_raster(std::filesystem::path const& file);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "raster.ipp"
#endif
