// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <vector>

namespace scree::detail {

/// Tracks which columns of the ghosts of a body are up to date. Changes of positions are always announced, but changes
/// of other fields only while a list of passes runs; a column that is copied at any other time is treated as outdated
/// afterwards.
class CurrentColumns {
 public:
  /// Marks all columns of new ghosts as outdated. `position` is the number of the position column.
  void renew(std::size_t position) {
    position_ = position;
    has_positions_ = false;
    current_.clear();
  }
  void positions_changed() { has_positions_ = false; }
  void changed(std::size_t column) {
    if (column == position_) positions_changed();
    if (column < current_.size()) current_[column] = false;
  }
  /// Marks all columns except the positions as outdated. `all_announced`: whether all later changes are announced.
  void forget(bool all_announced) {
    current_.clear();
    all_announced_ = all_announced;
  }
  /// Returns the outdated ones among some columns of the ghosts and marks them as up to date; the caller must copy
  /// them.
  std::vector<std::size_t> due(std::vector<std::size_t> columns) {
    std::erase_if(columns, [&](std::size_t column) { return has(column); });
    for (std::size_t const column : columns) {
      if (column >= current_.size()) current_.resize(column + 1, false);
      current_[column] = all_announced_;
      if (column == position_) has_positions_ = true;
    }
    return columns;
  }

 private:
  bool has(std::size_t column) const {
    return column == position_ ? has_positions_ : column < current_.size() && current_[column];
  }

  std::size_t position_ = 0;
  bool has_positions_ = false, all_announced_ = false;
  std::vector<bool> current_;
};

}  // namespace scree::detail
