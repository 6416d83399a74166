// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/terrain/raster.hpp>

#include <support/folder.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test {
namespace {

using Catch::Matchers::ContainsSubstring;
std::string const head = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -1\n";
std::string const values = "4 5 6\n1 2 3\n";

std::string replaced(std::string text, std::string const& what, std::string const& by) {
  return text.replace(text.find(what), what.size(), by);
}

}  // namespace

TEST_CASE("a grid is read with its northern line last, by the corner or the centre of its first cell") {
  Raster const raster = read_asc(head + values, "a.asc");
  CHECK(raster.columns == 3);
  CHECK(raster.rows == 2);
  CHECK(raster.x == 105);
  CHECK(raster.y == 205);
  CHECK(raster.spacing == 10);
  CHECK(raster.values == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(raster.at(1, 1) == 5);
  auto const centred =
      read_asc(replaced(replaced(head, "xllcorner", "XLLCENTER"), "yllcorner", "yllCenter") + values, "a.asc");
  CHECK(centred.x == 100);
  CHECK(centred.y == 200);
  CHECK(read_asc(head + "4 5\n6 1 2\n3", "a.asc").values == raster.values);
}

TEST_CASE("heights between points are bilinear, and there are none outside") {
  Raster const raster = read_asc(head + values, "a.asc");
  CHECK(raster(105, 205) == 1);
  CHECK(raster(125, 215) == 6);
  CHECK(std::abs(raster(110, 209) - (1.5 + 0.4 * 3)) < 1e-15);
  CHECK(std::isnan(raster(104, 205)));
  CHECK(std::isnan(raster(110, 216)));
}

TEST_CASE("points without a value count only where they are needed") {
  Raster const raster = read_asc(head + "4 -1 6\n1 2 nan\n", "a.asc");
  CHECK(std::isnan(raster.at(1, 1)));
  CHECK(std::isnan(raster.at(2, 0)));
  CHECK(raster(105, 210) == 2.5);
  CHECK(raster(110, 205) == 1.5);
  CHECK(std::isnan(raster(110, 206)));
}

TEST_CASE("a raster is moved and cropped") {
  Raster const raster = read_asc(head + values, "a.asc").moved(-105, -205);
  CHECK(raster(10, 0) == 2);
  Raster const part = raster.cropped(5, -5, 25, 15);
  CHECK(part.columns == 2);
  CHECK(part.rows == 2);
  CHECK(part.x == 10);
  CHECK(part.values == std::vector<double>{2, 3, 5, 6});
  CHECK_THROWS_WITH(raster.cropped(5, -5, 15, 15), "a.asc: this rectangle holds less than two points along x or y");
}

TEST_CASE("what is no grid is refused with its file and line") {
  auto const refused = [](std::string const& text, std::string const& why) {
    CAPTURE(text);
    CHECK_THROWS_WITH(read_asc(text, "a.asc"), ContainsSubstring("a.asc, line") && ContainsSubstring(why));
  };
  refused("", "whole numbers of 2 or more");
  refused(replaced(head, "ncols 3", "ncols 3.5") + values, "whole numbers of 2 or more");
  refused(replaced(head, "ncols 3", "ncols 1") + values, "whole numbers of 2 or more");
  refused(replaced(head, "ncols 3", "ncols -3") + values, "whole numbers of 2 or more");
  refused(replaced(head, "ncols 3", "ncols 1e300") + values, "whole numbers of 2 or more");
  refused(replaced(head, "ncols 3", "ncols 2000000000") + values, "more values than the file has");
  refused(replaced(head, "ncols 3", "ncols") + values, "a name and a number");
  refused(replaced(head, "ncols 3", "ncols three") + values, "'three' is not a number");
  refused(replaced(head, "cellsize 10", "cellsize 0") + values, "cellsize above 0");
  refused(replaced(head, "cellsize 10", "dx 10\ndy 20") + values, "dx and dy are not read");
  refused(replaced(head, "xllcorner 100\n", "") + values, "xllcorner or xllcenter");
  refused(head + "4 5 6\n1 2", "the file ends after 5 of 6 values");
  refused(head + values + "7", "more values than the head names");
  refused(head + "4 5 x\n1 2 3", "'x' is not a number");
  refused(head + "4 5 inf\n1 2 3", "'inf' is not a finite number");
  std::string const whole = head + values;
  for (std::size_t length = 0; length < whole.size() - 2; ++length)
    CHECK_THROWS_AS(read_asc(whole.substr(0, length), "a.asc"), std::runtime_error);
}

TEST_CASE("a GeoTIFF is refused with what can be done") {
  Folder const folder;
  for (auto const& start : {std::string("II*\0", 4), std::string("MM\0*", 4)}) {
    auto const file = folder.write("dem.tif", start + head);
    CHECK_THROWS_WITH(read_raster(file), ContainsSubstring(file.string()) && ContainsSubstring("gdal_translate"));
  }
  CHECK(read_raster(folder.write("dem.asc", head + values)).values.size() == 6);
}

}  // namespace scree::test
