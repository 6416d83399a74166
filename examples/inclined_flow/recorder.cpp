// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"

#include "../support/json.hpp"
#include "../support/output_directory.hpp"
#include "../support/say.hpp"

#include <scree/io/csv_series.hpp>
#include <scree/run/progress.hpp>

namespace inclined_flow {

struct Recorder::Files {
  Files(support::Run<Options> const& r, Figures const& f)
      : run(support::begin_results(r)),
        figures(f),
        history(run.output / "history.csv", {"time", "mean_velocity_ratio", "deviation_of_core"}),
        progress({.end = run.options.output.duration, .name = "t/settling time", .quiet = run.quiet}) {}

  support::Run<Options> run;
  Figures figures;
  scree::CsvSeries history;
  scree::Progress progress;
  double start = scree::wall_seconds();
};

Recorder::Recorder(support::Run<Options> const& run, Figures const& figures)
    : files_(std::make_unique<Files>(run, figures)) {}
Recorder::~Recorder() = default;

void Recorder::record(State const& state) {
  files_->history.row({state.time, state.ratio, state.deviation});
  files_->progress.update(state.time / files_->figures.settling_time, state.steps);
}

void Recorder::finish(State const& last) {
  Options const& o = files_->run.options;
  Figures const& f = files_->figures;
  files_->progress.finish(last.time / f.settling_time, last.steps);
  scree::CsvSeries profile(files_->run.output / "profile.csv",
                           {"height", "velocity", "exact_velocity", "pressure_ratio"});
  for (std::size_t k = 0; k < last.height.size(); ++k)
    profile.row({last.height[k], last.mean_velocity[k], last.exact_velocity[k], last.pressure_ratio[k]});
  double const wall = scree::wall_seconds() - files_->start;
  scree::write_file(files_->run.output / "summary.json",
                    support::to_json({{"angle", o.slope.angle},
                                      {"rows", o.numerics.rows},
                                      {"particles", last.particles},
                                      {"wall_particles", f.wall_particles},
                                      {"steps", last.steps},
                                      {"wall_seconds", wall},
                                      {"particle_steps_per_second", double(last.steps) * last.particles / wall},
                                      {"settling_time", f.settling_time},
                                      {"granular_viscosity", f.granular_viscosity},
                                      {"artificial_viscosity", f.artificial_viscosity},
                                      {"mean_velocity_ratio", last.ratio},
                                      {"deviation_of_core", last.deviation}}));
  if (!files_->run.quiet)
    support::say(stdout,
                 "core at most {:.2f} % off Bagnold's profile; artificial viscosity {:.1f} % of the granular one\n"
                 "results in {}\n",
                 100 * last.deviation, 100 * f.artificial_viscosity / f.granular_viscosity,
                 files_->run.output.string());
}

}  // namespace inclined_flow
