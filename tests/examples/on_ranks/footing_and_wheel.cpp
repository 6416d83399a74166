// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <footing_and_wheel/bed.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace footing_and_wheel {
namespace {

TEST_CASE("the wheel has the results of one rank on 3 ranks, and continues from their checkpoint") {
  Folder const folder;
  auto const run = [&](int ranks, std::string const& name, std::string const& from = {}) {
    Options o;
    o.numerics.spacing = 0.01, o.numerics.ranks = ranks;
    o.output = {.duration = 0.05,
                .interval = 0.01,
                .frames = 0.05,
                .checkpoints = from.empty() ? 0 : 1e9,
                .restart_from = from};
    auto const output = folder.path / name;
    run_in(output, o, simulate<double>);
    return table_in(output / "history.csv") + summary_in(output / "summary.json");
  };
  auto const whole = run(1, "whole");
  CHECK(whole.size() > 500);
  CHECK((run(3, "ranks") == whole));
  // The checkpoint before the last one: the means are of the second half of the run.
  CHECK((run(1, "rest", (folder.path / "ranks/checkpoint.previous.h5").string()) == whole));
}

TEST_CASE("a soil that its weight would crush leaves the results of an earlier run, on 1 and on 2 ranks") {
  for (int const ranks : {1, 2}) {
    Folder const folder;
    for (auto const* name : {"history.csv", "case.toml"}) folder.write(name, name);
    Options o;
    o.numerics.spacing = 0.01, o.numerics.ranks = ranks;
    o.soil.young = 1;
    auto const run = [&] {
      auto const directory = std::make_shared<app::OutputDirectory const>(
          app::OutputRequest{.directory = folder.path, .results = {"history.csv"}, .force = true});
      return simulate<double>({.options = o, .output = folder.path, .quiet = true, .directory = directory});
    };
    CHECK_THROWS_WITH(run(), Catch::Matchers::ContainsSubstring("would crush it"));
    o.soil.young = 2e5, o.bed.depth = 1e-3;
    CHECK_THROWS_WITH(run(), Catch::Matchers::ContainsSubstring("no particles"));
    for (auto const* name : {"history.csv", "case.toml"}) CHECK(content_of(folder / name) == name);
  }
}

}  // namespace
}  // namespace footing_and_wheel
