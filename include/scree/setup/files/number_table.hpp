// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Tables of numbers from text with comma-separated values.
namespace scree::detail {

std::string_view trimmed(std::string_view text);

std::vector<std::string_view> split_at(std::string_view line, char separator);

struct NumberTable {
  std::string name;  ///< name of the file
  std::vector<std::vector<double>> rows = {};
  std::vector<int> lines = {};  ///< line of each row in the file, from 1

  /// Throws std::runtime_error about the number in a row and a column, both counted from 0.
  [[noreturn]] void fail(std::size_t row, std::size_t column, std::string const& why) const {
    fail_at(lines[row], column, why);
  }
  [[noreturn]] void fail_at(int line, std::size_t column, std::string const& why) const {
    throw std::runtime_error(name + ", line " + std::to_string(line) + ", column " + std::to_string(column + 1) + ": " +
                             why);
  }
};

/// Returns the table of numbers in a text, whose columns have these units. Throws std::runtime_error, with the file,
/// the line and the column, if the text does not follow this format.
NumberTable read_numbers(std::string_view text, std::string const& name, std::vector<std::string> const& units);

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "number_table.ipp"
#endif
