// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../io/hdf5_file.hpp"
#include "still.hpp"

#include <support/folder.hpp>

#include <scree/probes/coarse_series.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace scree::test::coarse_series_tests {
using namespace fields;
namespace {

bool near(double a, double b) { return std::abs(a - b) < 1e-9; }
using Block = Solver<Still<2>>;
Block moving_block() {
  auto block = unit_block<2>();
  block.set(velocity, [](auto const& x) { return Vec<2, double>(x[1], 0); });
  block.set(concentration, [](auto const& x) { return x[1]; });
  return block;
}
CoarseGrid<2> const grid{.box = {{0.2, 0}, {0.8, 1}}, .cell = {0.3, 0.25}};
std::vector<std::vector<double>> rows_of(std::string const& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line);
    rows.emplace_back();
    for (std::string number; std::getline(numbers, number, ',');) rows.back().push_back(std::stod(number));
  }
  return rows;
}

}  // namespace

TEST_CASE("coarse-grained fields are written at each time as points in space") {
  Folder const folder;
  auto block = moving_block();
  CoarseSeries series(folder / "coarse.vtkhdf", grid, Fields<Velocity, Stress, Pressure>{});
  block.run(0.2, {every<Block>(0.1, [&](Block& now) { series.append(now); })});
  CHECK(series.steps() == 3);
  File const file(folder / "coarse.vtkhdf");
  CHECK(file.read<double>("VTKHDF/Steps/Values").size() == 3);
  auto const points = file.read<double>("VTKHDF/Points"), weight = file.read<double>("VTKHDF/PointData/weight"),
             u = file.read<double>("VTKHDF/PointData/velocity"), p = file.read<double>("VTKHDF/PointData/pressure");
  REQUIRE(weight.size() == 3 * 8);
  REQUIRE(u.size() == 3 * 24);
  CHECK(p.size() == 24);
  CHECK(file.read<double>("VTKHDF/PointData/stress").size() == 6 * 24);
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(near(points[3 * k], k % 2 == 0 ? 0.35 : 0.65));
    CHECK(points[3 * k + 1] == 0);
    CHECK(near(points[3 * k + 2], 0.125 + 0.25 * double(k / 2)));
    CHECK(near(u[3 * k], points[3 * k + 2]));  // the velocity is the height
    CHECK(u[3 * k + 2] == 0);
  }
  CHECK_THROWS_AS(CoarseSeries(folder / "other.vtkhdf", CoarseGrid<2>{}, Fields<Velocity>{}).append(block),
                  std::invalid_argument);
}

TEST_CASE("coarse-grained fields go on after a restart") {
  Folder const folder;
  auto block = moving_block();
  {
    CoarseSeries series(folder / "coarse.vtkhdf", grid, Fields<Velocity>{});
    block.run(0.2, {every<Block>(0.1, [&](Block& now) { series.append(now); })});
  }
  auto continued = CoarseSeries<2, Fields<Velocity>>::continued(folder / "coarse.vtkhdf", 0.1, folder / "rest.vtkhdf",
                                                                grid, Fields<Velocity>{});
  CHECK(continued.steps() == 2);
  continued.append(block);
  File const first(folder / "coarse.vtkhdf"), rest(folder / "rest.vtkhdf");
  for (char const* name : {"VTKHDF/Steps/Values", "VTKHDF/Points", "VTKHDF/PointData/velocity"})
    CHECK(rest.read<double>(name) == first.read<double>(name));
}

TEST_CASE("profiles are a table with a row for each height, and go on after a restart") {
  Folder const folder;
  auto block = moving_block();
  ProfileSeries profiles(folder / "profiles.csv", grid, 1, Fields<Velocity, Concentration>{});
  auto const append = [&](auto& to) { return every<Block>(0.1, [&](Block& now) { to.append(now); }); };
  block.run(0.1, {append(profiles)});
  auto const text = content_of(folder / "profiles.csv");
  CHECK(text.substr(0, text.find('\n')) ==
        "time [s],z [m],weight,velocity x [m/s],velocity y [m/s],velocity z [m/s],concentration");
  auto const rows = rows_of(text);
  REQUIRE(rows.size() == 8);
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(near(rows[k][0], k < 4 ? 0 : 0.1));
    CHECK(near(rows[k][1], 0.125 + 0.25 * double(k % 4)));
    CHECK(rows[k][2] > 0.5);
    CHECK(near(rows[k][3], rows[k][1]));
    CHECK(near(rows[k][6], rows[k][1]));
  }
  auto continued = ProfileSeries<2, Fields<Velocity, Concentration>>::continued(
      folder / "profiles.csv", 0.05, folder / "profiles.csv", grid, 1, Fields<Velocity, Concentration>{});
  CHECK(rows_of(content_of(folder / "profiles.csv")).size() == 4);
  continued.append(block);
  CHECK(content_of(folder / "profiles.csv") == text);
  CHECK_THROWS_AS(ProfileSeries(folder / "none.csv", grid, 2, Fields<Velocity>{}), std::invalid_argument);
}

}  // namespace scree::test::coarse_series_tests
