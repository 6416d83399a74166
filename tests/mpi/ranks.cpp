// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/gathered.hpp>
#include <scree/distributed/mpi.hpp>
#include <scree/distributed/other_parts.hpp>
#include <scree/distributed/run_on_parts.hpp>
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/checkpoints.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

// Run by mpirun: with `same-bits`, a column that collapses on all ranks must end with the bits of one part; with
// `fail`, one rank throws; with `stop FOLDER`, a signal comes to one rank, and with `continue FOLDER`, a run goes on
// from the checkpoint of that run.
namespace scree::test {
using namespace fields;
namespace {

using Host = Kokkos::DefaultHostExecutionSpace;

struct Collapse : Formulation<2> {
  using space = Host;
  using physics = Granular<>;
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherParts<P>;
};

Solver<Collapse> column(Team<Host> const& team, Host const& space) {
  double const dr = 0.01;
  SolverSettings<Collapse> settings{.spacing = dr, .parts = {.team = team}};
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  Solver<Collapse> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {0.2, 0.3}}, dr),
                          wall_around(Box<2>{{0, 0}, {0.8, 0.5}}, dr, 4));
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(1, 0.1 * x[1]); });
  return solver;
}
std::uint64_t end_of(Team<Host> const& team, Host const& space) {
  auto solver = column(team, space);
  for (int k = 0; k < 200; ++k) solver.step(1);
  return state_hash(solver);
}
double const end = 0.06;  // s
/// Runs with files. Returns the hash of the end; a signal stops the run before that.
std::uint64_t run_with_files(Team<Host> const& team, Host const& space, std::filesystem::path const& folder,
                             bool goes_on, int part_with_signal) {
  using S = Solver<Collapse>;
  auto solver = column(team, space);
  Checkpoints checkpoints({.file = folder / "checkpoint.h5", .interval = 1e9});
  if (goes_on) solver.restore(checkpoints.read(folder / "checkpoint.h5"));
  BodySeries output(folder / ("particles of " + std::to_string(team.parts()) + ".vtkhdf"), Fields<Velocity>{},
                    Bodies<Material>{}, {.overwrite = true});
  run_with(solver, end,
           {every<S>(0.02,
                     [&](S& now) {
                       output.append(now);
                       if (now.time() > 0.03 && team.part() == part_with_signal) std::raise(SIGUSR1);
                     })},
           checkpoints);
  bool const stopped = team.smallest(int(checkpoints.interrupted() && checkpoints.exit_code() == 128 + SIGUSR1)) == 1;
  bool const same_step = team.smallest(solver.steps()) == team.largest(solver.steps());
  if (team.part() == 0 && stopped && same_step && solver.time() < end) std::printf("all ranks stopped\n");
  return state_hash(solver);
}
bool continued(std::filesystem::path const& folder) {
  std::uint64_t whole = 0;
  bool same = false;
  auto const alone = folder / "alone";
  run_on_ranks<Host>([&](Team<Host> const& team, Host const& space) {
    auto const here = run_with_files(team, space, folder, true, -1);
    if (team.part() == 0) {
      std::filesystem::create_directories(alone);
      run_on_parts<Host>(
          1, [&](Team<Host> const& one, Host const& own) { whole = run_with_files(one, own, alone, false, -1); });
    }
    same = team.largest(whole) == here;
  });
  return same;
}

bool same_bits() {
  std::uint64_t one = 0, here = 0;
  run_on_parts<Host>(1, [&](Team<Host> const& team, Host const& space) { one = end_of(team, space); });
  bool same = false;
  run_on_ranks<Host>([&](Team<Host> const& team, Host const& space) {
    here = end_of(team, space);
    ExactSum sum;
    sum += 0.1 * (team.part() + 1);
    bool const sums = team.sum(sum) == [&] {
      ExactSum all;
      for (int q = 0; q < team.parts(); ++q) all += 0.1 * (q + 1);
      return all.value();
    }();
    same = team.smallest(int(here == one && sums)) == 1;
    if (team.part() == 0)
      std::printf("%d ranks: %016lx, one part: %016lx\n", team.parts(), static_cast<unsigned long>(here),
                  static_cast<unsigned long>(one));
  });
  return same;
}

void fail() {
  run_on_ranks<Host>([&](Team<Host> const& team, Host const&) {
    team.gather(1);
    if (team.part() == 1) throw std::runtime_error("no sand");
    for (;;) team.gather(2);
  });
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  bool good = true;
  {
    Kokkos::ScopeGuard const kokkos(argc, argv);
    if (argc > 1 && std::string(argv[1]) == "fail")
      scree::test::fail();
    else if (argc > 2 && std::string(argv[1]) == "stop")
      scree::run_on_ranks<scree::test::Host>([&](auto const& team, auto const& space) {
        scree::test::run_with_files(team, space, argv[2], false, team.parts() - 1);
      });
    else if (argc > 2 && std::string(argv[1]) == "continue")
      good = scree::test::continued(argv[2]);
    else
      good = scree::test::same_bits();
  }
  MPI_Finalize();
  return good ? 0 : 1;
}
