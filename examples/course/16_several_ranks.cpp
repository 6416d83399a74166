// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A case that is divided among ranks, each with its own solver, thread and share of the particles.
//
//   course_16_several_ranks [ranks] [time to reach in s]
//
// The ranks of one process share its CPU threads or its GPU. Ranks that are processes, each with its own GPU, need MPI
// and changes to two lines (docs/distributed.md). The results are bitwise identical for any number of ranks: the last
// line of output has a hash of the whole state. In particles.vtkhdf a column of sand collapses. The table shares.csv
// has the share of rank 0, its largest speed and the largest speed in the whole case.
#include <scree/distributed/gathered.hpp>
#include <scree/distributed/other_ranks.hpp>
#include <scree/distributed/run_on_threads.hpp>
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/run/argument.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

struct Collapse : Formulation<2> {
  using physics = Granular<>;
};
using S = Solver<OnRanks<Collapse>>;  // the order of neighbours does not depend on the ranks
using Space = S::Space;

// Runs one rank. All ranks run this code, starting with the particles of the whole case; rank 0 writes the files.
void run_rank(Team<Space> const& team, Space const& space, double end) {
  using namespace scree::fields;
  double const width = 0.05, height = 0.1, dr = 0.0025;  // m
  auto const column = fill_lattice(Box<2>{{0, 0}, {width, height}}, dr);
  auto const walls = fill_between(Box<2>{{0, 0}, {8 * width, 1}}, Box<2>{{-3 * dr, -3 * dr}, {9 * width, height}}, dr);
  MuOfI<> const sand{.elastic = {.young = 2e5, .poisson = 0.3, .rest_density = 1500}, .grains = {.diameter = 1e-3}};
  S solver(space, {.spacing = dr, .physics = {.law = sand}, .ranks = {.team = team}}, column, walls);
  Geostatic const at_rest{.surface_height = height, .density = 1500, .gravity = 9.81};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material>{}, {.overwrite = true});
  CsvSeries table("shares.csv", {{"time", "s"}, {"share", "1"}, {"speed of rank 0", "m/s"}, {"speed", "m/s"}});
  Progress progress({.end = end});
  run_with(solver, end,
           {every<S>(0.02,
                     [&](S& now) {
                       output.append(now);
                       // A body of the solver has only the particles of this rank; the team combines values of all
                       // ranks.
                       auto const u = now.material().to_host(velocity);
                       double speed = 0;
                       for (auto const& each : u) speed = std::max(speed, norm(each));
                       table.row({now.time(), double(u.size()) / double(column.size()), speed, team.largest(speed)});
                     })},
           progress);
  progress.finish(solver);
  auto const x = gathered<Material>(solver, position);  // positions of all particles, sorted by identity
  double front = 0;
  for (auto const& each : x) front = std::max(front, each[0]);
  auto const hash = state_hash(solver);
  if (team.rank() == 0) fmt::print("front at {:.4f} m, state {:016x}\n", front, hash);
}

int main(int argc, char** argv) {
  Kokkos::ScopeGuard const kokkos(argc, argv);
  int const ranks = argument<int>(argc, argv, 1, 2);
  double const end = argument<double>(argc, argv, 2, 0.4);
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) { run_rank(team, space, end); });
}
