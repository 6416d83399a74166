// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "csv_series.hpp"

#include <fmt/ranges.h>

#include <cerrno>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace scree {

SCREE_BODY CsvSeries::CsvSeries(std::filesystem::path file, std::vector<CsvColumn> const& columns, Rows const& rows)
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

SCREE_BODY CsvSeries CsvSeries::continued(std::filesystem::path const& from, double time, std::filesystem::path file,
                                          std::vector<CsvColumn> const& columns) {
  return {std::move(file), columns, writes_files() ? rows_until(time, from, columns) : Rows()};
}

SCREE_BODY void CsvSeries::check(std::filesystem::path const& from, std::vector<CsvColumn> const& columns) {
  rows_until(0, from, columns);
}

SCREE_BODY void CsvSeries::row(std::span<double const> values) {
  auto const line = line_of(values);
  errno = 0;
  if (writes_ && !(stream_ << line << std::flush)) fail_with_errno(file_, "write it");
}

SCREE_BODY std::string CsvSeries::header_of(std::vector<CsvColumn> const& columns) {
  std::string header;
  for (auto const& column : columns) {
    if (!header.empty()) header += ',';
    header += column.header();
  }
  return header;
}

SCREE_BODY CsvSeries::Rows CsvSeries::rows_until(double time, std::filesystem::path const& from,
                                                 std::vector<CsvColumn> const& columns) {
  std::ifstream stream(from);
  std::string line;
  if (!std::getline(stream, line)) throw std::runtime_error(from.string() + ": cannot read it to continue the table");
  std::size_t there = columns.size();  // number of columns in the file
  while (there > 0 && line != header_of({columns.begin(), columns.begin() + std::ptrdiff_t(there)})) --there;
  if (there == 0) throw std::runtime_error(from.string() + ": its columns are " + line + ", not " + header_of(columns));
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

SCREE_BODY void CsvSeries::check(CsvColumn const& column) const {
  auto const header = column.header();
  if (column.name.empty() || header.find_first_of(",\"\n\r") != std::string::npos)
    throw std::invalid_argument("scree: " + file_.string() + ": '" + header +
                                "' cannot head a column: it needs a name, and no comma, quotation mark or line break");
}

SCREE_BODY std::string CsvSeries::line_of(std::span<double const> values) const {
  if (values.size() != columns_)
    throw std::logic_error(file_.string() + ": a row of " + std::to_string(values.size()) + " for " +
                           std::to_string(columns_) + " columns");
  return fmt::format("{}\n", fmt::join(values, ","));
}

}  // namespace scree
