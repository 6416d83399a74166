// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "write_file.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <span>
#include <vector>

namespace scree {

/// A column of a table. Its header is "name [unit]", or the name alone for a number without a unit.
struct CsvColumn {
  std::string name, unit;

  CsvColumn(char const* name_, char const* unit_ = "") : name(name_), unit(unit_) {}  // NOLINT: {"t", "s"}
  CsvColumn(std::string name_, std::string unit_ = "") : name(std::move(name_)), unit(std::move(unit_)) {}  // NOLINT
  std::string header() const { return unit.empty() ? name : name + " [" + unit + "]"; }
};

/// A table of numbers as comma-separated values, complete on the disk after every row.
///
///     CsvSeries history("history.csv", {{"time", "s"}, {"pressure", "Pa"}, {"porosity"}});
///     history.row({time, pressure, porosity});
///
/// Numbers have all their digits: reading them gives the same bits. Throws std::runtime_error with file and reason if
/// the file cannot be written, std::logic_error for a row of another length, and std::invalid_argument for a column
/// without a name or one that would break the header (comma, quotation mark, line break).
class CsvSeries {
 public:
  using Rows = std::vector<std::vector<double>>;

  /// Replaces the file by one with these rows, in one step. The rows of an earlier part of a run go here.
  CsvSeries(std::filesystem::path file, std::vector<CsvColumn> const& columns, Rows const& rows = {})
      : file_(std::move(file)), columns_(columns.size()) {
    std::string text;
    for (auto const& column : columns) {
      if (!text.empty()) text += ',';
      text += checked(column);
    }
    text += '\n';
    for (auto const& row : rows) text += line_of(row);
    write_file(file_, text);
    errno = 0;
    stream_.open(file_, std::ios::app);
    if (!stream_) fail_with_errno(file_, "write it");
  }

  /// One number per column.
  void row(std::span<double const> values) {
    auto const line = line_of(values);
    errno = 0;
    if (!(stream_ << line << std::flush)) fail_with_errno(file_, "write it");
  }
  void row(std::initializer_list<double> values) { row(std::span<double const>(values.begin(), values.size())); }

  std::filesystem::path const& path() const { return file_; }

 private:
  std::string checked(CsvColumn const& column) const {
    auto header = column.header();
    if (column.name.empty() || header.find_first_of(",\"\n\r") != std::string::npos)
      throw std::invalid_argument(
          "scree: " + file_.string() + ": '" + header +
          "' cannot head a column: it needs a name, and no comma, quotation mark or line break");
    return header;
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
};

}  // namespace scree
