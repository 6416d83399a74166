// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/laws/law.hpp>

#include <cmath>
#include <random>

namespace scree::test {

/// Trial stresses over many orders of magnitude, also of their ratio: deep inside, far outside, near the apex, in
/// tension.
template <int Dim, class Real>
class RandomStresses {
 public:
  StressTensor<Real> next() {
    Vec<symmetric3_size<Dim>, double> s;
    for (int k = 0; k < s.size(); ++k) s[k] = uniform(-1, 1);
    double const p = std::pow(10, uniform(-5, 4)) * (count_++ % 3 == 0 ? -1 : 1);
    StressTensor<double> const shear = std::abs(p) * std::pow(10, uniform(-3, 5)) * deviator_of(unpacked(s));
    return (shear - p * StressTensor<double>::Identity()).template cast<Real>();
  }

 private:
  double uniform(double low, double high) { return low + (high - low) * std::ldexp(double(random_() >> 11), -53); }
  std::mt19937_64 random_{7};
  int count_ = 0;
};
}  // namespace scree::test
