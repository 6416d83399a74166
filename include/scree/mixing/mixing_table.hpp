// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../io/csv_series.hpp"
#include "doucet.hpp"
#include "lacey.hpp"
#include "neighbours.hpp"

#include <string>
#include <vector>

// The measures of mixing as a table:
//     CsvSeries mixing("mixing.csv", mixing_columns<S>());
//     solver.run(end, {every<S>(interval, [&](S& now) { mixing.row(mixing_row(now, {.cell = 0.02})); })});
namespace scree {

/// Returns the columns: time, the share of each kind but the last, the intensity of segregation, Lacey's index and the
/// number of its samples; then the neighbour index if the diagnostics compute it, and Doucet's index if the material
/// carries StartPosition.
template <class S>
std::vector<CsvColumn> mixing_columns() {
  using Kinds = kinds_in<S>;
  std::vector<CsvColumn> columns = {{"time", "s"}};
  if constexpr (detail::explain_kinds<Kinds, S>()) {
    using Carried = typename detail::material_of<S>::fields;
    for (int k = 1; k < Kinds::kinds; ++k)
      columns.emplace_back(Kinds::kinds == 2 ? std::string("share") : "share " + std::to_string(k));
    for (char const* name : {"intensity", "lacey", "samples"}) columns.emplace_back(name);
    if constexpr (OneOf<UnlikeNeighbours, Carried>) columns.emplace_back("neighbours");
    if constexpr (OneOf<StartPosition, Carried>) columns.emplace_back("doucet");
  }
  return columns;
}
/// Returns the row for the current state of a solver. `settings` are the settings of Lacey's index. Throws as
/// lacey_index() does.
template <class S>
std::vector<double> mixing_row(S& solver, LaceySettings const& settings = {}) {
  using Kinds = kinds_in<S>;
  std::vector<double> row = {solver.time()};
  if constexpr (detail::explain_kinds<Kinds, S>()) {
    using Carried = typename detail::material_of<S>::fields;
    auto const intensity = segregation_intensity(solver);
    auto const lacey = lacey_index(solver, settings);
    for (int k = 0; k + 1 < Kinds::kinds; ++k) row.push_back(intensity.mean[k]);
    row.insert(row.end(), {intensity.value, lacey.index, double(lacey.samples)});
    if constexpr (OneOf<UnlikeNeighbours, Carried>) row.push_back(neighbour_index(solver).value);
    if constexpr (OneOf<StartPosition, Carried>) row.push_back(doucet_index(solver).index);
  }
  return row;
}

}  // namespace scree
