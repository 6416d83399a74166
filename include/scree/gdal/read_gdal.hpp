// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../setup/terrain/raster.hpp"

#include <gdal.h>

#include <memory>

// Rasters in the formats that GDAL reads, for instance GeoTIFF, for programs that link scree::gdal.
namespace scree {

namespace detail {

struct CloseDataset {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
[[noreturn]] inline void fail_raster(std::filesystem::path const& file, std::string const& why) {
  throw std::runtime_error(file.string() + ": " + why);
}

/// Returns a raster with the size and position of a dataset, without values.
inline Raster raster_like(GDALDatasetH dataset, std::filesystem::path const& file) {
  double t[6] = {};  // x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row, of the corners of cells
  if (GDALGetGeoTransform(dataset, t) != CE_None) fail_raster(file, "it does not say where its cells are");
  if (t[2] != 0 || t[4] != 0) fail_raster(file, "its rows do not run from west to east");
  if (!(t[1] > 0 && std::abs(t[5] + t[1]) <= 1e-9 * t[1]))
    fail_raster(file, "its cells are not squares in rows from north to south");
  int const columns = GDALGetRasterXSize(dataset), rows = GDALGetRasterYSize(dataset);
  if (columns < 2 || rows < 2) fail_raster(file, "it has less than two columns or rows");
  return {file.filename().string(), columns, rows, t[0] + t[1] / 2, t[3] + t[5] * (rows - 0.5), t[1]};
}

}  // namespace detail

/// Returns the values of a band of a raster file at the centres of the cells, as read_raster() does; cells without a
/// value become NaN. The file must have square cells in rows from north to south, in metres. Throws std::runtime_error
/// with the file and the reason, also for a number that cannot be a height, as read_asc() does.
inline Raster read_gdal(std::filesystem::path const& file, int number = 1) {
  GDALAllRegister();
  std::unique_ptr<void, detail::CloseDataset> const dataset(
      GDALOpenEx(file.c_str(), GDAL_OF_READONLY | GDAL_OF_RASTER, nullptr, nullptr, nullptr));
  if (!dataset) detail::fail_raster(file, std::string("GDAL cannot read it: ") + CPLGetLastErrorMsg());
  Raster result = detail::raster_like(dataset.get(), file);
  if (number < 1 || number > GDALGetRasterCount(dataset.get()))
    detail::fail_raster(file, "it has no band " + std::to_string(number));
  double const count = double(result.columns) * result.rows;
  if (count > most_particles) detail::fail_raster(file, "it has more values than can be counted");
  check_memory(count, sizeof(double));
  result.values.resize(static_cast<std::size_t>(count));

  GDALRasterBandH const band = GDALGetRasterBand(dataset.get(), number);
  int has_none = 0;
  double const none = GDALGetRasterNoDataValue(band, &has_none);
  double const scale = GDALGetRasterScale(band, nullptr), offset = GDALGetRasterOffset(band, nullptr);
  for (int row = 0; row < result.rows; ++row) {
    double* const to = result.values.data() + std::ptrdiff_t(result.rows - 1 - row) * result.columns;
    if (GDALRasterIO(band, GF_Read, 0, row, result.columns, 1, to, result.columns, 1, GDT_Float64, 0, 0) != CE_None)
      detail::fail_raster(file, std::string("GDAL cannot read its values: ") + CPLGetLastErrorMsg());
    for (int column = 0; column < result.columns; ++column) {
      bool const missing = has_none != 0 && to[column] == none;
      double const value = offset + scale * to[column];
      std::string why = missing || std::isnan(value) ? "" : detail::not_a_height(value);
      if (why.empty() && !missing && detail::is_usual_mark(to[column])) why = detail::not_a_height(to[column]);
      if (!why.empty())
        detail::fail_raster(
            file, detail::formatted("column %d, row %d from above: %.9g %s, and the file declares %s", column + 1,
                                    row + 1, to[column], why.c_str(), has_none != 0 ? "another one" : "none"));
      to[column] = missing ? std::numeric_limits<double>::quiet_NaN() : value;
    }
  }
  detail::check_marks(result);
  detail::check_metres(result);
  return result;
}

}  // namespace scree
