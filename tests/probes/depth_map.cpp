// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/probes/depth_map.hpp>
#include <scree/setup/lattice.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace scree::test::depth_map_tests {
namespace {
Raster grid(double x, double y, int columns, int rows, double spacing) {
  return {.columns = columns,
          .rows = rows,
          .x = x,
          .y = y,
          .spacing = spacing,
          .values = std::vector<double>(std::size_t(columns) * std::size_t(rows), -1.0)};
}
double volume_of(Raster const& map) {
  return sq(map.spacing) * std::accumulate(map.values.begin(), map.values.end(), 0.0);
}
}  // namespace

TEST_CASE("the map of a layer has its depth, whatever lies beside the map") {
  auto const layer = fill_lattice(Box<3>{{-3, -2, 0}, {5, 4, 0.4}}, 0.1);
  std::vector<double> const volumes(layer.size(), 1e-3);
  // Exact where the spacing of the map is a multiple of that of the particles.
  for (auto const& [spacing, error] : {std::pair(0.3, 1e-12), {0.25, 0.1 * 0.4}}) {
    Raster const map = depth_map(grid(0, 0, 9, 7, spacing), layer, volumes);
    for (int row = 1; row < 6; ++row)
      for (int column = 1; column < 8; ++column) CHECK(std::abs(map.at(column, row) - 0.4) < error);
  }
}

TEST_CASE("a map keeps the volume of the particles above it, to its edge") {
  Raster const like = grid(100, -3, 5, 4, 2);
  std::vector<Vec<3, double>> points;
  std::vector<double> volumes;
  for (int k = 0; k < 200; ++k) {  // no two at the same place, some within half a cell of the edge
    double const u = std::fmod(0.618034 * k, 1), v = std::fmod(0.754878 * k, 1);
    points.push_back({99 + 10 * u, -4 + 8 * v, 7});
    volumes.push_back(1 + 0.01 * k);
  }
  double const all = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  CHECK(std::abs(volume_of(depth_map(like, points, volumes)) - all) < 1e-12 * all);
  points.push_back({98.9, 0, 0}), points.push_back({103, 4.1, 0});
  volumes.push_back(5), volumes.push_back(5);
  CHECK(std::abs(volume_of(depth_map(like, points, volumes)) - all) < 1e-12 * all);
}

TEST_CASE("a particle at a point of the raster counts there alone") {
  Raster const map = depth_map(grid(0, 0, 3, 3, 2), std::vector{Vec<3, float>(2, 4, 1)}, std::vector{8.0f});
  for (std::size_t k = 0; k < 9; ++k) CHECK(map.values[k] == (k == 7 ? 2.0 : 0.0));
}

}  // namespace scree::test::depth_map_tests
