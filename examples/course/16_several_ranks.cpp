// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A case that is divided into ranks, each with a solver, a thread and a share of the particles.
//
//   course_16_several_ranks [ranks] [time to reach in s]
//
// The ranks of one process share its CPU threads or its GPU. Ranks that are processes, each with a GPU of its own, need
// MPI and two other lines (docs/distributed.md). The results have the same bits for any number of ranks: the last line
// shows a hash of the whole state. One sees: a column of sand collapses (particles.vtkhdf); the share of the first
// rank, its speed and that of the whole case (shares.csv).
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
using S = Solver<OnRanks<Collapse>>;  // takes neighbours in an order that does not depend on the ranks
using Space = S::Space;

// Each rank runs the same code, with the particles of the whole case. Rank 0 writes the files.
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
                       // A body of the solver has the particles of this rank; the team joins numbers of all ranks.
                       auto const u = now.material().to_host(velocity);
                       double speed = 0;
                       for (auto const& each : u) speed = std::max(speed, norm(each));
                       table.row({now.time(), double(u.size()) / double(column.size()), speed, team.largest(speed)});
                     })},
           progress);
  progress.finish(solver);
  auto const x = gathered<Material>(solver, position);  // of all particles, in the order of their identities
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
