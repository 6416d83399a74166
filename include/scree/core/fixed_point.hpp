// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "setting.hpp"
#include "types.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace scree {

/// A representation of doubles as integer multiples of a small unit. A sum of doubles is then a sum of integers, whose
/// value depends neither on the order of the terms nor on how they are divided among threads and ranks. Each term is
/// rounded to the unit, a power of two that is about 2^-61 of the largest possible sum. ExactSum does not round terms
/// but works only on the host.
class FixedPoint {
 public:
  FixedPoint() = default;
  /// Chooses the unit for sums of at most `terms` terms with magnitudes of at most `largest`. Throws
  /// std::invalid_argument if `largest` or `terms` is negative or not finite.
  FixedPoint(double largest, double terms) {
    check_setting(largest >= 0 && std::isfinite(largest), "the largest term of a sum", largest, "finite");
    check_setting(terms >= 0 && std::isfinite(terms), "the number of terms of a sum", terms, "finite");
    int exponent = 0;  // largest times terms is below 2^exponent
    std::frexp(largest * std::max(terms, 1.0), &exponent);
    units_ = largest > 0 ? std::ldexp(1.0, std::min(61 - exponent, 1000)) : 1;
  }
  /// Returns a term as a rounded number of units.
  SCREE_FN std::int64_t whole(double term) const { return static_cast<std::int64_t>(Kokkos::round(term * units_)); }
  /// Returns the value of a sum that is given as a number of units.
  double value(std::int64_t sum) const { return double(sum) / units_; }

 private:
  double units_ = 1;  // number of units in 1.0
};

}  // namespace scree
