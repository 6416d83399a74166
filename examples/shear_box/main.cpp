// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results.hpp"

#include <scree/app/program.hpp>
#include <scree/app/say.hpp>
#include <scree/app/summary.hpp>

namespace shear_box {

template <int Dim, class Real>
int simulate(app::Run<Options> const& run);  // simulate.hpp

Results::Results(app::Run<Options> const& run, MaterialPoints points) : run_(run), points_(std::move(points)) {}

app::Table Results::table(Options const& o) {
  return {.file = "history.csv",
          .columns = {{"time", "T"}, "C_mean", "C_min", "C_max", "small_grain_centre", "intensity", "lacey"},
          .unit = o.geometry.period};
}

std::vector<double> Results::numbers() const {
  std::vector<double> all = {mean_, first_mean_, largest_drift_, lowest_, highest_, double(kept_times_.size())};
  all.insert(all.end(), kept_times_.begin(), kept_times_.end());
  for (auto const& C : kept_) all.insert(all.end(), C.begin(), C.end());
  return all;
}
void Results::take(std::vector<double> const& all) {
  std::size_t const times = all.size() < 6 ? 0 : std::size_t(all[5]), n = points_.Z.size();
  if (all.size() != 6 + times + times * n)
    throw std::runtime_error("the checkpoint holds the concentrations of another number of particles");
  mean_ = all[0], first_mean_ = all[1], largest_drift_ = all[2], lowest_ = all[3], highest_ = all[4];
  auto const* at = all.data() + 6;
  kept_times_.assign(at, at + times);
  at += times;
  kept_.clear();
  for (std::size_t k = 0; k < times; ++k, at += n) kept_.emplace_back(at, at + n);
}

std::vector<double> Results::compared_times() const {
  std::vector<double> times;
  for (double time : run_.options.output.compared)
    if (time > 0 && time <= run_.options.time.periods) times.push_back(time);
  return times;
}

void Results::add_history(double time, std::vector<double> const& C, Mixing const& mixing) {
  double sum = 0, moment = 0, low = 1e300, high = -1e300;
  for (std::size_t i = 0; i < C.size(); ++i) {
    sum += C[i], moment += C[i] * points_.Z[i];
    low = std::min(low, C[i]), high = std::max(high, C[i]);
  }
  if (!std::isfinite(sum))
    throw std::runtime_error(fmt::format("C is no longer finite at t/T = {:.2f}; what was written before is kept in {}",
                                         time, run_.output.string()));
  lowest_ = std::min(lowest_, low), highest_ = std::max(highest_, high);
  mean_ = sum / double(C.size());
  if (time == 0) first_mean_ = mean_;
  largest_drift_ = std::max(largest_drift_, std::abs(mean_ - first_mean_));
  mixing_ = mixing;
  history_->row({time, mean_, low, high, moment / sum, mixing.intensity, mixing.lacey});
}

void Results::keep_profile(double time, std::vector<double> C) {
  kept_times_.push_back(time);
  kept_.push_back(std::move(C));
}

void Results::finish(app::Figures const& figures, bool interrupted) {
  if (!scree::writes_files()) return;  // rank 0 solves the references
  double const wall = scree::wall_seconds() - start_;
  auto const write = [&](References const& references) {
    std::vector<Comparison> comparisons;
    for (std::size_t k = 0; k < kept_.size(); ++k) comparisons.push_back(compare(points_, kept_[k], references, k));
    write_profiles(comparisons);
    write_summary(figures, wall, references, comparisons);
    return comparisons;
  };
  write(unsolved_references(kept_times_));  // saves the results of the run before the references are solved, which
                                            // takes a while
  if (interrupted) return;
  auto const references = solve_references(run_.options, kept_times_);
  print(references, write(references));
}

void Results::write_profiles(std::vector<Comparison> const& comparisons) const {
  scree::CsvSeries::Rows rows;
  for (auto const& c : comparisons)
    for (std::size_t row = 0; row < points_.row_height.size(); ++row)
      rows.push_back({c.time, points_.row_height[row], c.found.all[row], c.found.centre[row], c.best.all[row],
                      c.best.centre[row], c.one_dimensional.all[row], c.found.lowest[row], c.found.highest[row]});
  scree::CsvSeries(run_.output / "profiles.csv",
                   {"time", "z_over_H", "C_mean", "C_centre", "C_reference", "C_reference_centre", "C_one_dimensional",
                    "C_lowest", "C_highest"},
                   rows);
}

void Results::write_summary(app::Figures const& figures, double wall, References const& references,
                            std::vector<Comparison> const& comparisons) const {
  using app::Json;
  Options const& o = run_.options;
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
  Json::Object summary{{"scheme", std::string(app::name_of(o.model.scheme))},
                       {"flux", std::string(app::name_of(o.model.flux))},
                       {"reading", std::string(app::name_of(o.model.reading))},
                       {"closure", std::string(app::name_of(o.model.closure))},
                       {"d_bar", o.model.d_bar},
                       {"upright", o.geometry.upright},
                       {"dimension", o.numerics.dimension},
                       {"precision", std::string(app::name_of(o.numerics.precision))},
                       {"execution_space", figures.execution_space},
                       {"spacing", o.numerics.spacing},
                       {"jitter", o.numerics.jitter},
                       {"periods", o.time.periods},
                       {"steps_by_limit", limits},
                       {"neighbour_builds", figures.neighbour_builds},
                       {"mean_C", mean_},
                       {"mean_C_drift", largest_drift_},
                       {"min_C", lowest_},
                       {"max_C", highest_},
                       {"intensity", mixing_.intensity},
                       {"lacey", mixing_.lacey},
                       {"limiter_total", 0.0},  // no scheme limits C
                       {"reference", references.best_name},
                       {"reference_one_dimensional", references.one_dimensional_name},
                       {"compared", compared}};
  app::add_counts(summary, figures, wall);
  scree::write_file(run_.output / "summary.json", app::to_json(summary));
}

void Results::print(References const& references, std::vector<Comparison> const& comparisons) const {
  if (run_.quiet || comparisons.empty()) return;
  app::say(stdout, "errors of C against: {}\n{:>6} {:>11} {:>11} {:>11} {:>11} {:>13}\n", references.best_name, "t/T",
           "MAE width", "RMSE width", "MAE centre", "RMSE centre", "scatter width");
  for (auto const& c : comparisons)
    app::say(stdout, "{:6g} {:11.2e} {:11.2e} {:11.2e} {:11.2e} {:13.2e}\n", c.time, c.width.mae, c.width.rmse,
             c.centre.mae, c.centre.rmse, c.scatter_width);
  app::say(stdout,
           "mean C drifted by {:.1e}; smallest C {:.3g}, 1 - largest C {:.3g}\nintensity of segregation {:.4f}, Lacey "
           "index {:.4f}\nresults in {}\n",
           largest_drift_, lowest_, 1 - highest_, mixing_.intensity, mixing_.lacey, run_.output.string());
}

}  // namespace shear_box

int main(int argc, char** argv) {
  using namespace shear_box;
  auto const simulation = [](app::Run<Options> const& run) {
    bool const single = run.options.numerics.precision == Precision::single_precision;
    if (run.options.numerics.dimension == 2) return single ? simulate<2, float>(run) : simulate<2, double>(run);
    return single ? simulate<3, float>(run) : simulate<3, double>(run);
  };
  return app::run_program(argc, argv,
                          {.name = "shear_box",
                           .summary = "Particle-size segregation in an oscillating shear box",
                           .results = {"summary.json", "profiles.csv", "history.csv", "particles.vtkhdf"},
                           .profiles = true},
                          schema(), simulation);
}
