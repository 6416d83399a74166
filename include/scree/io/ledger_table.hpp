// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../openings/ledger.hpp"
#include "csv_series.hpp"

#include <vector>

// The ledger as a table:
//     CsvSeries history("ledger.csv", columns_of(ledger(solver)));
//     ... history.row(row_of(solver.time(), ledger(solver)));
namespace scree {

/// Returns the columns of the table: time, particle counts, and the particle count and volume of each inlet and drain.
inline std::vector<CsvColumn> columns_of(Ledger const& all) {
  std::vector<CsvColumn> columns = {{"time", "s"}, {"present", "1"}, {"added", "1"}, {"removed", "1"}};
  for (auto const* list : {&all.inlets, &all.drains})
    for (Passed const& each : *list) {
      columns.push_back({each.name, "1"});
      columns.push_back({each.name + " volume", "m^dim"});
    }
  return columns;
}
/// Returns the row of the table for a time (s).
inline std::vector<double> row_of(double time, Ledger const& all) {
  std::vector<double> row = {time, double(all.present), double(all.added), double(all.removed)};
  for (auto const* list : {&all.inlets, &all.drains})
    for (Passed const& each : *list) {
      row.push_back(double(each.particles));
      row.push_back(each.volume);
    }
  return row;
}

}  // namespace scree
