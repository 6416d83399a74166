// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../motion/tabulated.hpp"
#include "files/bytes_of.hpp"
#include "files/number_table.hpp"

namespace scree {

/// Returns a motion read from a file of comma-separated values. Each line has a time (s) and Dim coordinates of a
/// displacement (m):
///
///     time [s],x [m],z [m]
///     0,0,0
///     0.5,0,0.3
///
/// Lines that begin with # are ignored. A first line of names is optional; units in this line, in brackets or
/// parentheses, must be s and m. Throws std::runtime_error, with the file, the line and the column, if a line has too
/// few or too many numbers, an entry is not a finite number, a unit differs from these, or the times do not increase.
/// Throws std::runtime_error with the file if there are fewer than 2 lines of numbers or more than `Capacity`.
template <int Dim, int Capacity = 32>
Tabulated<Dim, Capacity> read_tabulated(std::filesystem::path const& file,
                                        TableInterpolation interpolation = TableInterpolation::monotone) {
  std::vector<std::string> units(Dim + 1, "m");
  units[0] = "s";
  detail::NumberTable const table = detail::read_numbers(detail::bytes_of(file), file.filename().string(), units);
  std::vector<double> times;
  std::vector<Vec<Dim, double>> displacements;
  for (auto const& row : table.rows) {
    auto const k = times.size();
    if (k > 0 && !(row[0] > times.back()))
      table.fail(k, 0,
                 detail::formatted("the time %g s does not follow %g s: times must increase", row[0], times[k - 1]));
    times.push_back(row[0]);
    displacements.push_back(Eigen::Map<Vec<Dim, double> const>(row.data() + 1));
  }
  if (times.size() < 2 || times.size() > Capacity)
    throw std::runtime_error(detail::formatted("%s: a table of a motion needs 2 to %d lines of numbers, not %zu",
                                               table.name.c_str(), Capacity, times.size()));
  return {times, displacements, interpolation};
}

}  // namespace scree
