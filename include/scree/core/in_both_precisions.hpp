// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "pack.hpp"

namespace scree {

/// Constants of a term in double and in single precision: a loop in float that converted them would do so for each
/// pair, or keep a register for each.
template <int Size>
class InBothPrecisions {
  Vec<Size, double> exact_ = zero<Vec<Size, double>>();
  Vec<Size, float> rounded_ = zero<Vec<Size, float>>();

 public:
  /// Zeros.
  InBothPrecisions() = default;
  /// Given values.
  explicit InBothPrecisions(Vec<Size, double> const& values) {
    for (int k = 0; k < Size; ++k) set(k, values[k]);
  }
  /// Sets the k-th constant.
  void set(int k, double value) { exact_[k] = value, rounded_[k] = float(value); }
  /// The k-th constant in the precision of Real, of a pack that of its numbers.
  template <class Real>
  SCREE_LOOP_FN number_in<Real> of(int k) const {
    if constexpr (std::is_same_v<number_in<Real>, float>)
      return rounded_.data()[k];
    else
      return exact_.data()[k];
  }
};

}  // namespace scree
