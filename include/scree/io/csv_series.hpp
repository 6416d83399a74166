// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "write_file.hpp"

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// A column of a table. Its header is "name [unit]", or the name alone for a number without a unit.
struct CsvColumn {
  std::string name, unit;  ///< the unit is empty for a number without one

  /// A column with a name and a unit.
  CsvColumn(char const* name_, char const* unit_ = "") : name(name_), unit(unit_) {}  // NOLINT: {"t", "s"}
  /// A column with a name and a unit.
  CsvColumn(std::string name_, std::string unit_ = "") : name(std::move(name_)), unit(std::move(unit_)) {}  // NOLINT
  /// The title of the column: its name, with the unit in brackets if it has one.
  std::string header() const { return unit.empty() ? name : name + " [" + unit + "]"; }
};

/// A table of numbers as comma-separated values, complete on the disk after every row.
///
///     CsvSeries history("history.csv", {{"time", "s"}, {"pressure", "Pa"}, {"porosity"}});
///     history.row({time, pressure, porosity});
///
/// Numbers have all their digits: reading them gives the same bits. Throws std::runtime_error with file and reason if
/// the file cannot be written, std::logic_error for a row of another length, and std::invalid_argument for a column
/// without a name or one that would break the header (comma, quotation mark, line break). Writes nothing on ranks other
/// than the first (core/this_rank.hpp).
class CsvSeries {
 public:
  using Rows = std::vector<std::vector<double>>;

  /// Replaces the file by one with these rows, in one step. The rows of an earlier part of a run go here.
  CsvSeries(std::filesystem::path file, std::vector<CsvColumn> const& columns, Rows const& rows = {});

  /// Returns the table of another file, or of this one, which continues after a restart: it has the rows of that file
  /// up to a time (the first column). An incomplete last row is dropped. A table with fewer columns, which are the
  /// first of these, as an earlier version wrote it, gets NaN in the others. Throws std::runtime_error if the file
  /// cannot be read or has other columns.
  static CsvSeries continued(std::filesystem::path const& from, double time, std::filesystem::path file,
                             std::vector<CsvColumn> const& columns);

  /// Throws std::runtime_error where continued() would, as far as the content of the file decides that.
  static void check(std::filesystem::path const& from, std::vector<CsvColumn> const& columns);

  /// One number per column.
  void row(std::span<double const> values);
  void row(std::initializer_list<double> values) { row(std::span<double const>(values.begin(), values.size())); }

  /// The file that is written.
  std::filesystem::path const& path() const { return file_; }

 private:
  static std::string header_of(std::vector<CsvColumn> const& columns);
  static Rows rows_until(double time, std::filesystem::path const& from, std::vector<CsvColumn> const& columns);
  void check(CsvColumn const& column) const;
  std::string line_of(std::span<double const> values) const;

  std::filesystem::path file_;
  std::size_t columns_;
  std::ofstream stream_;
  bool writes_ = writes_files();
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "csv_series.ipp"
#endif
