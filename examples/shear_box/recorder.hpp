// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "comparison.hpp"

#include "../support/csv.hpp"
#include "../support/json.hpp"
#include "../support/progress.hpp"
#include "../support/start.hpp"

#include <scree/io/vtkhdf.hpp>

#include <chrono>

// What a run of the shear box writes, see the README beside this file.
namespace shear_box {

inline std::vector<std::string> result_files() {
  return {"summary.json", "profiles.csv", "history.csv", "particles.vtkhdf"};
}

/// Follows a solver and writes its results. Times in T, heights in H.
template <class S>
class Recorder {
  using P = typename S::policy;

 public:
  Recorder(support::Run<Options> const& run, MaterialPoints points)
      : run_(run),
        points_(std::move(points)),
        history_(run.output / "history.csv", {"time", "C_mean", "C_min", "C_max", "small_grain_centre"}),
        frames_(run.output / "particles.vtkhdf", {.single_precision = true, .provenance = {{"case", run.case_text}}}),
        progress_({.end = run.options.time.periods, .name = "t/T", .quiet = run.quiet}) {}

  typename S::Observers observers() {
    auto const& output = run_.options.output;
    double const T = run_.options.geometry.period;
    std::vector<double> compared;
    for (double time : output.compared)
      if (time <= run_.options.time.periods) compared.push_back(time * T);
    return {scree::every<S>(output.history_interval * T, [this](S const& s) { record_history(s); }),
            scree::every<S>(output.frame_interval * T, [this](S& s) { record_frame(s); }),
            scree::at<S>(compared, [this](S const& s) { keep_profile(s); })};
  }

  /// Solves the references and writes what needs them; prints the comparison.
  void finish(S const& solver) {
    double const wall = seconds() - start_;
    progress_.finish(solver.time() / run_.options.geometry.period, solver.steps());
    std::vector<double> times;
    for (auto const& [time, C] : kept_) times.push_back(time);
    auto const references = solve_references(run_.options, times);
    std::vector<Comparison> comparisons;
    for (std::size_t k = 0; k < times.size(); ++k) comparisons.push_back(compare(points_, kept_[k].second, references, k));
    write_profiles(comparisons);
    write_summary(solver, wall, references, comparisons);
    print(references, comparisons);
  }

 private:
  static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  double time_in_periods(S const& solver) const { return solver.time() / run_.options.geometry.period; }

  static std::vector<double> concentrations(S const& solver) {
    auto const C = solver.material().to_host(scree::concentration);
    return {C.begin(), C.end()};
  }

  void record_history(S const& solver) {
    auto const C = concentrations(solver);
    double sum = 0, moment = 0, low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < C.size(); ++i) {
      sum += C[i], moment += C[i] * points_.Z[i];
      low = std::min(low, C[i]), high = std::max(high, C[i]);
    }
    lowest_ = std::min(lowest_, low), highest_ = std::max(highest_, high);
    mean_ = sum / double(C.size());
    if (!std::isfinite(sum))
      throw std::runtime_error(fmt::format("C is no longer finite at t/T = {:.2f}; what was written before is kept in {}",
                                           time_in_periods(solver), run_.output.string()));
    if (solver.steps() == 0) first_mean_ = mean_;
    largest_drift_ = std::max(largest_drift_, std::abs(mean_ - first_mean_));
    history_.row({time_in_periods(solver), mean_, low, high, moment / sum});
    progress_.update(time_in_periods(solver), solver.steps());
  }

  void keep_profile(S const& solver) {
    if (solver.steps() > 0) kept_.emplace_back(time_in_periods(solver), concentrations(solver));
  }

  // All particles, those of the walls behind those of the material with zeros for what they do not have.
  void record_frame(S& solver) {
    solver.update_diagnostics();
    std::size_t const n = static_cast<std::size_t>(solver.material().size());
    std::size_t const all = n + static_cast<std::size_t>(solver.wall().size());
    auto const xyz = three_components(solver.material().to_host(scree::position), solver.wall().to_host(scree::position));
    auto const free_normal = three_components(solver.material().to_host(scree::free_surface_normal), all);
    auto const wall_normal = three_components(solver.material().to_host(scree::wall_normal), all);
    auto const C = padded(solver.material().to_host(scree::concentration), all);
    auto const V = padded(solver.material().to_host(scree::segregation_velocity), all);
    auto const D = padded(solver.material().to_host(scree::diffusivity), all);
    std::vector<std::int32_t> set(all, 0), body(all, 1), identity(all, 0);
    std::ranges::copy(solver.material().to_host(scree::surface_set), set.begin());
    std::ranges::copy(solver.material().to_host(scree::identity), identity.begin());
    std::ranges::copy(solver.wall().to_host(scree::identity), identity.begin() + static_cast<std::ptrdiff_t>(n));
    std::fill_n(body.begin(), n, 0);
    frames_.append(solver.time(), xyz,
                   std::vector<scree::PointField>{{.name = "concentration", .values = std::span<double const>(C)},
                                                  {.name = "segregation_velocity", .values = std::span<double const>(V)},
                                                  {.name = "diffusivity", .values = std::span<double const>(D)},
                                                  {.name = "surface_set", .values = std::span<std::int32_t const>(set)},
                                                  {.name = "free_surface_normal",
                                                   .components = 3,
                                                   .values = std::span<double const>(free_normal)},
                                                  {.name = "wall_normal",
                                                   .components = 3,
                                                   .values = std::span<double const>(wall_normal)},
                                                  {.name = "body", .values = std::span<std::int32_t const>(body)},
                                                  {.name = "identity", .values = std::span<std::int32_t const>(identity)}});
  }

  // In 2D the plane is drawn as x, z.
  template <class Vectors>
  static void append_components(std::vector<double>& xyz, Vectors const& vectors) {
    for (auto const& v : vectors) {
      xyz.push_back(double(v[0]));
      xyz.push_back(P::dim == 3 ? double(v[1]) : 0);
      xyz.push_back(double(v[P::dim - 1]));
    }
  }
  template <class Vectors>
  static std::vector<double> three_components(Vectors const& material, Vectors const& wall) {
    std::vector<double> xyz;
    append_components(xyz, material);
    append_components(xyz, wall);
    return xyz;
  }
  template <class Vectors>
  static std::vector<double> three_components(Vectors const& material, std::size_t all) {
    std::vector<double> xyz;
    append_components(xyz, material);
    xyz.resize(3 * all, 0.0);
    return xyz;
  }
  template <class Values>
  static std::vector<double> padded(Values const& values, std::size_t all) {
    std::vector<double> result(values.begin(), values.end());
    result.resize(all, 0.0);
    return result;
  }

  void write_profiles(std::vector<Comparison> const& comparisons) const {
    support::CsvWriter profiles(run_.output / "profiles.csv",
                                {"time", "z_over_H", "C_mean", "C_centre", "C_reference", "C_reference_centre",
                                 "C_one_dimensional", "C_lowest", "C_highest"});
    for (auto const& c : comparisons)
      for (std::size_t row = 0; row < points_.row_height.size(); ++row)
        profiles.row({c.time, points_.row_height[row], c.found.all[row], c.found.centre[row], c.best.all[row],
                      c.best.centre[row], c.one_dimensional.all[row], c.found.lowest[row], c.found.highest[row]});
  }

  void write_summary(S const& solver, double wall, References const& references,
                     std::vector<Comparison> const& comparisons) const {
    using support::Json;
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
    for (auto const& [name, count] : solver.limits()) limits.emplace_back(name, count);
    Json::Object const summary{
        {"scheme", text(o.model.scheme)},
        {"flux", text(o.model.flux)},
        {"reading", text(o.model.reading)},
        {"closure", text(o.model.closure)},
        {"upright", o.geometry.upright},
        {"d_bar", o.model.d_bar},
        {"dimension", P::dim},
        {"precision", text(o.numerics.precision)},
        {"execution_space", P::space::name()},
        {"spacing", o.numerics.spacing},
        {"jitter", o.numerics.jitter},
        {"periods", o.time.periods},
        {"particles", solver.material().size()},
        {"wall_particles", solver.wall().size()},
        {"steps", solver.steps()},
        {"steps_by_limit", limits},
        {"neighbour_builds", solver.neighbour_builds()},
        {"wall_seconds", wall},
        {"particle_steps_per_second", double(solver.steps()) * solver.material().size() / wall},
        {"mean_C", mean_},
        {"mean_C_drift", largest_drift_},
        {"min_C", lowest_},
        {"max_C", highest_},
        {"limiter_total", 0.0},  // neither scheme limits C
        {"reference", references.best_name},
        {"reference_one_dimensional", references.one_dimensional_name},
        {"compared", compared}};
    support::write_file(run_.output / "summary.json", support::to_json(summary));
  }
  template <class E>
  static std::string text(E choice) {
    for (auto const& [value, name] : names_of(choice))
      if (value == choice) return std::string(name);
    return "?";
  }

  void print(References const& references, std::vector<Comparison> const& comparisons) const {
    if (run_.quiet || comparisons.empty()) return;
    fmt::print("C against: {}\n{:>6} {:>11} {:>11} {:>11} {:>11} {:>13}\n", references.best_name, "t/T", "MAE width",
               "RMSE width", "MAE centre", "RMSE centre", "scatter width");
    for (auto const& c : comparisons)
      fmt::print("{:6g} {:11.2e} {:11.2e} {:11.2e} {:11.2e} {:13.2e}\n", c.time, c.width.mae, c.width.rmse, c.centre.mae,
                 c.centre.rmse, c.scatter_width);
    fmt::print("mean C drifted by {:.1e}; C in [{:.3g}, 1 - {:.3g}]\nresults in {}\n", largest_drift_, lowest_,
               1 - highest_, run_.output.string());
  }

  support::Run<Options> run_;
  MaterialPoints points_;
  support::CsvWriter history_;
  scree::VtkHdfSeries frames_;
  support::Progress progress_;
  std::vector<std::pair<double, std::vector<double>>> kept_;  // compared times and concentrations
  double start_ = seconds();
  double mean_ = 0, first_mean_ = 0, largest_drift_ = 0, lowest_ = 1e300, highest_ = -1e300;
};

}  // namespace shear_box
