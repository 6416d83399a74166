// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/terrain/raster.hpp>

#include <support/folder.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace scree::test::raster_tests {
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

TEST_CASE("a mark of points without a value that the head does not declare is no height") {
  auto const refused = [](std::string const& nodata, std::string const& value, std::string const& why) {
    std::string const text = replaced(head, "NODATA_value -1\n", nodata) + "4 5 6\n1 " + value + " 3\n";
    auto const line = std::to_string(std::count(text.begin(), text.end(), '\n'));
    CAPTURE(text);
    CHECK_THROWS_WITH(read_asc(text, "a.asc"), ContainsSubstring("a.asc, line " + line + ": '" + value + "' ") &&
                                                   ContainsSubstring(why) && ContainsSubstring("NODATA_value"));
  };
  std::string const mark = "is a usual mark of points without a value; the NODATA_value of the head is ";
  refused("", "-32768", mark + "-9999");
  refused("", "-99999", mark + "-9999");
  refused("", "32767", mark + "-9999");
  refused("NODATA_value -32768\n", "-9999", mark + "-32768");
  refused("NODATA_value -32768\n", "-9999.0", mark + "-32768");
  refused("NODATA_value -3.40282e+38\n", "-3.4028234663852886e+38", "within 100000 m");
  refused("", "-3.4028234663852886e+38", "within 100000 m");
  refused("", "1e308", "within 100000 m");
  refused("", "-100001", "within 100000 m");
  for (std::string const good : {"-32768", "-9999", "-3.4028234663852886e+38", "1e308"}) {
    auto const raster = read_asc(replaced(head, "-1\n", good + "\n") + "4 5 6\n1 " + good + " 3\n", "a.asc");
    CHECK(std::isnan(raster.at(1, 0)));
  }
  CHECK(std::isnan(read_asc(replaced(head, "NODATA_value -1\n", "") + "4 5 6\n1 -9999 3\n", "a.asc").at(1, 0)));
  CHECK(read_asc(replaced(head, "NODATA_value -1\n", "") + "4 5 6\n1 -9998.9 3\n", "a.asc").at(1, 0) == -9998.9);
}

TEST_CASE("a number that marks points without a value elsewhere is a height only among others like it") {
  auto const with = [](std::string const& others, std::string const& value) {
    return read_asc(head + others + "\n510 " + value + " 530\n", "a.asc");
  };
  for (std::string const mark : {"-999", "-999.0", "9999", "65535", "99999"})
    CHECK_THROWS_WITH(with("540 550 560", mark),
                      ContainsSubstring(" at x = 115, y = 205 m is a usual mark of points without a value, and no "
                                        "other value is within 100 m of it: declare it as NODATA_value"));
  CHECK(with("-980 -900.5 -1000", "-999").at(1, 0) == -999);
  CHECK(with("9899 8000 7000", "9999").at(1, 0) == 9999);
  CHECK(with("540 550 560", "-999.01").at(1, 0) == -999.01);
  CHECK(read_asc(head + "9999 9999 9999\n9999 9999 9999\n", "a.asc").at(1, 0) == 9999);
  CHECK(std::isnan(read_asc(replaced(head, "-1", "65535") + "540 550 560\n510 65535 530\n", "a.asc").at(1, 0)));
}

TEST_CASE("a corner far beyond the Earth is refused") {
  for (std::string const name : {"xllcorner 100", "yllcorner 200"})
    CHECK_THROWS_WITH(read_asc(replaced(head, name, name.substr(0, 10) + "-1e300") + values, "a.asc"),
                      ContainsSubstring("a.asc, line 7: the coordinates of the corner must be within 1e9 m"));
  CHECK(read_asc(replaced(head, "xllcorner 100", "xllcorner 2600000") + values, "a.asc").x == 2600005);
}

TEST_CASE("a line of the head that is there twice, or beside one that says the same, is refused by its name") {
  for (auto const& [line, name] :
       {std::pair("ncols 9\n", "ncols"), std::pair("NCOLS 3\n", "NCOLS"), std::pair("nrows 2\n", "nrows"),
        std::pair("cellsize 20\n", "cellsize"), std::pair("xllcenter 105\n", "xllcenter"),
        std::pair("yllcorner 1\n", "yllcorner"), std::pair("nodata_value -9999\n", "nodata_value")}) {
    std::string const why = "a.asc, line 7: '" + std::string(name) + "' repeats a line of the head, or contradicts it";
    CHECK_THROWS_WITH(read_asc(head + line + values, "a.asc"), why);
  }
}

TEST_CASE("a cellsize in degrees is refused, one of a small raster in metres is not") {
  auto const with = [](std::string const& cellsize, std::string const& heights) {
    return read_asc(replaced(head, "cellsize 10", "cellsize " + cellsize) + heights, "a.asc");
  };
  for (std::string const degrees :
       {"0.000277778", "0.00027777777777778", "0.000833333333", "0.008333333", "0.00009259259"})
    CHECK_THROWS_WITH(with(degrees, "4 4 4\n4 4 4\n"),
                      ContainsSubstring("a.asc: the cellsize of ") && ContainsSubstring("looks like degrees"));
  for (std::string const degrees : {"0.00028", "0.001", "0.01"})
    CHECK_THROWS_WITH(with(degrees, "400 410 420\n500 510 520\n"), ContainsSubstring("looks like degrees"));
  for (std::string const metres : {"0.001", "0.0005", "0.01", "0.025", "1", "30"})
    CHECK(with(metres, "0.01 0.02 0.03\n0.01 0.02 0.025\n").columns == 3);
  CHECK_THROWS_WITH(with("1e-300", values), ContainsSubstring("a.asc, line 7: the cellsize must be 1e-6 to 1e6 m"));
}

TEST_CASE("a GeoTIFF is refused with what can be done") {
  Folder const folder;
  for (auto const& start : {std::string("II*\0", 4), std::string("MM\0*", 4)}) {
    auto const file = folder.write("dem.tif", start + head);
    CHECK_THROWS_WITH(read_raster(file), ContainsSubstring(file.string()) && ContainsSubstring("gdal_translate"));
  }
  CHECK(read_raster(folder.write("dem.asc", head + values)).values.size() == 6);
}

}  // namespace scree::test::raster_tests
