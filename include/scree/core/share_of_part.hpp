// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "setting.hpp"

#include <concepts>

namespace scree {

/// The share of one part, counted from 0, in the points of a case. Team::share() gives it.
struct ShareOfPart {
  int part = 0, parts = 1;

  /// Throws std::invalid_argument unless there is such a part.
  void check() const {
    check_setting(parts > 0, "the number of shares", parts, "1 or more");
    check_setting(part >= 0 && part < parts, "the number of a share", part, "from 0, below the number of shares");
  }
  /// The first of `all` points that belongs to this share; that of the next share follows its last one. Shares differ
  /// by one point at most.
  long first_of(long all) const { return all / parts * part + all % parts * part / parts; }
  long end_of(long all) const { return ShareOfPart{part + 1, parts}.first_of(all); }
};
/// Functions take it so, because braces around coordinates must not become a share.
template <class T>
concept IsShareOfPart = std::same_as<T, ShareOfPart>;

}  // namespace scree
