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
  CsvWriter(std::filesystem::path file, std::vector<std::string> const& columns)
      : file_(std::move(file)), columns_(columns.size()) {
    errno = 0;
    stream_.open(file_);
    if (!stream_) fail_with_errno(file_, "write it");
    put(fmt::format("{}\n", fmt::join(columns, ",")));
  }

  /// One number per column, written with all its digits.
  void row(std::span<double const> values) {
    if (values.size() != columns_) {
      throw std::logic_error(fmt::format("{}: a row of {} for {} columns", file_.string(), values.size(), columns_));
    }
    put(fmt::format("{}\n", fmt::join(values, ",")));
  }
  void row(std::initializer_list<double> values) { row(std::span<double const>(values.begin(), values.size())); }

 private:
  void put(std::string const& line) {
    errno = 0;
    if (!(stream_ << line << std::flush)) fail_with_errno(file_, "write it");
  }

  std::filesystem::path file_;
  std::size_t columns_;
  std::ofstream stream_;
};

}  // namespace support
