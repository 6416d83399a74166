// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/write_raster.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <limits>

namespace scree::test::write_raster_tests {

TEST_CASE("a raster that was written is read back: place, order of rows, values and gaps") {
  Raster raster{.columns = 3, .rows = 2, .x = 612345.5, .y = -0.25, .spacing = 0.5};
  raster.values = {1, 2.5, -3, 4e-7, std::numeric_limits<double>::quiet_NaN(), 123.456};
  Folder const scratch;
  write_raster(scratch / "depth.asc", raster);
  Raster const back = read_raster(scratch / "depth.asc");
  CHECK(back.columns == 3);
  CHECK(back.rows == 2);
  CHECK(back.x == raster.x);
  CHECK(back.y == raster.y);
  CHECK(back.spacing == raster.spacing);
  for (std::size_t k = 0; k < 6; ++k) {
    if (k == 4)
      CHECK(std::isnan(back.values[k]));
    else
      CHECK(back.values[k] == raster.values[k]);
  }
}

TEST_CASE("a raster that cannot be written is reported with its file") {
  CHECK_THROWS_WITH(
      write_raster("/no/such/folder/depth.asc", {.columns = 2, .rows = 2, .spacing = 1, .values = {1, 2, 3, 4}}),
      Catch::Matchers::ContainsSubstring("/no/such/folder/depth.asc"));
}

}  // namespace scree::test::write_raster_tests
