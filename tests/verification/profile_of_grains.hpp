// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace scree::test {

/// The concentration of small grains over a depth (m) in equilibrium, dC/dz = -r(z, C) C (1 - C) with the ratio r =
/// V/D (1/m) at a height z, and a given mean: by Runge-Kutta steps of fourth order of ln(C/(1 - C)) from the floor,
/// whose value is found by bisection.
class ProfileOfGrains {
 public:
  using Ratio = std::function<double(double z, double C)>;

  ProfileOfGrains(Ratio const& ratio, double depth, double mean, int steps = 2000)
      : dz_(depth / steps), C_(std::size_t(steps) + 1) {
    double low = -100, high = 100;
    for (int k = 0; k < 100; ++k) {
      double const middle = (low + high) / 2;
      integrate(ratio, middle);
      (this->mean(0, depth) < mean ? low : high) = middle;
    }
  }
  /// C at a height (m), by linear interpolation.
  double operator()(double z) const {
    double const at = z / dz_;
    auto const k = std::size_t(std::min(std::max(at, 0.0), double(C_.size() - 2)));
    return C_[k] + (at - double(k)) * (C_[k + 1] - C_[k]);
  }
  /// The mean between two heights (m).
  double mean(double from, double to) const {
    double sum = 0;
    int const parts = 4 * int(std::ceil((to - from) / dz_));
    for (int k = 0; k < parts; ++k) sum += (*this)(from + (k + 0.5) / parts * (to - from)) / parts;
    return sum;
  }

 private:
  static double C_of(double s) { return 1 / (1 + std::exp(-s)); }
  void integrate(Ratio const& ratio, double s) {
    auto const slope = [&](double z, double of) { return -ratio(z, C_of(of)); };
    for (std::size_t k = 0; k < C_.size(); ++k) {
      C_[k] = C_of(s);
      double const z = double(k) * dz_, a = slope(z, s), b = slope(z + dz_ / 2, s + dz_ / 2 * a),
                   c = slope(z + dz_ / 2, s + dz_ / 2 * b), d = slope(z + dz_, s + dz_ * c);
      s += dz_ / 6 * (a + 2 * b + 2 * c + d);
    }
  }

  double dz_;
  std::vector<double> C_;
};

}  // namespace scree::test
