// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A run that can be continued after it has stopped for any reason: Ctrl-C, the time limit of a job scheduler, or simply
// the end of the run.
//
//   course_08_restart [time to reach in s]
//
// Start the program, press Ctrl-C, and start it again in the same folder: the run continues from checkpoint.h5, and all
// files end up with the same bits as the files of a run that was never stopped. To continue a finished run, give a
// longer time. To begin again, remove checkpoint.h5. The files particles.vtkhdf and centre.csv show sand that slides to
// and fro in a shaken box.
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/checkpoints.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/probes/region.hpp>
#include <scree/run/argument.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <numbers>

using namespace scree;

struct Shaken : Formulation<2> {
  using physics = Granular<>;
  using motion = Oscillation<2>;  // of the walls
};
using S = Solver<Shaken>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const end = argument<double>(argc, argv, 1, 10);
  double const width = 0.1, depth = 0.04, dr = 0.004;  // m

  auto const bed = fill_lattice(Box<2>{{0, 0}, {width, depth}}, dr);
  auto const box =
      fill_between(Box<2>{{0, 0}, {width, 1}}, Box<2>{{-3 * dr, -3 * dr}, {width + 3 * dr, 2 * depth}}, dr);
  MuOfI<> const sand{.elastic = {.young = 1e5, .poisson = 0.3, .rest_density = 1500}, .grains = {.diameter = 1e-3}};
  S solver({.spacing = dr,
            .physics = {.law = sand},
            .motion = {.amplitude = {0.01, 0}, .period = 0.3, .phase = std::numbers::pi / 2}},
           bed, box);

  // A checkpoint is written every ten minutes, and when a signal asks the program to stop. The previous checkpoint is
  // kept as well. A checkpoint gets its final name only when it is complete, so there is always one to continue from.
  Checkpoints checkpoints({.file = "checkpoint.h5", .interval = 600});
  bool const resumed = std::filesystem::exists("checkpoint.h5");
  if (resumed) solver.restore(checkpoints.read("checkpoint.h5"));

  // Output continues from the time of the checkpoint; later rows and frames of the stopped run are computed again.
  std::vector<CsvColumn> const columns = {{"time", "s"}, {"centre", "m"}, {"velocity", "m/s"}};
  using Written = BodySeries<Fields<Velocity, Stress>>;
  auto output = resumed ? Written::continued("particles.vtkhdf", solver.time(), "particles.vtkhdf")
                        : Written("particles.vtkhdf", {}, {}, {.overwrite = true});
  auto table = resumed ? CsvSeries::continued("centre.csv", solver.time(), "centre.csv", columns)
                       : CsvSeries("centre.csv", columns);

  Progress progress({.end = end});
  run_with(
      solver, end,
      {every<S>(0.05,
                [&](S& now) {
                  output.append(now);
                  auto const all = whole_space<2>();
                  table.row({now.time(), mean_in(now, position, all).value[0], mean_in(now, velocity, all).value[0]});
                })},
      progress, checkpoints);
  progress.finish(solver);
  if (!checkpoints.interrupted()) checkpoints.save(solver.snapshot());
  return checkpoints.exit_code();
}
