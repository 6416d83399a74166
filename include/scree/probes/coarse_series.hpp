// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../io/csv_series.hpp"
#include "../io/vtkhdf.hpp"
#include "coarse_grained.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Coarse-grained fields over time, in files.
namespace scree {
namespace detail {

/// Updates the results of passes, as point_data_of() does.
template <class S>
void before_output(S& solver) {
  if (solver.steps() == 0) solver.update_rates();
  solver.update_diagnostics();
}

/// Returns the suffixes of the names of components in space: "", " x", " xx", ....
template <Field F>
std::vector<std::string> names_of_components() {
  std::string const axes = "xyz";
  std::vector<std::string> names;
  auto const pair = [&](std::size_t a, std::size_t b) { return std::string{' ', axes[a], axes[b]}; };
  switch (components_in_space<F>) {
    case 3:
      for (char const axis : axes) names.push_back({' ', axis});
      return names;
    case 6:
      return {pair(0, 0), pair(1, 1), pair(2, 2), pair(0, 1), pair(1, 2), pair(0, 2)};
    case 9:
      for (std::size_t const a : {0, 1, 2})
        for (std::size_t const b : {0, 1, 2}) names.push_back(pair(a, b));
      return names;
    default:
      return {""};
  }
}

}  // namespace detail

/// Returns coarse-grained fields as points for a writer, with an array `weight`. Components are in VTK's order (see
/// in_space()).
template <class P, class... Fs>
PointData point_data_of(CoarseGrained<P, Fields<Fs...>> const& found) {
  PointData data{.time = found.time};
  std::vector<double> xyz;
  for (auto const& x : found.grid.points())
    for (double const each : in_space<P::dim, Position>(x)) xyz.push_back(each);
  data.xyz = std::move(xyz);
  data.arrays.push_back({"weight", 1, found.weight, "1"});
  auto const add = [&]<Field F>(F field) {
    std::vector<double> numbers;
    for (auto const& value : found[field])
      for (double const each : in_space<P::dim, F>(value)) numbers.push_back(each);
    PointArray array = detail::empty_array(detail::field_of_points<F, double>(P::dim));
    array.values = std::move(numbers);
    data.arrays.push_back(std::move(array));
  };
  (add(Fs{}), ...);
  return data;
}

/// Coarse-grained fields over time in a VTKHDF file for ParaView, like the particles of a BodySeries:
///
///     CoarseSeries output("coarse.vtkhdf", grid, Fields<Velocity, Concentration>{});
///     solver.run(end, {every<S>(interval, [&](S& now) { output.append(now); })});
///
/// Throws as VtkHdfSeries and coarse_grained() do.
template <int Dim, class List>
class CoarseSeries {
 public:
  /// Creates a file for the fields of a list on a grid. Throws as VtkHdfSeries does if the file cannot be written.
  CoarseSeries(std::filesystem::path path, CoarseGrid<Dim> const& grid, List, VtkHdfOptions options = {})
      : grid_(grid), series_(std::move(path), std::move(options)) {}
  /// Returns a series that continues after a restart: it begins with the steps of the file `from` (which may be the
  /// same file) up to `time` (s). Throws as VtkHdfSeries::continued() does.
  static CoarseSeries continued(std::filesystem::path const& from, double time, std::filesystem::path path,
                                CoarseGrid<Dim> const& grid, List, VtkHdfOptions options = {}) {
    return {from, time, std::move(path), grid, std::move(options)};
  }

  /// Updates the results of passes and appends the current state.
  template <class S>
  void append(S& solver) {
    detail::before_output(solver);
    series_.append(point_data_of(coarse_grained(solver, grid_, List{})));
  }
  /// Returns the number of states in the file.
  std::size_t steps() const { return series_.steps(); }
  /// Returns the path of the file.
  std::filesystem::path const& path() const { return series_.path(); }

 private:
  CoarseSeries(std::filesystem::path const& from, double time, std::filesystem::path path, CoarseGrid<Dim> const& grid,
               VtkHdfOptions options)
      : grid_(grid), series_(VtkHdfSeries::continued(from, time, std::move(path), std::move(options))) {}

  CoarseGrid<Dim> grid_;
  VtkHdfSeries series_;
};

/// A table of profiles along an axis over time, averaged across the other axes. Each cell along the axis has one row:
/// time, the coordinate along the axis, `weight` and the components of the fields.
///
///     ProfileSeries profiles("profiles.csv", grid, 1, Fields<Velocity, Concentration>{});   // over the height in 2D
///     solver.run(end, {every<S>(interval, [&](S& now) { profiles.append(now); })});
///
/// Throws as CsvSeries, coarse_grained() and averaged_across() do.
template <int Dim, class List>
class ProfileSeries;
template <int Dim, class... Fs>
class ProfileSeries<Dim, Fields<Fs...>> {
 public:
  ProfileSeries(std::filesystem::path file, CoarseGrid<Dim> const& grid, int axis, Fields<Fs...>)
      : grid_(grid), axis_(checked(axis)), table_(std::move(file), columns(axis)) {}
  /// Returns a table that continues after a restart: it begins with the rows of the file `from` (which may be the same
  /// file) up to `time` (s). Throws as CsvSeries::continued() does.
  static ProfileSeries continued(std::filesystem::path const& from, double time, std::filesystem::path file,
                                 CoarseGrid<Dim> const& grid, int axis, Fields<Fs...>) {
    return {grid, axis, CsvSeries::continued(from, time, std::move(file), columns(checked(axis)))};
  }

  /// Updates the results of passes and appends the current profile.
  template <class S>
  void append(S& solver) {
    detail::before_output(solver);
    auto profile = coarse_grained(solver, grid_, Fields<Fs...>{});
    for (int axis = 0; axis < Dim; ++axis)
      if (axis != axis_) profile = averaged_across(axis, profile);
    auto const points = profile.grid.points();
    for (std::size_t k = 0; k < points.size(); ++k) {
      std::vector<double> row = {profile.time, points[k][axis_], profile.weight[k]};
      auto const add = [&]<Field F>(F field) {
        for (double const each : in_space<Dim, F>(profile[field][k])) row.push_back(each);
      };
      (add(Fs{}), ...);
      table_.row(row);
    }
  }
  static std::vector<CsvColumn> columns(int axis) {
    std::vector<CsvColumn> all = {
        {"time", "s"}, {std::string{"xyz"[detail::axis_in_space<Dim>(axis)]}, "m"}, {"weight", ""}};
    auto const add = [&]<Field F>(F) {
      std::string const unit = F::unit == "1" ? "" : std::string(F::unit);
      for (auto const& component : detail::names_of_components<F>())
        all.emplace_back(std::string(F::name) + component, unit);
    };
    (add(Fs{}), ...);
    return all;
  }
  /// Returns the path of the file.
  std::filesystem::path const& path() const { return table_.path(); }

 private:
  ProfileSeries(CoarseGrid<Dim> const& grid, int axis, CsvSeries&& table)
      : grid_(grid), axis_(axis), table_(std::move(table)) {}
  static int checked(int axis) {
    check_setting(axis >= 0 && axis < Dim, "the axis of a profile", axis, "an axis of space, counted from 0");
    return axis;
  }

  CoarseGrid<Dim> grid_;
  int axis_;
  CsvSeries table_;
};
template <int Dim, class List>
ProfileSeries(std::filesystem::path, CoarseGrid<Dim> const&, int, List) -> ProfileSeries<Dim, List>;

}  // namespace scree
