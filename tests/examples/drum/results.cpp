// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/folder.hpp>
#include "known_bed.hpp"

#include <drum/results.hpp>
#include <scree/io/hdf5_table.hpp>

#include <fmt/ranges.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::drum_results_tests {
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

scree::app::Run<drum::Options> run_in(std::filesystem::path const& output) {
  scree::app::Run<drum::Options> run{.output = output, .quiet = true};
  run.options.numerics.spacing = 1e-3;
  run.options.time.duration = 3;
  run.options.output.profile_times = {1, 2, 3};
  return run;
}

drum::State state_at(double time) {
  bed::Known const k{.spacing = 1e-3, .surface_excess = 0.06 + 0.001 * time};
  auto state = bed::state_of(k);
  state.time = time, state.steps = std::lround(1000 * time);
  return state;
}

double time_of(long row) { return 0.05 * double(row); }

scree::PointData frame_at(double time) {
  std::vector<double> const xyz = {1, 0, 2, 3, 0, 4};
  return {.time = time,
          .xyz = xyz,
          .arrays = {{"velocity", 3, xyz, "m/s"}, {"body", 1, std::vector<std::int32_t>{0, 1}, "1"}}};
}

/// A row of the history every 0.05 s, a frame every 0.5 s, both row numbers included.
void record(drum::Results& results, long first_row, long last_row) {
  for (long row = first_row; row <= last_row; ++row) {
    results.add_history(state_at(time_of(row)));
    if (row % 10 == 0) results.add_frame(frame_at(time_of(row)));
  }
}
std::vector<double> frame_times(std::filesystem::path const& output) {
  scree::hdf5::Handle const file{H5Fopen((output / "particles.vtkhdf").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
  return scree::hdf5::read_rows<double>(file, "VTKHDF/Steps/Values");
}

scree::app::Figures figures_at(double time) {
  return {.time = time,
          .steps = std::lround(1000 * time),
          .neighbour_builds = 7,
          .particles = 1490,
          .wall_particles = 688,
          .steps_by_limit = {{"sound", 10}, {"force", 2}},
          .execution_space = "OpenMP"};
}

std::string without_clock(std::filesystem::path const& history) {
  std::string text;
  for (auto const& m : drum::read_history(history, 1e9)) {
    auto row = drum::row_of(m);
    row[2] = 0;
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  return text;
}

}  // namespace

TEST_CASE("the drum writes its tables and its summary") {
  Folder const folder;
  {
    drum::Results results(run_in(folder.path));
    record(results, 0, 60);
    results.finish(figures_at(3));
  }
  for (auto const* name : {"summary.json", "profiles.csv", "radial.csv", "history.csv", "particles.vtkhdf"})
    CHECK(std::filesystem::file_size(folder / name) > 0);
  auto const history = drum::read_history(folder / "history.csv", 1e9);
  CHECK(history.size() == 61);
  CHECK(history.back().time == Approx(3));
  CHECK(history.back().surface_speed > history.front().surface_speed);
  CHECK(history.back().wall_seconds >= history.front().wall_seconds);

  auto const profiles = drum::read_profiles(folder / "profiles.csv", 1e9);
  REQUIRE(profiles.size() == 3);
  CHECK(profiles[1].time == 2);
  CHECK(profiles[1].samples == 10);  // half a second
  CHECK(profiles[1].angle == Approx(22).margin(0.1));
  CHECK(profiles[1].rows.size() >= 28);
  CHECK(drum::read_table(folder / "radial.csv").rows.size() >= 3 * 16);

  auto const summary = content_of(folder / "summary.json");
  for (auto const* name : {"particles",
                           "steps",
                           "dt",
                           "rebuilds",
                           "wall_seconds",
                           "microseconds_per_step",
                           "steps_by_limit",
                           "mean_C_drift",
                           "min_C",
                           "max_C",
                           "surface_angle",
                           "surface_speed",
                           "active_depth_over_bed_depth",
                           "lost_particles",
                           "largest_speed_over_sound_speed",
                           "artificial_dynamic_viscosity",
                           "granular_dynamic_viscosity",
                           "surface_scatter",
                           "layer_depth",
                           "Lambda",
                           "time_in_turns",
                           "bed_depth_variation",
                           "velocity_difference_from_last"})
    CHECK_THAT(summary, ContainsSubstring(fmt::format("\"{}\"", name)));
}

TEST_CASE("a continued run of the drum leaves the files of an uninterrupted one, wherever its checkpoint falls") {
  auto const in = [](std::filesystem::path const& output) {
    auto run = run_in(output);
    run.options.output.profile_times = {1, 1.97, 2, 3};  // one between two rows
    return run;
  };
  Folder const whole;
  scree::app::Figures const figures = figures_at(3);
  {
    drum::Results results(in(whole.path));
    record(results, 0, 60);
    results.finish(figures);
  }
  REQUIRE(drum::read_profiles(whole / "profiles.csv", 1e9).size() == 4);
  // On a row, between two, at a profile, within its average, before and after its time, at the end.
  auto const [row, behind, in_place] = GENERATE(table<long, double, bool>({{42, 0, false},
                                                                           {42, 0, true},
                                                                           {39, 0.01, false},
                                                                           {39, 0.03, true},
                                                                           {40, 0, false},
                                                                           {57, 0.02, true},
                                                                           {60, 0, true},
                                                                           {2, 0.01, true}}));
  INFO("row " << row << " and " << behind << " s");
  Folder const first, second;
  drum::Start start{.time = time_of(row) + behind};
  {
    drum::Results results(in(first.path));
    record(results, 0, row);
    start.memory = results.memory();
    record(results, row + 1, std::min(60L, row + 4));  // beyond the checkpoint
  }
  auto const& output = in_place ? first : second;
  auto run = in(output.path);
  run.options.output.restart_from = (first / "checkpoint.h5").string();
  {
    drum::Results results(run, start);
    record(results, row + 1, 60);
    results.finish(figures);
  }
  bool const same_history = without_clock(output / "history.csv") == without_clock(whole / "history.csv");
  CHECK(same_history);
  bool const same_profiles = content_of(output / "profiles.csv") == content_of(whole / "profiles.csv");
  CHECK(same_profiles);  // without their text, which is long
  CHECK(content_of(output / "radial.csv") == content_of(whole / "radial.csv"));
  CHECK(frame_times(output.path) == frame_times(whole.path));
  CHECK(frame_times(output.path).size() == 7);
}

TEST_CASE("the states of a profile survive as numbers") {
  drum::Window window;
  drum::Drum const d = drum::drum_of(run_in("").options);
  for (double const time : {1.0, 1.1}) {
    auto const state = drum::seen_clockwise(state_at(time), d);
    window.emplace_back().time = time;
    window.back().chord.add(state, drum::fit_surface(state, d), d);
    window.back().rings.add(state, d);
  }
  auto const numbers = drum::pack(window);
  CHECK(numbers.size() > 100);
  CHECK(drum::pack(drum::unpack(numbers)) == numbers);
  CHECK(drum::unpack({}).empty());
  std::span<double const> const all(numbers);
  CHECK_THROWS(drum::unpack(all.first(all.size() - 1)));
  for (double const size : {-1.0, 1e18, std::nan("")})
    CHECK_THROWS(drum::unpack(std::vector<double>{1, 2, 3, 4, 5, 6, size}));
}

TEST_CASE("a drum that continues from nowhere, or is no longer finite, stops with the reason") {
  Folder const folder;
  auto run = run_in(folder.path);
  {
    drum::Results results(run);
    auto state = state_at(0);
    state.stress[5] = std::nan("");
    CHECK_THROWS_WITH(results.add_history(state), ContainsSubstring("no longer finite at 0.000 s"));
  }
  Folder const other;
  auto continued = run_in(other.path);
  continued.options.output.restart_from = "/nowhere/checkpoint.h5";
  CHECK_THROWS_WITH(drum::Results(continued, {.time = 1}), ContainsSubstring("/nowhere/history.csv: cannot read it"));
  continued.options.output.restart_from = (folder / "checkpoint.h5").string();
  CHECK_THROWS_WITH(drum::Results(continued, {.time = 4}),
                    ContainsSubstring("time.duration: 3 s is over at the start"));
  CHECK(std::filesystem::is_empty(other.path));  // as it was
  std::ofstream(folder / "particles.vtkhdf") << "damaged";
  CHECK_THROWS_WITH(drum::Results(continued, {.time = 1}), ContainsSubstring("particles.vtkhdf: cannot read it"));
  CHECK(std::filesystem::is_empty(other.path));
  std::ofstream(folder / "history.csv") << "time,steps\n";
  std::ofstream(folder / "history.csv", std::ios::app) << "0,0\n";
  CHECK_THROWS_WITH(drum::Results(continued, {.time = 1}),
                    ContainsSubstring((folder / "history.csv: there is no column ").string()));
}

}  // namespace scree::test::drum_results_tests
