// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../io/hdf5_file.hpp"
#include "on_ranks.hpp"

#include <support/folder.hpp>
#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/checkpoints.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/io/write_raster.hpp>
#include <scree/probes/depth_map.hpp>
#include <scree/probes/plane_flux.hpp>
#include <scree/probes/points.hpp>
#include <scree/probes/region.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/wall_loads.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

// One file of each kind for a case on ranks, with the content that one rank writes.
namespace scree::test::output_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

struct Column : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
  using diagnostics = WallForces;
};
double const dr = 0.01;

Groups<2> walls() {
  auto const all = wall_around(Box<2>{{0, 0}, {0.8, 0.5}}, dr, 4);
  std::vector<Vec<2, double>> floor, sides;
  for (auto const& x : all) (x[1] < 0 ? floor : sides).push_back(x);
  return Groups<2>().add("sides", sides).add("floor", floor);
}
template <class F>
Solver<F> column(Space const& space, SolverSettings<F> settings, Groups<2> const& wall) {
  settings.spacing = dr;
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {0.2, 0.3}}, dr), wall);
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(1, 0.1 * x[1]); });
  return solver;
}
/// The content of a file; for HDF5 files their values, which may be stored in another order.
std::string values_in(fs::path const& file) {
  std::string text;
  auto const add = [&](auto const& values) {
    text.append(reinterpret_cast<char const*>(values.data()), values.size() * sizeof(values[0]));
    text += '|';
  };
  if (file.extension() == ".vtkhdf") {
    File const series(file);
    add(series.read<double>("VTKHDF/Steps/Values"));
    for (std::string const name : {"Points", "PointData/velocity", "PointData/stress"})
      add(series.read<double>("VTKHDF/" + name));
    add(series.read<std::int32_t>("VTKHDF/PointData/body"));
    add(series.counts("NumberOfPoints"));
  } else if (file.extension() == ".h5") {
    auto const snapshot = read_checkpoint(file);
    text = snapshot.signature + std::to_string(snapshot.steps);
    add(std::vector{snapshot.time});
    for (auto const& [name, count] : snapshot.counters)
      if (name != "neighbours/unsettled") text += name + std::to_string(count);  // counts on ranks only
    for (auto const& array : snapshot.arrays) text += array.name, add(array.bytes);
  } else {
    text = content_of(file);
  }
  return text;
}
std::map<std::string, std::string> files_in(Folder const& folder) {
  std::map<std::string, std::string> all;
  for (auto const& entry : fs::directory_iterator(folder.path))
    all[entry.path().filename().string()] = values_in(entry.path());
  return all;
}

/// A run with everything that writes files, as a program without ranks has it.
template <class F>
void write_all(Space const& space, SolverSettings<F> const& settings, Folder const& folder) {
  using S = Solver<F>;
  auto const wall = walls();
  auto solver = column<F>(space, settings, wall);
  BodySeries output(folder / "particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{});
  CsvSeries history(folder / "history.csv", {{"time", "s"},
                                             {"load", "N"},
                                             {"moment", "N m"},
                                             {"power", "W"},
                                             {"passed", "m^2"},
                                             {"mean", "m/s"},
                                             {"stress", "Pa"},
                                             {"lost"}});
  PlaneFlux<2> flux(solver, {.point = {0.25, 0}, .normal = {1, 0}});
  Raster const like{.columns = 9, .rows = 9, .x = 0, .y = 0, .spacing = 0.1, .values = std::vector(81, 0.0)};
  auto const observe = [&](S& now) {
    output.append(now);
    auto const load = wall_load(now, wall, "floor", {0.1, 0.2});
    auto const mean = mean_in(now, velocity, Box<2>{{0.1, 0.02}, {0.3, 0.2}});
    auto const at = mean_at(now, stress, {{0.1, 0.05}, {0.2, 0.05}});
    history.row({now.time(), load.force[1], load.moment, load.power, flux.passed(now).net(), mean.value[0],
                 at[0].value[0], double(now.lost())});
  };
  Checkpoints checkpoints({.file = folder / "checkpoint.h5", .interval = 1e9, .time_interval = 0.03});
  run_with(solver, 0.1, {every<S>(0.02, observe)}, checkpoints);
  write_raster(folder / "map.asc", depth_map(like, solver));
}
std::map<std::string, std::string> written_on(int ranks) {
  Folder const folder;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Column>> settings;
    settings.ranks.team = team;
    write_all<OnRanks<Column>>(space, settings, folder);
  });
  return files_in(folder);
}

/// How a rank ended.
struct End {
  long steps;
  bool stopped;
  int code;
};

}  // namespace

TEST_CASE("a case on ranks writes the files of one rank") {
  Folder const folder;
  write_all<Whole<Column>>(Space(), {}, folder);
  auto const whole = files_in(folder);
  CHECK(whole.size() == 5);
  for (int ranks : {1, 2, 3, 4}) {
    auto const files = written_on(ranks);
    for (auto const& [name, content] : whole) {
      INFO(name << " of " << ranks << " ranks");
      REQUIRE(files.count(name) == 1);
      CHECK(bool(files.at(name) == content));
    }
    CHECK(files.size() == whole.size());
  }
}

TEST_CASE("a signal stops all ranks after one step, with one checkpoint to go on from") {
  Folder const folder;
  auto const run = [&](int ranks, bool raise, fs::path const& from) {
    std::vector<std::tuple<long, bool, int>> ends;
    std::uint64_t hash = 0;
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      using F = OnRanks<Column>;
      SolverSettings<F> settings;
      settings.ranks.team = team;
      auto solver = column<F>(space, settings, walls());
      Checkpoints checkpoints({.file = folder / "checkpoint.h5", .interval = 1e9});
      if (!from.empty()) solver.restore(checkpoints.read(from));
      run_with(solver, 0.06,
               {every<Solver<F>>(0.02,
                                 [&](auto& now) {
                                   if (raise && now.time() > 0.03 && team.rank() == 1) std::raise(SIGTERM);
                                 })},
               checkpoints);
      auto const all = team.gather(End{solver.steps(), checkpoints.interrupted(), checkpoints.exit_code()});
      auto const found = state_hash(solver);
      if (team.rank() != 0) return;
      for (auto const& each : all) ends.emplace_back(each.steps, each.stopped, each.code);
      hash = found;
    });
    return std::tuple(ends, hash);
  };
  auto const [whole, end] = run(1, false, {});
  auto const [stopped, hash] = run(3, true, {});
  for (auto const& each : stopped) CHECK(each == std::tuple(std::get<0>(stopped[0]), true, 128 + SIGTERM));
  CHECK(std::get<0>(stopped[0]) < std::get<0>(whole[0]));
  auto const [again, same] = run(2, false, folder / "checkpoint.h5");
  CHECK(again[0] == std::tuple(std::get<0>(whole[0]), false, 0));
  CHECK(same == end);
}

TEST_CASE("a checkpoint that is due on one rank is written by all, after the same step") {
  Folder const folder;
  run_on_threads<Space>(3, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Column>> settings;
    settings.ranks.team = team;
    auto solver = column<OnRanks<Column>>(space, settings, walls());
    auto const clock = [&] { return team.rank() == 1 && solver.steps() >= 5 ? 100.0 : 0.0; };
    Checkpoints checkpoints({.file = folder / "checkpoint.h5", .interval = 50, .seconds = clock});
    run_with(solver, 0.005, {}, checkpoints);
  });
  CHECK(read_checkpoint(folder / "checkpoint.h5").steps == 5);
}

TEST_CASE("a `stop` that holds on one rank stops all") {
  std::vector<long> steps;
  run_on_threads<Space>(3, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Column>> settings;
    settings.ranks.team = team;
    auto solver = column<OnRanks<Column>>(space, settings, walls());
    solver.run(1, {}, [&](auto const& now) { return team.rank() == 2 && now.steps() == 7; });
    auto const all = team.gather(solver.steps());
    if (team.rank() == 0) steps = all;
  });
  CHECK(steps == std::vector<long>{7, 7, 7});
}

TEST_CASE("the first rank alone prints the progress of a run") {
  std::FILE* const stream = std::tmpfile();
  run_on_threads<Space>(3, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Column>> settings;
    settings.ranks.team = team;
    auto solver = column<OnRanks<Column>>(space, settings, walls());
    Progress progress({.end = 0.01, .stream = stream, .plain_interval = 1e9, .terminal = false});
    run_with(solver, 0.01, {}, progress);
    progress.finish(solver);
  });
  std::rewind(stream);
  int lines = 0;
  for (int c = 0; (c = std::fgetc(stream)) != EOF;) lines += c == '\n' ? 1 : 0;
  std::fclose(stream);
  CHECK(lines == 1);
}

// A block flies away from its walls; its front three fifths are beyond them when the run ends.
TEST_CASE("progress counts the lost particles of all ranks, also where the others are quiet") {
  auto const run = [](int ranks) {
    std::FILE* const stream = std::tmpfile();
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      double const apart = 0.05;
      SolverSettings<OnRanks<Column>> settings;
      settings.ranks.team = team;
      settings.spacing = apart;
      settings.lost_share = 1;
      settings.physics.gravity = {0};
      settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
      settings.physics.largest_mach = 10;
      Solver<OnRanks<Column>> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {1, 0.3}}, apart),
                                     fill_lattice(Box<2>{{2, 2}, {2.3, 2.1}}, apart));
      solver.set(velocity, [](auto const&) { return Vec<2, double>(5, 0); });
      long const before = solver.lost();  // all ranks have all particles
      Progress progress(
          {.end = 0.41, .quiet = team.rank() != 0, .stream = stream, .plain_interval = 0, .terminal = false});
      run_with(solver, 0.41, {}, progress);
      long const after = solver.lost();
      progress.finish(solver);
      if (team.rank() != 0) return;
      CHECK(before == 0);
      CHECK(after == 72);
    });
    std::rewind(stream);
    std::string text;
    for (int c = 0; (c = std::fgetc(stream)) != EOF;) text += char(c);
    std::fclose(stream);
    return text;
  };
  for (int const ranks : {1, 3}) {
    auto const text = run(ranks);
    CHECK_THAT(text, ContainsSubstring(" left, 6 lost\n"));
    CHECK_THAT(text, ContainsSubstring("\n72 particles are lost: beyond the walls, see docs/checks.md\n"));
  }
}

TEST_CASE("a rank that cannot write ends all with the reason") {
  CHECK_THROWS_WITH(run_on_threads<Space>(3,
                                          [&](Team<Space> const& team, Space const& space) {
                                            SolverSettings<OnRanks<Column>> settings;
                                            settings.ranks.team = team;
                                            auto solver = column<OnRanks<Column>>(space, settings, walls());
                                            CsvSeries const table("/no/such/folder/table.csv", {{"time", "s"}});
                                            solver.run(1);
                                          }),
                    ContainsSubstring("/no/such/folder/table.csv: cannot write it"));
}

}  // namespace scree::test::output_tests
