// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace scree::test {

/// Nodes and weights of the Gauss-Legendre rule on [-1, 1] by Newton's method on the Legendre polynomial; exact for
/// polynomials of degree 2 n - 1.
inline std::vector<std::pair<double, double>> gauss_legendre(int n) {
  std::vector<std::pair<double, double>> rule;
  for (int k = 0; k < n; ++k) {
    double x = std::cos(3.14159265358979323846 * (k + 0.75) / (n + 0.5)), slope = 1;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double before = 1, here = x;
      for (int m = 2; m <= n; ++m) before = std::exchange(here, ((2 * m - 1) * x * here - (m - 1) * before) / m);
      slope = n * (x * here - before) / (x * x - 1);
      x -= here / slope;
    }
    rule.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

/// Integral over [0, end] in pieces of 1/2, so that the knots of all splines are at their ends.
template <class F>
double integrate_from_zero(double end, F const& f, std::vector<std::pair<double, double>> const& rule) {
  double sum = 0;
  for (double low = 0; low < end; low += 0.5)
    for (auto const& [x, weight] : rule) sum += weight / 4 * f(low + (1 + x) / 4);
  return sum;
}
/// Integral over [0, end] in pieces of 1/2 with 20 nodes each, exact to degree 39.
template <class F>
double integrate_from_zero(double end, F const& f) {
  static auto const rule = gauss_legendre(20);
  return integrate_from_zero(end, f, rule);
}

}  // namespace scree::test
