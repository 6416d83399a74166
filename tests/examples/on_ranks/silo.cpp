// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <silo/silo.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

namespace silo {
namespace {

TEST_CASE(
    "the silo has the results of one rank on 3 ranks while grains leave it, and continues from their checkpoint") {
  Folder const folder;
  auto const run = [&](int ranks, std::string const& name, double duration = 0.2, std::string const& from = {}) {
    Options o;
    o.geometry = {.width = 0.06, .height = 0.06, .outlet = 0.03};
    o.numerics.spacing = 0.004, o.numerics.ranks = ranks;
    o.output = {.opens = 0.02, .duration = duration, .interval = 0.01, .frames = 0.05, .restart_from = from};
    auto const output = folder.path / name;
    run_in(output, o, simulate<2, TwoSizes>);
    return results_of(output, "history.csv", "particles.vtkhdf", "summary.json");
  };
  auto const whole = run(1, "whole");
  CHECK(whole.size() > 20'000);
  CHECK(whole.find("\"removed\" : 0,") == std::string::npos);
  CHECK((run(3, "ranks") == whole));
  run(3, "half", 0.13);
  CHECK((run(1, "rest", 0.2, (folder.path / "half/checkpoint.h5").string()) == whole));
}

}  // namespace
}  // namespace silo
