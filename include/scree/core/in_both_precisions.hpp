// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "pack.hpp"

namespace scree {

/// The constants of a term in double and in single precision. A single-precision loop with constants in double
/// precision would convert them for each pair, or keep a register for each.
template <int Size>
class InBothPrecisions {
  Vec<Size, double> exact_ = zero<Vec<Size, double>>();
  Vec<Size, float> rounded_ = zero<Vec<Size, float>>();

 public:
  /// Sets all constants to zero.
  InBothPrecisions() = default;
  /// Sets the constants to given values.
  explicit InBothPrecisions(Vec<Size, double> const& values) {
    for (int k = 0; k < Size; ++k) set(k, values[k]);
  }
  /// Sets the k-th constant.
  void set(int k, double value) { exact_[k] = value, rounded_[k] = float(value); }
  /// Returns the k-th constant in the precision of Real or, if Real is a pack, in the precision of its numbers.
  template <class Real>
  SCREE_LOOP_FN number_in<Real> of(int k) const {
    if constexpr (std::is_same_v<number_in<Real>, float>)
      return rounded_.data()[k];
    else
      return exact_.data()[k];
  }
};

}  // namespace scree
