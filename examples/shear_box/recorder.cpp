// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"

#include "comparison.hpp"
#include "schema.hpp"

#include <scree/app/json.hpp>
#include <scree/app/output_directory.hpp>
#include <scree/app/say.hpp>

#include <scree/io/csv_series.hpp>
#include <scree/run/progress.hpp>

namespace shear_box {

struct Recorder::Files {
  Files(scree::app::Run<Options> const& r, MaterialPoints p)
      : run(scree::app::begin_results(r)),
        points(std::move(p)),
        history(run.output / "history.csv", {"time", "C_mean", "C_min", "C_max", "small_grain_centre"}),
        progress({.end = run.options.time.periods, .name = "t/T", .quiet = run.quiet}) {}

  void write_profiles(std::vector<Comparison> const& comparisons) const;
  void write_summary(RunFigures const& figures, double wall, References const& references,
                     std::vector<Comparison> const& comparisons) const;
  void print(References const& references, std::vector<Comparison> const& comparisons) const;

  scree::app::Run<Options> run;
  MaterialPoints points;
  scree::CsvSeries history;
  scree::Progress progress;
  std::vector<State> kept;
  double start = scree::wall_seconds();
  double mean = 0, first_mean = 0, largest_drift = 0, lowest = 1e300, highest = -1e300;
};

Recorder::Recorder(scree::app::Run<Options> const& run, MaterialPoints points)
    : files_(std::make_unique<Files>(run, std::move(points))) {}
Recorder::~Recorder() = default;

void Recorder::keep_profile(State state) { files_->kept.push_back(std::move(state)); }

std::vector<double> Recorder::compared_times() const {
  std::vector<double> times;
  for (double time : files_->run.options.output.compared)
    if (time > 0 && time <= files_->run.options.time.periods) times.push_back(time);
  return times;
}

void Recorder::record_history(State const& state) {
  double sum = 0, moment = 0, low = 1e300, high = -1e300;
  for (std::size_t i = 0; i < state.C.size(); ++i) {
    sum += state.C[i], moment += state.C[i] * files_->points.Z[i];
    low = std::min(low, state.C[i]), high = std::max(high, state.C[i]);
  }
  if (!std::isfinite(sum))
    throw std::runtime_error(fmt::format("C is no longer finite at t/T = {:.2f}; what was written before is kept in {}",
                                         state.time, files_->run.output.string()));
  files_->lowest = std::min(files_->lowest, low), files_->highest = std::max(files_->highest, high);
  files_->mean = sum / double(state.C.size());
  if (state.steps == 0) files_->first_mean = files_->mean;
  files_->largest_drift = std::max(files_->largest_drift, std::abs(files_->mean - files_->first_mean));
  files_->history.row({state.time, files_->mean, low, high, moment / sum});
  files_->progress.update(state.time, state.steps);
}

void Recorder::finish(RunFigures const& figures) {
  double const wall = scree::wall_seconds() - files_->start;
  files_->progress.finish(figures.time, figures.steps);
  std::vector<double> times;
  for (State const& state : files_->kept) times.push_back(state.time);
  auto const write = [&](References const& references) {
    std::vector<Comparison> comparisons;
    for (std::size_t k = 0; k < times.size(); ++k)
      comparisons.push_back(compare(files_->points, files_->kept[k].C, references, k));
    files_->write_profiles(comparisons);
    files_->write_summary(figures, wall, references, comparisons);
    return comparisons;
  };
  write(
      unsolved_references(times));  // the run's own results are safe before references are solved, which takes a while
  auto const references = solve_references(files_->run.options, times);
  files_->print(references, write(references));
}

void Recorder::Files::write_profiles(std::vector<Comparison> const& comparisons) const {
  scree::CsvSeries::Rows rows;
  for (auto const& c : comparisons)
    for (std::size_t row = 0; row < points.row_height.size(); ++row)
      rows.push_back({c.time, points.row_height[row], c.found.all[row], c.found.centre[row], c.best.all[row],
                      c.best.centre[row], c.one_dimensional.all[row], c.found.lowest[row], c.found.highest[row]});
  scree::CsvSeries(run.output / "profiles.csv",
                   {"time", "z_over_H", "C_mean", "C_centre", "C_reference", "C_reference_centre", "C_one_dimensional",
                    "C_lowest", "C_highest"},
                   rows);
}

void Recorder::Files::write_summary(RunFigures const& figures, double wall, References const& references,
                                    std::vector<Comparison> const& comparisons) const {
  using scree::app::Json;
  Options const& o = run.options;
  Json::Array compared;
  for (auto const& c : comparisons)
    compared.emplace_back(Json::Object{{"time", c.time},
                                       {"mae_width", c.width.mae},
                                       {"rmse_width", c.width.rmse},
                                       {"mae_centre", c.centre.mae},
                                       {"rmse_centre", c.centre.rmse},
                                       {"scatter_width", c.scatter_width},
                                       {"mae_particles", c.particles.mae},
                                       {"mae_width_one_dimensional", c.width_1d.mae},
                                       {"mae_centre_one_dimensional", c.centre_1d.mae}});
  Json::Object limits;
  for (auto const& [name, count] : figures.steps_by_limit) limits.emplace_back(name, count);
  Json::Object const summary{{"scheme", std::string(scree::app::name_of(o.model.scheme))},
                             {"flux", std::string(scree::app::name_of(o.model.flux))},
                             {"reading", std::string(scree::app::name_of(o.model.reading))},
                             {"closure", std::string(scree::app::name_of(o.model.closure))},
                             {"d_bar", o.model.d_bar},
                             {"upright", o.geometry.upright},
                             {"dimension", o.numerics.dimension},
                             {"precision", std::string(scree::app::name_of(o.numerics.precision))},
                             {"execution_space", figures.execution_space},
                             {"spacing", o.numerics.spacing},
                             {"jitter", o.numerics.jitter},
                             {"periods", o.time.periods},
                             {"particles", figures.particles},
                             {"wall_particles", figures.wall_particles},
                             {"steps", figures.steps},
                             {"steps_by_limit", limits},
                             {"neighbour_builds", figures.neighbour_builds},
                             {"wall_seconds", wall},
                             {"particle_steps_per_second", double(figures.steps) * figures.particles / wall},
                             {"mean_C", mean},
                             {"mean_C_drift", largest_drift},
                             {"min_C", lowest},
                             {"max_C", highest},
                             {"limiter_total", 0.0},  // no scheme changes C outside its equation
                             {"reference", references.best_name},
                             {"reference_one_dimensional", references.one_dimensional_name},
                             {"compared", compared}};
  scree::write_file(run.output / "summary.json", scree::app::to_json(summary));
}

void Recorder::Files::print(References const& references, std::vector<Comparison> const& comparisons) const {
  if (run.quiet || comparisons.empty()) return;
  scree::app::say(stdout, "C against: {}\n{:>6} {:>11} {:>11} {:>11} {:>11} {:>13}\n", references.best_name, "t/T",
                  "MAE width", "RMSE width", "MAE centre", "RMSE centre", "scatter width");
  for (auto const& c : comparisons)
    scree::app::say(stdout, "{:6g} {:11.2e} {:11.2e} {:11.2e} {:11.2e} {:13.2e}\n", c.time, c.width.mae, c.width.rmse,
                    c.centre.mae, c.centre.rmse, c.scatter_width);
  scree::app::say(stdout, "mean C drifted by {:.1e}; C between {:.3g} and 1 - {:.3g}\nresults in {}\n", largest_drift,
                  lowest, 1 - highest, run.output.string());
}

}  // namespace shear_box
