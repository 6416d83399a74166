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
  std::string name, unit;  ///< `unit` is empty for a number without a unit

  /// Creates a column with a name and a unit.
  CsvColumn(char const* name_, char const* unit_ = "") : name(name_), unit(unit_) {}  // NOLINT: {"t", "s"}
  /// Creates a column with a name and a unit.
  CsvColumn(std::string name_, std::string unit_ = "") : name(std::move(name_)), unit(std::move(unit_)) {}  // NOLINT
  /// Returns the title of the column: its name, followed by the unit in brackets if there is one.
  std::string header() const { return unit.empty() ? name : name + " [" + unit + "]"; }
};

/// A table of numbers in a file of comma-separated values, which is complete after every row.
///
///     CsvSeries history("history.csv", {{"time", "s"}, {"pressure", "Pa"}, {"porosity"}});
///     history.row({time, pressure, porosity});
///
/// Numbers are written with enough digits to be read back bit for bit. Throws std::runtime_error with the file and the
/// reason if the file cannot be written, std::logic_error if a row does not have one number per column, and
/// std::invalid_argument for a column without a name or with a character that would break the header (comma, quotation
/// mark, line break). Writes nothing on ranks other than the first (core/writes_files.hpp).
class CsvSeries {
 public:
  using Rows = std::vector<std::vector<double>>;

  /// Replaces the file atomically by one with these rows, for instance those of an earlier part of the run.
  CsvSeries(std::filesystem::path file, std::vector<CsvColumn> const& columns, Rows const& rows = {});

  /// Returns a table that continues after a restart: it begins with the rows of `from` (which may be the same file) up
  /// to `time` (compared with the first column). An incomplete last row is dropped. If `from` has only the first of
  /// these columns, because an earlier version wrote it, the missing values become NaN. Throws std::runtime_error if
  /// `from` cannot be read or has other columns.
  static CsvSeries continued(std::filesystem::path const& from, double time, std::filesystem::path file,
                             std::vector<CsvColumn> const& columns);

  /// Throws the std::runtime_error that continued() would throw because of the content of the file.
  static void check(std::filesystem::path const& from, std::vector<CsvColumn> const& columns);

  /// Appends a row of one number per column.
  void row(std::span<double const> values);
  void row(std::initializer_list<double> values) { row(std::span<double const>(values.begin(), values.size())); }

  /// Returns the path of the file.
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
