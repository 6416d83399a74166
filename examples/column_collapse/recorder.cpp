// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"

#include "experiments.hpp"

#include "../support/json.hpp"
#include "../support/output_directory.hpp"
#include "../support/say.hpp"

#include <scree/io/csv_series.hpp>
#include <scree/run/progress.hpp>

namespace column_collapse {

namespace {
double fall_time(Options const& o) { return std::sqrt(o.geometry.aspect * o.geometry.width / 9.81); }
}  // namespace

struct Recorder::Files {
  explicit Files(support::Run<Options> const& r)
      : run(support::begin_results(r)),
        history(run.output / "history.csv", {"time", "run_out", "summit", "speed"}),
        progress({.end = run.options.output.duration, .name = "t/sqrt(H0/g)", .quiet = run.quiet}) {}

  support::Run<Options> run;
  scree::CsvSeries history;
  scree::Progress progress;
  double start = scree::wall_seconds();
};

Recorder::Recorder(support::Run<Options> const& run) : files_(std::make_unique<Files>(run)) {}
Recorder::~Recorder() = default;

void Recorder::record(State const& state) {
  Options const& o = files_->run.options;
  double const L0 = o.geometry.width, time = state.time / fall_time(o);
  files_->history.row({time, state.reach / L0 - 1, state.summit / L0, state.speed});
  files_->progress.update(time, state.steps);
}

void Recorder::finish(State const& last, int wall_particles) {
  Options const& o = files_->run.options;
  double const L0 = o.geometry.width, a = o.geometry.aspect, run_out = last.reach / L0 - 1;
  files_->progress.finish(last.time / fall_time(o), last.steps);
  scree::CsvSeries profile(files_->run.output / "profile.csv", {"distance_over_L0", "depth_over_L0"});
  for (std::size_t k = 0; k < last.depth.size(); ++k) profile.row({last.distance[k] / L0, last.depth[k] / L0});
  Band const band = o.numerics.dimension == 2 ? run_out_in_channels(a) : run_out_of_cylinders(a);
  double const wall = scree::wall_seconds() - files_->start;
  scree::write_file(files_->run.output / "summary.json",
                    support::to_json({{"aspect", a},
                                      {"dimension", o.numerics.dimension},
                                      {"across", o.numerics.across},
                                      {"particles", last.particles},
                                      {"wall_particles", wall_particles},
                                      {"steps", last.steps},
                                      {"wall_seconds", wall},
                                      {"particle_steps_per_second", double(last.steps) * last.particles / wall},
                                      {"run_out", run_out},
                                      {"run_out_least", band.least},
                                      {"run_out_greatest", band.greatest},
                                      {"summit_over_L0", last.summit / L0},
                                      {"largest_speed", last.speed}}));
  if (!files_->run.quiet)
    support::say(
        stdout,
        "run-out {:.3f} L0 at a depth of {} H0; experiments {:.3f} to {:.3f}; summit {:.3f} L0\nresults in {}\n",
        run_out, o.output.reading_depth, band.least, band.greatest, last.summit / L0, files_->run.output.string());
}

}  // namespace column_collapse
