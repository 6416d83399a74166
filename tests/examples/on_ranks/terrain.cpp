// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <terrain/flow.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

namespace terrain {
namespace {

TEST_CASE("the terrain has the maps of one rank on 3 ranks, and goes on from their checkpoint") {
  Folder const folder;
  Raster ground{.name = "ground", .columns = 13, .rows = 7, .x = 0, .y = 0, .spacing = 5, .values = {}},
      release = ground;
  for (int row = 0; row < ground.rows; ++row)
    for (int column = 0; column < ground.columns; ++column) {
      ground.values.push_back(20 - 2.5 * column + 0.5 * scree::sq(row - 3));
      release.values.push_back(column > 1 && column < 6 && row > 1 && row < 5 ? 5 : 0);
    }
  scree::write_raster(folder.path / "ground.asc", ground), scree::write_raster(folder.path / "release.asc", release);
  auto const run = [&](int ranks, double duration, std::string const& name, std::string const& from = {}) {
    Options o;
    o.ground = {(folder.path / "ground.asc").string(), (folder.path / "release.asc").string()};
    o.numerics.spacing = 2, o.numerics.ranks = ranks;
    o.output = {.duration = duration,
                .maps = 0.25,
                .history = 0.125,
                .cell = 5,
                .least = 0.1,
                .checkpoints = 1e9,
                .restart_from = from};
    auto const output = folder.path / name;
    run_in(output, o, simulate<double>);
    auto text = table_in(output / "history.csv") + summary_in(output / "summary.json");
    for (auto const* each : {"depth_00.asc", "depth_02.asc", "largest_depth.asc", "arrival.asc"})
      text += content_of(output / each);
    return text;
  };
  auto const whole = run(1, 0.5, "whole");
  CHECK(whole.size() > 2'000);
  CHECK((run(3, 0.5, "ranks") == whole));
  run(3, 0.25, "half");
  CHECK((run(2, 0.5, "rest", (folder.path / "half/checkpoint.h5").string()) == whole));
}

}  // namespace
}  // namespace terrain
