// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "write_file.hpp"

#include <initializer_list>
#include <span>
#include <vector>

namespace support {

/// A table of numbers as comma-separated values, complete on the disk after every row.
///     CsvWriter history(dir / "history.csv", {"t_over_T", "mean_C"});
///     history.row({t, mean});
/// Throws std::runtime_error with file and reason when it cannot be written, std::logic_error for a row of another
/// length.
class CsvWriter {
 public:
  using Rows = std::vector<std::vector<double>>;

  /// Replaces the file by one with these rows, in one step.
  CsvWriter(std::filesystem::path file, std::vector<std::string> const& columns, Rows const& rows = {})
      : file_(std::move(file)), columns_(columns.size()) {
    auto text = fmt::format("{}\n", fmt::join(columns, ","));
    for (auto const& row : rows) text += line_of(row);
    write_file(file_, text);
    errno = 0;
    stream_.open(file_, std::ios::app);
    if (!stream_) fail_with_errno(file_, "write it");
  }

  /// One number per column, written with all its digits.
  void row(std::span<double const> values) { put(line_of(values)); }
  void row(std::initializer_list<double> values) { row(std::span<double const>(values.begin(), values.size())); }

 private:
  std::string line_of(std::span<double const> values) const {
    if (values.size() != columns_) {
      throw std::logic_error(fmt::format("{}: a row of {} for {} columns", file_.string(), values.size(), columns_));
    }
    return fmt::format("{}\n", fmt::join(values, ","));
  }

  void put(std::string const& line) {
    errno = 0;
    if (!(stream_ << line << std::flush)) fail_with_errno(file_, "write it");
  }

  std::filesystem::path file_;
  std::size_t columns_;
  std::ofstream stream_;
};

}  // namespace support
