// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <vector>

namespace scree::detail {

/// Which columns of a body its ghosts have with the present values. Changes of positions are always announced, those of
/// other fields only while a list of passes runs: what ghosts were told outside of one does not count later.
class ToldColumns {
 public:
  /// The ghosts are new and have nothing. `position`: the number of the column with the positions.
  void renew(std::size_t position) {
    position_ = position;
    has_positions_ = false;
    told_.clear();
  }
  void positions_changed() { has_positions_ = false; }
  void changed(std::size_t column) {
    if (column == position_) positions_changed();
    if (column < told_.size()) told_[column] = false;
  }
  /// Forgets all but the positions. From now on all changes are announced, or no more.
  void forget(bool all_announced) {
    told_.clear();
    all_announced_ = all_announced;
  }
  /// Those of some columns that the ghosts do not have. They get them now.
  std::vector<std::size_t> due(std::vector<std::size_t> columns) {
    std::erase_if(columns, [&](std::size_t column) { return has(column); });
    for (std::size_t const column : columns) {
      if (column >= told_.size()) told_.resize(column + 1, false);
      told_[column] = all_announced_;
      if (column == position_) has_positions_ = true;
    }
    return columns;
  }

 private:
  bool has(std::size_t column) const {
    return column == position_ ? has_positions_ : column < told_.size() && told_[column];
  }

  std::size_t position_ = 0;
  bool has_positions_ = false, all_announced_ = false;
  std::vector<bool> told_;
};

}  // namespace scree::detail
