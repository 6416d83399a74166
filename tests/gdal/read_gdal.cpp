// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/gdal/read_gdal.hpp>
#include <scree/io/write_raster.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cmath>
#include <filesystem>

namespace scree::test::read_gdal_tests {
namespace {

using Place = std::array<double, 6>;  // GDAL's transform from columns and rows to x and y

/// A raster of 5 x 3 points with one gap.
Raster hill() {
  Raster raster{.name = "hill", .columns = 5, .rows = 3, .x = 500002.5, .y = 4100007.5, .spacing = 5};
  for (int k = 0; k < 15; ++k) raster.values.push_back(k == 7 ? std::nan("") : 100.25 + k * k / 4.0);
  return raster;
}
Place place_of(Raster const& r) {
  return {r.x - r.spacing / 2, r.spacing, 0, r.y + (r.rows - 0.5) * r.spacing, 0, -r.spacing};
}
/// Writes a raster as GeoTIFF; values are stored as (value - offset)/scale.
std::filesystem::path geotiff(Folder const& folder, Raster const& raster, Place place, GDALDataType type,
                              double offset = 0, double scale = 1) {
  GDALAllRegister();
  auto const file = folder / "hill.tif";
  GDALDriverH const driver = GDALGetDriverByName("GTiff");
  REQUIRE(driver != nullptr);
  GDALDatasetH const dataset = GDALCreate(driver, file.c_str(), raster.columns, raster.rows, 1, type, nullptr);
  GDALSetGeoTransform(dataset, place.data());
  GDALRasterBandH const band = GDALGetRasterBand(dataset, 1);
  GDALSetRasterNoDataValue(band, -9999);
  if (scale != 1) GDALSetRasterScale(band, scale), GDALSetRasterOffset(band, offset);
  for (int row = 0; row < raster.rows; ++row) {
    std::vector<double> line;
    for (int column = 0; column < raster.columns; ++column) {
      double const value = raster.at(column, raster.rows - 1 - row);
      line.push_back(std::isnan(value) ? -9999 : (value - offset) / scale);
    }
    REQUIRE(GDALRasterIO(band, GF_Write, 0, row, raster.columns, 1, line.data(), raster.columns, 1, GDT_Float64, 0,
                         0) == CE_None);
  }
  GDALClose(dataset);
  return file;
}
void check_same(Raster const& a, Raster const& b) {
  CHECK((a.columns == b.columns && a.rows == b.rows && a.x == b.x && a.y == b.y && a.spacing == b.spacing));
  REQUIRE(a.values.size() == b.values.size());
  for (std::size_t k = 0; k < a.values.size(); ++k)
    CHECK((a.values[k] == b.values[k] || (std::isnan(a.values[k]) && std::isnan(b.values[k]))));
}

}  // namespace

TEST_CASE("a GeoTIFF is the same raster as the ESRI ASCII grid of its values") {
  Folder const folder;
  Raster const raster = hill();
  Raster const text = read_asc(to_asc(raster), "hill.asc");
  check_same(text, raster);
  for (auto const type : {GDT_Float32, GDT_Float64})
    check_same(read_gdal(geotiff(folder, raster, place_of(raster), type)), text);
  check_same(read_gdal(geotiff(folder, raster, place_of(raster), GDT_Int16, 100, 0.25)), text);
}

TEST_CASE("an ESRI ASCII grid is the same raster through GDAL") {
  Folder const folder;
  auto const file = folder / "hill.asc";
  write_raster(file, hill());
  check_same(read_gdal(file), hill());
}

TEST_CASE("a raster that GDAL cannot read or that is not of heights on squares to the north is refused by name") {
  using Catch::Matchers::MessageMatches, Catch::Matchers::ContainsSubstring;
  Folder const folder;
  CPLSetErrorHandler(CPLQuietErrorHandler);
  auto const refused = [](std::filesystem::path const& file, std::string const& why, int band = 1) {
    CHECK_THROWS_MATCHES(read_gdal(file, band), std::runtime_error,
                         MessageMatches(ContainsSubstring(file.string()) && ContainsSubstring(why)));
  };
  Raster const raster = hill();
  refused("/none/hill.tif", "cannot read it");
  refused(geotiff(folder, raster, place_of(raster), GDT_Float32), "no band 2", 2);
  for (int const part : {2, 4}) {
    Place turned = place_of(raster);
    turned[std::size_t(part)] = 0.1;
    refused(geotiff(folder, raster, turned, GDT_Float32), "west to east");
  }
  Place flat = place_of(raster);
  flat[5] = -4;
  refused(geotiff(folder, raster, flat, GDT_Float32), "not squares");
  Raster marked = raster;
  marked.values[3] = -32768;
  refused(
      geotiff(folder, marked, place_of(marked), GDT_Float32),
      "column 4, row 3 from above: -32768 is a usual mark of points without a value, and the file declares another");
  marked.values[3] = -3e38;
  refused(geotiff(folder, marked, place_of(marked), GDT_Float32), "is no height or depth");
  Place degrees = place_of(raster);
  degrees[1] = 1 / 3600.0, degrees[5] = -1 / 3600.0;
  refused(geotiff(folder, raster, degrees, GDT_Float32), "looks like degrees");
  Place upwards = place_of(raster);
  upwards[5] = 5;
  refused(geotiff(folder, raster, upwards, GDT_Float32), "north to south");
}

}  // namespace scree::test::read_gdal_tests
