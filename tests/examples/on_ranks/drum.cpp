// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <drum/simulate.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

// The example drum on ranks: its files are those of one rank, apart from times of the clock, also when it continues a
// checkpoint of another number of ranks.
namespace drum {
namespace {

namespace fs = std::filesystem;
double const end = 0.12;  // s

Options coarse() {
  Options o;
  o.numerics.spacing = 0.0035;
  o.numerics.filter_period = 3;
  o.time.duration = end;
  o.output.history_interval = 0.02;
  o.output.frame_interval = 0.06;
  o.output.profile_times = {0.06, 0.1, 0.12};
  o.output.profile_average = 0.05;
  return o;
}
std::string run(Options o, int ranks, fs::path const& folder) {
  fs::create_directories(folder);
  o.numerics.ranks = ranks;
  app::Run<Options> const run{.options = o, .output = folder, .quiet = true};
  REQUIRE(simulate<2, double, Scheme::conservative>(run, {}) == 0);
  return results_of(folder, "history.csv", "profiles.csv", "radial.csv", "particles.vtkhdf");
}

TEST_CASE("the drum has the results of one rank on 2, 3 and 4 ranks") {
  Folder const folder;
  auto const whole = run(coarse(), 1, folder.path / "1");
  CHECK(whole.size() > 20'000);
  for (int const ranks : {2, 3, 4}) CHECK((run(coarse(), ranks, folder.path / std::to_string(ranks)) == whole));
}

TEST_CASE("the drum goes on from a checkpoint of other ranks, in its folder or in another one") {
  Folder const folder;
  auto const whole = run(coarse(), 1, folder.path / "whole");
  for (auto const& [before, after] : {std::pair(4, 1), {1, 4}}) {
    auto const first = folder.path / std::to_string(before);
    auto half = coarse();
    half.time.duration = 0.02;    // there is a row of history.csv, so that no step is shorter
    half.output.checkpoints = 0;  // one after each step
    CHECK((run(half, before, first) != whole));
    auto rest = coarse();
    rest.output.restart_from = (first / "checkpoint.h5").string();
    CHECK((run(rest, after, folder.path / "rest" / std::to_string(after)) == whole));
    CHECK((run(rest, after, first) == whole));
  }
}

}  // namespace
}  // namespace drum
