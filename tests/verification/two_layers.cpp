// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <tuple>
#include <utility>

// Long waves, without inertia, of a layer of grains of one size on a layer of another size in Bagnold flow: the claims
// of docs/theory/segregation.md, from fluxes that are integrated numerically. Lengths in depths of the flow, times so
// that the shear rate is sqrt(h - z) over the diameter.
namespace scree::test::two_layers_tests {
namespace {

using Complex = std::complex<double>;

struct Layers {
  double lower, upper;  ///< diameters

  /// Fluxes of the lower layer and of both, for the heights h1 of the border and h of the surface, by the midpoint rule
  /// over the velocity, which is integrated with it.
  std::array<double, 2> fluxes(double h1, double h) const {
    std::array<double, 2> all = {0, 0};
    double u = 0;
    for (auto const& [from, to, d, below] : {std::tuple{0.0, h1, lower, true}, std::tuple{h1, h, upper, false}}) {
      int const n = 4000;
      double const dz = (to - from) / n;
      for (int k = 0; k < n; ++k) {
        double const du = std::sqrt(h - (from + (k + 0.5) * dz)) / d * dz;
        if (below) all[0] += (u + du / 2) * dz;
        all[1] += (u + du / 2) * dz;
        u += du;
      }
    }
    return all;
  }
};

/// Growth rates over k^2 kappa of both waves for small k, the slower wave first, and whether their speeds are real.
struct Waves {
  bool real;
  double slow, fast;
};
Waves waves_of(Layers const& layers, double h1) {
  double const e = 1e-4, k = 1e-4, kappa = 1;
  auto const q = layers.fluxes(h1, 1);
  auto const by = [&](double d1, double d) {
    auto const a = layers.fluxes(h1 + d1, 1 + d), b = layers.fluxes(h1 - d1, 1 - d);
    return std::array<double, 2>{(a[0] - b[0]) / (2 * e), (a[1] - b[1]) / (2 * e)};
  };
  auto const by_border = by(e, 0), by_surface = by(0, e);
  // d/dt (h1, h) = -i k J - k^2 B: eigenvalues of the matrix.
  Complex const i(0, 1);
  Complex const a = -i * k * by_border[0], b = -i * k * by_surface[0] - k * k * kappa * q[0], c = -i * k * by_border[1],
                d = -i * k * by_surface[1] - k * k * kappa * q[1];
  Complex const root = std::sqrt((a - d) * (a - d) + 4.0 * b * c);
  std::array<Complex, 2> sigma = {(a + d + root) / 2.0, (a + d - root) / 2.0};
  if (-sigma[0].imag() > -sigma[1].imag()) std::swap(sigma[0], sigma[1]);
  double const difference = by_border[0] - by_surface[1];
  return {.real = difference * difference + 4 * by_surface[0] * by_border[1] > 0,
          .slow = sigma[0].real() / (k * k * kappa),
          .fast = sigma[1].real() / (k * k * kappa)};
}

}  // namespace

TEST_CASE("long waves of a border with large grains below decay, with small ones below they grow") {
  double least = 1;
  for (double const h1 : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (double const ratio : {1.2, 2.0, 5.0}) {
      auto const large_below = waves_of({ratio, 1}, h1), small_below = waves_of({1, ratio}, h1);
      INFO("border at " << h1 << ", ratio " << ratio << ": " << large_below.slow << ", " << small_below.slow);
      CHECK(large_below.real);
      CHECK(small_below.real);
      CHECK(large_below.slow < 0);
      CHECK(small_below.slow > 0);
      CHECK(large_below.fast < 0);
      CHECK(small_below.fast < 0);
      least = std::min(least, small_below.slow);
    }
  }
  auto const alike = waves_of({1, 1}, 0.5);
  INFO("least growth " << least << ", with grains of one size " << alike.slow);
  CHECK(std::abs(alike.slow) < 1e-3 * least);
}

}  // namespace scree::test::two_layers_tests
