// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../setup/terrain/raster.hpp"
#include "write_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>

namespace scree {

/// Returns the values of a raster, with six digits, as the text of an ESRI ASCII grid; NaN becomes NODATA_value.
inline std::string to_asc(Raster const& raster) {
  double const half = raster.spacing / 2;
  std::string text =
      fmt::format("ncols {}\nnrows {}\nxllcorner {:.12g}\nyllcorner {:.12g}\ncellsize {:.12g}\nNODATA_value -9999\n",
                  raster.columns, raster.rows, raster.x - half, raster.y - half, raster.spacing);
  for (int row = raster.rows - 1; row >= 0; --row)
    for (int column = 0; column < raster.columns; ++column) {
      double const value = raster.at(column, row);
      fmt::format_to(std::back_inserter(text), "{:.6g}{}", std::isnan(value) ? -9999.0 : value,
                     column + 1 == raster.columns ? "\n" : " ");
    }
  return text;
}
/// Writes a raster to an ESRI ASCII grid, which GIS programs and read_raster() can open. Throws std::runtime_error with
/// the file and the reason.
inline void write_raster(std::filesystem::path const& file, Raster const& raster) { write_file(file, to_asc(raster)); }

}  // namespace scree
