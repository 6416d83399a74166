// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <blender/blender.hpp>

#include "../../setup/mesh/bodies.hpp"

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

#include <fstream>

namespace blender {
namespace {

TEST_CASE("the blender has the results of one rank on 3 ranks, and goes on from their checkpoint") {
  Folder const folder;
  auto const vessel = folder.path / "vessel.stl";
  std::ofstream(vessel) << scree::test::ascii_stl(scree::test::sphere_mesh(1, 8));
  auto const run = [&](int ranks, double turns, std::string const& name, std::string const& from = {}) {
    Options o;
    o.vessel.file = vessel.string(), o.vessel.scale = 0.08;
    o.numerics.spacing = 0.016, o.numerics.ranks = ranks;
    o.output = {
        .turns = turns, .history = 0.005, .frames = 0.01, .sample = 2, .checkpoints = 1e9, .restart_from = from};
    auto const output = folder.path / name;
    run_in(output, o, simulate<double, TwoSizes>);
    return results_of(output, "history.csv", "particles.vtkhdf", "summary.json");
  };
  auto const whole = run(1, 0.02, "whole");
  CHECK(whole.size() > 5'000);
  CHECK((run(3, 0.02, "ranks") == whole));
  run(3, 0.01, "half");
  CHECK((run(1, 0.02, "rest", (folder.path / "half/checkpoint.h5").string()) == whole));
}

}  // namespace
}  // namespace blender
