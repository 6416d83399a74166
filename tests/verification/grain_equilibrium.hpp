// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/segregation/shear_rate_closure.hpp>

#include <cmath>

namespace scree::test {

/// Where V F = D |dC/dz| with V = chi_V gamma d, D = chi_D gamma d^2, d = d_S C + d_L (1 - C) and F = C (1 - C), the
/// shear rate gamma drops out:  C^d_L (1 - C)^(-d_S) = K exp(-(chi_V/chi_D) z),  K from the mean of C over the depth
/// (m).
class GrainEquilibrium {
 public:
  GrainEquilibrium(ShearRateClosure const& closure, double depth, double mean) : closure_(closure) {
    double low = -100, high = 100;  // of the logarithm of K^(1/d_L)
    for (int step = 0; step < 100; ++step) {
      log_K_ = (low + high) / 2;
      (mean_over(depth) < mean ? low : high) = log_K_;
    }
  }

  /// C at a height, m.
  double operator()(double z) const {
    double const wanted = log_K_ - closure_.chi_V / closure_.chi_D * z / closure_.d_large;
    double low = -700, high = 700;  // of log(C/(1 - C))
    for (int step = 0; step < 100; ++step) {
      double const s = (low + high) / 2, log_C = -std::log1p(std::exp(-s)), log_rest = -std::log1p(std::exp(s));
      (log_C - closure_.d_small / closure_.d_large * log_rest < wanted ? low : high) = s;
    }
    return 1 / (1 + std::exp(-(low + high) / 2));
  }

 private:
  double mean_over(double depth) const {
    int const parts = 400;
    double sum = 0;
    for (int k = 0; k < parts; ++k) sum += (*this)((k + 0.5) / parts * depth) / parts;
    return sum;
  }

  ShearRateClosure closure_;
  double log_K_ = 0;
};

}  // namespace scree::test
