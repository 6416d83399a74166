// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "point_data_of.hpp"
#include "vtkhdf.hpp"

namespace scree {

/// Fields of bodies over time in a VTKHDF file for ParaView:
///
///     BodySeries output("particles.vtkhdf", Fields<Velocity, Stress, Concentration>{});
///     solver.run(end, {every<S>(interval, [&](S& now) { output.append(now); })});
///
/// Names, components and units (attribute `units`) follow from the fields; see point_data_of() for what is written.
/// Numbers are stored in the precision of the formulation. All bodies are in one file and therefore share their times
/// and colour scales; ParaView's Threshold filter on `body` selects one of them.
template <class List, class BodyList = Bodies<Material>>
class BodySeries {
  static_assert(detail::is_list_of_fields<List>, "the fields of an output are a list: Fields<Velocity, Stress>{}");
  static_assert(detail::is_list_of_bodies<BodyList>, "the bodies of an output are a list: Bodies<Material, Wall>{}");

 public:
  /// Creates the file, like the constructor of VtkHdfSeries. Bodies<Material, Wall>{} adds the walls.
  BodySeries(std::filesystem::path path, List, BodyList = {}, VtkHdfOptions options = {})
      : series_(std::move(path), std::move(options)) {}
  /// Returns a series that continues after a restart: it begins with the steps of the file `from` (which may be the
  /// same file) up to `time` (s). Throws as VtkHdfSeries::continued() does.
  static BodySeries continued(std::filesystem::path const& from, double time, std::filesystem::path path,
                              VtkHdfOptions options = {}) {
    return {Earlier{from, time}, std::move(path), std::move(options)};
  }

  /// Appends the current state. A field that no body carries is a compile-time error. Throws as VtkHdfSeries::append()
  /// does.
  template <class S>
  void append(S& solver) {
    ProfilingRegion const region("scree::output");
    if constexpr (detail::is_list_of_fields<List> && detail::is_list_of_bodies<BodyList>)
      series_.append(point_data_of(solver, List{}, BodyList{}));
  }

  /// Returns the number of states in the file.
  std::size_t steps() const { return series_.steps(); }
  /// Returns the path of the file.
  std::filesystem::path const& path() const { return series_.path(); }

 private:
  struct Earlier {  // a distinct type, because {} converts to a time as well as to List and BodyList
    std::filesystem::path const& file;
    double time;
  };
  BodySeries(Earlier const& from, std::filesystem::path path, VtkHdfOptions options)
      : series_(VtkHdfSeries::continued(from.file, from.time, std::move(path), std::move(options))) {}

  VtkHdfSeries series_;
};

}  // namespace scree
