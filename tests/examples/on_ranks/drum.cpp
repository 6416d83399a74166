// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <drum/simulate.hpp>
#include <drum/tables.hpp>

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
  REQUIRE(simulate<2, double, TwoSizes<Scheme::conservative>>(run, {}) == 0);
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

/// A list of sizes; `tables` without times of the clock, and frames.
std::string run(app::SpeciesList const& list, fs::path const& folder, int ranks = 1, Options o = coarse()) {
  fs::create_directories(folder);
  o.segregation.closure = Closure::schlick;
  o.species = list;
  o.numerics.ranks = ranks;
  app::Run<Options> const run{.options = o, .output = folder, .quiet = true};
  REQUIRE(simulate<2, double, ListOfSizes>(run, {}) == 0);
  return results_of(folder, "history.csv", "species.csv", "profiles.csv", "radial.csv", "particles.vtkhdf");
}
/// A column of a table.
std::vector<double> column(fs::path const& file, std::string const& name) {
  auto const table = read_table(file);
  std::vector<double> values;
  for (auto const& row : table.rows) values.push_back(table.value(row, name));
  return values;
}
double difference(std::vector<double> const& a, std::vector<double> const& b) {
  REQUIRE(a.size() == b.size());
  REQUIRE(a.size() > 3);
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    REQUIRE(std::isfinite(a[k] - b[k]));
    most = std::max(most, std::abs(a[k] - b[k]));
  }
  return most;
}
app::SpeciesList const three_sizes{.diameters = {0.25e-3, 0.4e-3, 0.64e-3}, .shares = {0.35, 0.35, 0.3}};

TEST_CASE("a drum of three sizes has the results of one rank on others, and after a restart") {
  Folder const folder;
  auto const whole = run(three_sizes, folder.path / "1");
  for (int const ranks : {2, 3}) CHECK((run(three_sizes, folder.path / std::to_string(ranks), ranks) == whole));
  auto half = coarse();
  half.time.duration = 0.02, half.output.checkpoints = 0;
  CHECK((run(three_sizes, folder.path / "half", 2, half) != whole));
  auto rest = coarse();
  rest.output.restart_from = (folder.path / "half/checkpoint.h5").string();
  CHECK((run(three_sizes, folder.path / "rest", 1, rest) == whole));

  auto const table = folder.path / "1/species.csv";
  auto const C1 = column(table, "C1_mean"), C2 = column(table, "C2_mean"), C3 = column(table, "C3_mean");
  for (std::size_t k = 0; k < C1.size(); ++k) {
    CHECK(std::abs(C1[k] - 0.35) + std::abs(C2[k] - 0.35) + std::abs(C3[k] - 0.3) < 1e-13);
  }
  CHECK(column(table, "C1_max").back() > 0.3501);
  CHECK(column(table, "C3_max").back() > 0.3001);
  // Profiles of the smallest grains have two names.
  auto const profiles = folder.path / "1/profiles.csv";
  CHECK(difference(column(profiles, "C"), column(profiles, "C1")) == 0);
  auto const sum = [&](char const* file) {
    auto all = column(folder.path / "1" / file, "C1");
    for (char const* name : {"C2", "C3"}) {
      auto const C = column(folder.path / "1" / file, name);
      for (std::size_t k = 0; k < C.size(); ++k) all[k] += C[k];
    }
    return all;
  };
  for (char const* file : {"profiles.csv", "radial.csv"})
    for (double const one : sum(file)) CHECK(std::abs(one - 1) < 1e-12);
}

// The mean diameter and the sums over pairs have another order, so that the last digits differ and grow with the flow.
TEST_CASE("the order of a list of sizes is that of its columns and nothing else") {
  Folder const folder;
  run(three_sizes, folder.path / "a");
  run({.diameters = {0.64e-3, 0.25e-3, 0.4e-3}, .shares = {0.3, 0.35, 0.35}}, folder.path / "b");
  auto const a = folder.path / "a/species.csv", b = folder.path / "b/species.csv";
  // C is that of the smallest grains.
  CHECK(difference(column(folder.path / "b/profiles.csv", "C"), column(folder.path / "b/profiles.csv", "C2")) == 0);
  for (std::string const told : {"_min", "_max", "_surface"}) {
    CHECK(difference(column(a, "C1" + told), column(b, "C2" + told)) < 1e-8);
    CHECK(difference(column(a, "C2" + told), column(b, "C3" + told)) < 1e-8);
    CHECK(difference(column(a, "C3" + told), column(b, "C1" + told)) < 1e-8);
  }
}

TEST_CASE("an absent size changes nothing, and two that are alike stay in proportion") {
  Folder const folder;
  run(three_sizes, folder.path / "three");
  run({.diameters = {0.25e-3, 0.4e-3, 0.64e-3, 0.5e-3}, .shares = {0.35, 0.35, 0.3, 0}}, folder.path / "absent");
  auto const absent = folder.path / "absent/species.csv";
  for (std::string const name : {"C1_max", "C2_min", "C3_surface"})
    CHECK(column(absent, name) == column(folder.path / "three/species.csv", name));
  for (std::string const told : {"C4_min", "C4_max"})
    for (double const C : column(absent, told)) CHECK(C == 0);

  run({.diameters = {0.25e-3, 0.25e-3, 0.5e-3}, .shares = {0.2, 0.3, 0.5}}, folder.path / "alike");
  auto const alike = folder.path / "alike/profiles.csv";
  auto of_second = column(alike, "C1");
  for (double& C : of_second) C *= 1.5;
  CHECK(difference(column(alike, "C2"), of_second) < 1e-12);
}

TEST_CASE("a list of two sizes is the drum of two sizes") {
  Folder const folder;
  app::SpeciesList const two_sizes{.diameters = {0.25e-3, 0.5e-3}, .shares = {0.5, 0.5}};
  run(two_sizes, folder.path / "list");
  auto o = coarse();
  o.segregation.closure = Closure::schlick;
  run(o, 1, folder.path / "two");
  for (std::string const name : {"C_surface", "C_min", "C_max", "C_deviation", "intensity"})
    CHECK(difference(column(folder.path / "list/history.csv", name), column(folder.path / "two/history.csv", name)) <
          1e-8);
  CHECK(column(folder.path / "two/history.csv", "C_max").back() > 0.5001);
}

}  // namespace
}  // namespace drum
