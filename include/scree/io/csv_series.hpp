// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "write_file.hpp"

#include <fmt/ranges.h>

#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <span>
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
  CsvSeries(std::filesystem::path file, std::vector<CsvColumn> const& columns, Rows const& rows = {})
      : file_(std::move(file)), columns_(columns.size()) {
    for (auto const& column : columns) check(column);
    if (!writes_) return;
    std::string text = header_of(columns) + "\n";
    for (auto const& row : rows) text += line_of(row);
    write_file(file_, text);
    errno = 0;
    stream_.open(file_, std::ios::app);
    if (!stream_) fail_with_errno(file_, "write it");
  }

  /// Returns the table of another file, or of this one, which goes on after a restart: it has its rows up to a time
  /// (the first column). An incomplete last row is dropped. A table with fewer columns, which are the first of these,
  /// as an earlier version wrote it, gets NaN in the others. Throws std::runtime_error if the file cannot be read or
  /// has other columns.
  static CsvSeries continued(std::filesystem::path const& from, double time, std::filesystem::path file,
                             std::vector<CsvColumn> const& columns) {
    return {std::move(file), columns, writes_files() ? rows_until(time, from, columns) : Rows()};
  }

  /// Throws std::runtime_error where continued() would, as far as the content of the file decides that.
  static void check(std::filesystem::path const& from, std::vector<CsvColumn> const& columns) {
    rows_until(0, from, columns);
  }

  /// One number per column.
  void row(std::span<double const> values) {
    auto const line = line_of(values);
    errno = 0;
    if (writes_ && !(stream_ << line << std::flush)) fail_with_errno(file_, "write it");
  }
  void row(std::initializer_list<double> values) { row(std::span<double const>(values.begin(), values.size())); }

  /// The file that is written.
  std::filesystem::path const& path() const { return file_; }

 private:
  static std::string header_of(std::vector<CsvColumn> const& columns) {
    std::string header;
    for (auto const& column : columns) {
      if (!header.empty()) header += ',';
      header += column.header();
    }
    return header;
  }
  static Rows rows_until(double time, std::filesystem::path const& from, std::vector<CsvColumn> const& columns) {
    std::ifstream stream(from);
    std::string line;
    if (!std::getline(stream, line)) throw std::runtime_error(from.string() + ": cannot read it to continue the table");
    std::size_t there = columns.size();  // columns of the file
    while (there > 0 && line != header_of({columns.begin(), columns.begin() + std::ptrdiff_t(there)})) --there;
    if (there == 0)
      throw std::runtime_error(from.string() + ": its columns are " + line + ", not " + header_of(columns));
    Rows rows;
    while (std::getline(stream, line) && !stream.eof()) {
      std::vector<double> row;
      for (char const* at = line.c_str(); row.size() < there; ++at) {
        char* end = nullptr;
        row.push_back(std::strtod(at, &end));
        if (end == at || *end != ',') break;
        at = end;
      }
      if (row.size() != there || !(row[0] <= time * (1 + 1e-12))) continue;
      row.resize(columns.size(), std::numeric_limits<double>::quiet_NaN());
      rows.push_back(std::move(row));
    }
    return rows;
  }
  void check(CsvColumn const& column) const {
    auto const header = column.header();
    if (column.name.empty() || header.find_first_of(",\"\n\r") != std::string::npos)
      throw std::invalid_argument(
          "scree: " + file_.string() + ": '" + header +
          "' cannot head a column: it needs a name, and no comma, quotation mark or line break");
  }
  std::string line_of(std::span<double const> values) const {
    if (values.size() != columns_)
      throw std::logic_error(file_.string() + ": a row of " + std::to_string(values.size()) + " for " +
                             std::to_string(columns_) + " columns");
    return fmt::format("{}\n", fmt::join(values, ","));
  }

  std::filesystem::path file_;
  std::size_t columns_;
  std::ofstream stream_;
  bool writes_ = writes_files();
};

}  // namespace scree
