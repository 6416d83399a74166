// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../support/folder.hpp"
#include "known_bed.hpp"

#include <drum/recorder.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

support::Run<drum::Options> run_in(std::filesystem::path const& output) {
  support::Run<drum::Options> run{.output = output, .quiet = true};
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

void record(drum::Recorder& recorder, double from, double to) {
  for (long k = std::lround(from / 0.05); k <= std::lround(to / 0.05); ++k)
    recorder.record_history(state_at(0.05 * double(k)));
}

drum::Frame frame_at(double time) {
  drum::Frame frame;
  frame.time = time;
  frame.xyz = frame.velocity = frame.free_surface_normal = frame.wall_normal = {1, 0, 2, 3, 0, 4};
  frame.stress.assign(12, -1);
  frame.C = frame.shear_rate = frame.number_density = frame.V = frame.D = {0.5, 0};
  frame.surface_set = frame.body = frame.identity = {0, 1};
  return frame;
}

drum::RunFigures figures_at(double time) {
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

TEST_CASE("the drum's recorder writes its tables and its summary") {
  Folder const folder;
  {
    drum::Recorder recorder(run_in(folder.path));
    recorder.record_frame(frame_at(0));
    record(recorder, 0, 3);
    recorder.record_frame(frame_at(3));
    recorder.finish(figures_at(3));
  }
  for (auto const& name : drum::result_files()) CHECK(std::filesystem::file_size(folder / name) > 0);
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
  for (auto const* name :
       {"particles", "steps", "dt", "rebuilds", "wall_seconds", "microseconds_per_step", "steps_by_limit",
        "mean_C_drift", "min_C", "max_C", "surface_angle", "surface_speed", "active_depth_over_bed_depth",
        "lost_particles", "largest_speed_over_sound_speed", "artificial_dynamic_viscosity",
        "granular_dynamic_viscosity", "bed_depth_variation", "velocity_difference_from_last"})
    CHECK_THAT(summary, ContainsSubstring(fmt::format("\"{}\"", name)));
}

TEST_CASE("a continued run of the drum leaves the tables of an uninterrupted one") {
  Folder const whole, first, second;
  {
    drum::Recorder recorder(run_in(whole.path));
    record(recorder, 0, 3);
  }
  {
    drum::Recorder recorder(run_in(first.path));
    record(recorder, 0, 2.3);  // beyond the checkpoint
  }
  auto run = run_in(second.path);
  run.options.time.restart_from = (first / "checkpoint.h5").string();
  {
    drum::Recorder recorder(run, 2.1);
    record(recorder, 2.1, 3);
    recorder.finish(figures_at(3));
  }
  bool const same_history = without_clock(second / "history.csv") == without_clock(whole / "history.csv");
  CHECK(same_history);
  bool const same_profiles = content_of(second / "profiles.csv") == content_of(whole / "profiles.csv");
  CHECK(same_profiles);  // without their text, which is long
  CHECK(content_of(second / "radial.csv") == content_of(whole / "radial.csv"));
}

TEST_CASE("a drum that continues from nowhere, or is no longer finite, stops with the reason") {
  Folder const folder;
  auto run = run_in(folder.path);
  {
    drum::Recorder recorder(run);
    auto state = state_at(0);
    state.stress[5] = std::nan("");
    CHECK_THROWS_WITH(recorder.record_history(state), ContainsSubstring("no longer finite at 0.000 s"));
  }
  Folder const other;
  auto continued = run_in(other.path);
  continued.options.time.restart_from = "/nowhere/checkpoint.h5";
  CHECK_THROWS_WITH(drum::Recorder(continued, 1), ContainsSubstring("/nowhere/history.csv: cannot read it"));
}
