// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace scree {

/// A sum of doubles without rounding, stored as a long fixed-point number (Kulisch accumulator). Its value depends
/// neither on the order of the terms nor on how they are divided among ranks. At most 2^30 terms may be added
/// consecutively; adding another ExactSum resets this count. An infinite or NaN term makes the value NaN. ExactSum
/// works only on the host.
class ExactSum {
 public:
  ExactSum& operator+=(double term) {
    if (!std::isfinite(term)) {
      finite_ = false;
      return *this;
    }
    if (term == 0) return *this;
    int exponent = 0;  // term = fraction * 2^exponent, |fraction| in [1/2, 1)
    double const fraction = std::frexp(term, &exponent);
    auto const bits = static_cast<std::int64_t>(std::ldexp(std::abs(fraction), 53));
    int const place =
        exponent - 53 + lowest;  // place of the last bit; negative only for subnormal terms, whose lowest bits are zero
    std::int64_t const sign = term < 0 ? -1 : 1;
    auto const digit = static_cast<std::size_t>(place < 0 ? 0 : place / width);
    auto const wide = place < 0 ? Wide(bits >> -place) : Wide(bits) << (place % width);
    for (std::size_t k = 0; k < 3; ++k)
      digits_[digit + k] += sign * static_cast<std::int64_t>((wide >> (width * int(k))) & mask);
    return *this;
  }
  ExactSum& operator+=(ExactSum const& other) {
    carry();
    ExactSum theirs = other;
    theirs.carry();
    for (std::size_t k = 0; k < count; ++k) digits_[k] += theirs.digits_[k];
    finite_ = finite_ && other.finite_;
    carry();
    return *this;
  }
  /// Returns the sum with an error of less than one unit in the last place.
  double value() const {
    if (!finite_) return std::numeric_limits<double>::quiet_NaN();
    ExactSum magnitude = *this;
    magnitude.carry();
    bool const negative = magnitude.digits_[count - 1] < 0;
    if (negative) {
      for (auto& digit : magnitude.digits_) digit = -digit;
      magnitude.carry();
    }
    // Add digits from the highest down; digits after the third significant one are below the last place.
    double sum = 0;
    int used = 0;
    for (std::size_t k = count; k-- > 0 && used < 3;) {
      if (used > 0 || magnitude.digits_[k] != 0) ++used;
      sum += std::ldexp(double(magnitude.digits_[k]), int(k) * width - lowest);
    }
    return negative ? -sum : sum;
  }

 private:
  __extension__ typedef unsigned __int128 Wide;  // nvcc rejects __extension__ on an alias
  static constexpr int width = 32;               // bits of a digit; higher bits hold carries
  static constexpr int lowest = 1088;            // the last bit of digit 0 is worth 2^-lowest
  static constexpr std::size_t count = (1088 + 1024) / 32 + 4;
  static constexpr Wide mask = (Wide(1) << width) - 1;

  /// Brings all digits but the last into [0, 2^width), so that equal sums have equal digits.
  void carry() {
    std::int64_t over = 0;
    for (std::size_t k = 0; k + 1 < count; ++k) {
      std::int64_t const digit = digits_[k] + over;
      over = digit >> width;  // rounds down
      digits_[k] = digit - over * (std::int64_t(1) << width);
    }
    digits_[count - 1] += over;
  }

  std::array<std::int64_t, count> digits_ = {};
  bool finite_ = true;
};

}  // namespace scree
