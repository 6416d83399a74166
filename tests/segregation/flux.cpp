// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/flux.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::test::flux_tests {
namespace {

SegregationFlux const fluxes[] = {SegregationFlux::symmetric(),
                                  SegregationFlux::asymmetric(),
                                  {.amplitude = 0.7, .asymmetry = 0.3},
                                  {.amplitude = 10, .asymmetry = 1}};

template <class Real>
Real mean(SegregationFlux const& flux, Real a, Real b) {
  return flux.mean(a, b, flux.potential(a), flux.potential(b));
}
/// Smallest and largest F between two concentrations, by sampling.
std::pair<double, double> range(SegregationFlux const& flux, double a, double b) {
  double low = flux.value(a), high = low;
  for (int k = 1; k <= 1000; ++k) {
    double const F = flux.value(a + (b - a) * k / 1000);
    low = std::min(low, F);
    high = std::max(high, F);
  }
  return {low, high};
}

using Reals = std::tuple<float, double>;

}  // namespace

TEST_CASE("the flux function vanishes at both ends and has the values of the paper") {
  for (auto const& flux : fluxes) {
    CHECK(flux.value(0.0) == 0);
    CHECK(flux.value(1.0) == 0);
  }
  CHECK(SegregationFlux::symmetric().value(0.5) == 0.25);
  CHECK(std::abs(SegregationFlux::asymmetric().value(0.5) - 1.6 * 0.25 * 0.555) < 1e-15);  // 1 - 0.89/2
}

TEST_CASE("the slope of the flux function is its derivative") {
  double const step = 1e-5;
  for (auto const& flux : fluxes)
    for (double const C : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      double const difference = (flux.value(C + step) - flux.value(C - step)) / (2 * step);
      // step^2/6 of the third derivative, 6 A kappa, and rounding.
      CHECK(std::abs(flux.slope(C) - difference) < 1.1e-10 * std::max(10.0, flux.amplitude * 10));
    }
}

TEST_CASE("the potential is the integral of 1/F") {
  double const step = 1e-5;
  for (auto const& flux : fluxes)
    for (double const C : {0.05, 0.2, 0.5, 0.77, 0.95}) {
      double const difference = (flux.potential(C + step) - flux.potential(C - step)) / (2 * step);
      CHECK(std::abs(difference * flux.value(C) - 1) < 1e-6);  // step^2/6 of (1/F)''/(1/F), about 2/C^2
    }
  CHECK(SegregationFlux::symmetric().potential(0.5) == 0);
  CHECK(SegregationFlux::asymmetric().potential(0.0) == -std::numeric_limits<double>::infinity());
  CHECK(SegregationFlux::asymmetric().potential(1.0) == std::numeric_limits<double>::infinity());
}

TEMPLATE_LIST_TEST_CASE("the mean flux is symmetric and lies between the values of F on its interval", "", Reals) {
  using Real = TestType;
  // (C_i - C_j)/(theta_i - theta_j) is the harmonic mean of F over the interval.
  double const eps = std::numeric_limits<Real>::epsilon();
  for (auto const& flux : fluxes)
    for (Real const a : {Real(0.001), Real(0.1), Real(0.3), Real(0.5), Real(0.9), Real(0.999)})
      for (Real const b : {Real(0.002), Real(0.1), Real(0.31), Real(0.5), Real(0.7), Real(0.998)}) {
        INFO("A " << flux.amplitude << ", kappa " << flux.asymmetry << ", from " << a << " to " << b);
        Real const found = mean(flux, a, b);
        auto const [low, high] = range(flux, double(a), double(b));
        CHECK(found == mean(flux, b, a));
        // The potentials are of order ten and their difference at least 0.02 where the division is done.
        CHECK(double(found) >= low * (1 - 5000 * eps));
        CHECK(double(found) <= high * (1 + 5000 * eps));
      }
}

TEST_CASE("the mean flux is that of an equilibrium") {
  // theta = log(C/(1 - C)) for the symmetric flux: between C = 1/(1 + e) and 1/2 it rises by one.
  double const C = 1 / (1 + std::exp(1.0));
  CHECK(std::abs(mean(SegregationFlux::symmetric(), C, 0.5) - (0.5 - C)) < 1e-15);
}

TEMPLATE_LIST_TEST_CASE("the mean flux vanishes where one side has grains of one size only", "", Reals) {
  using Real = TestType;
  for (auto const& flux : fluxes)
    for (Real const end : {Real(0), Real(1)}) {
      for (Real const other : {Real(1e-6), Real(0.3), Real(0.999), Real(1) - end}) {
        CHECK(mean(flux, end, other) == 0);
        CHECK(mean(flux, other, end) == 0);
      }
      CHECK(mean(flux, end, end) == 0);
    }
}

TEST_CASE("the potential is continuous up to kappa = 1") {
  for (double const C : {1e-9, 0.3, 0.9, 0.999}) {
    double const x = C / (1 - C), at_one = std::log(C) - std::log(1 - C) + x;
    CHECK(std::abs(SegregationFlux{.asymmetry = 1}.potential(C) - at_one) < 1e-14 * (std::abs(at_one) + x));
    for (double const room : {1e-3, 1e-6, 1e-12, 1e-15}) {
      // ln(1 + room x)/room = x - room x^2/2 + ...
      double const found = SegregationFlux{.asymmetry = 1 - room}.potential(C);
      CHECK(std::abs(found - at_one) < 1e-13 * (1 + x) + room * (x + x * x));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("the mean flux of concentrations that rounding has put out of the range is zero up to rounding",
                        "", Reals) {
  using Real = TestType;
  Real const eps = std::numeric_limits<Real>::epsilon();
  for (auto const& flux : fluxes)
    for (Real const beyond : {Real(1) + eps, Real(1) + 9 * eps, -eps, -std::numeric_limits<Real>::denorm_min()})
      for (Real const other : {beyond, Real(1), Real(0), Real(1) - eps, Real(0.4), Real(1) + 2 * eps, -3 * eps}) {
        CHECK(std::abs(mean(flux, beyond, other)) < 20 * flux.amplitude * eps);
        CHECK(std::abs(mean(flux, other, beyond)) < 20 * flux.amplitude * eps);
      }
}

TEST_CASE("a flux function out of range is refused") {
  auto const not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (double const kappa : {-0.01, 1.01, not_a_number})
    CHECK_THROWS_AS((SegregationFlux{.asymmetry = kappa}.check()), std::invalid_argument);
  for (double const A : {0.0, -1.0, not_a_number})
    CHECK_THROWS_AS((SegregationFlux{.amplitude = A}.check()), std::invalid_argument);
  for (auto const& flux : fluxes) CHECK_NOTHROW(flux.check());
}

TEMPLATE_LIST_TEST_CASE("the sharp flux spreads more than the exact one in shocks and in fans", "", Reals) {
  using Real = TestType;
  // Without diffusion, between states a and b, the flux of the entropy C^2/2 must not be less dissipative than the mean
  // of F over the interval (Tadmor 1987): lower in a shock, higher in a fan where F is concave.
  double const eps = std::numeric_limits<Real>::epsilon();
  auto const flux = SegregationFlux::symmetric();
  for (Real const a : {Real(0), Real(0.1), Real(0.4), Real(0.5), Real(0.8)})
    for (Real const b : {Real(0.2), Real(0.6), Real(0.9), Real(1)}) {
      if (a >= b) continue;
      double const x = double(a), y = double(b);
      double const mean_over = (sq(y) / 2 - y * sq(y) / 3 - sq(x) / 2 + x * sq(x) / 3) / (y - x);
      CHECK(double(flux.sharp(a, b)) <= mean_over + eps);
      CHECK(double(flux.sharp(b, a)) >= mean_over - eps);
    }
}

TEST_CASE("the sharp flux lets sorted grains rest and the others pass") {
  for (auto const& flux : fluxes) {
    CHECK(flux.sharp(0.0, 1.0) == 0);                // small ones below: a steady shock
    CHECK(flux.sharp(1.0, 0.0) == flux.value(0.5));  // small ones above
    for (double const C : {0.0, 0.3, 1.0}) CHECK(flux.sharp(C, C) == flux.value(C));
  }
}

TEMPLATE_LIST_TEST_CASE("the mean flux of nearly equal concentrations keeps its digits", "", Reals) {
  using Real = TestType;
  constexpr bool is_double = std::is_same_v<Real, double>;
  // Where the division is still done, differences of theta (up to 7 here) have a relative error of eps
  // |theta|/threshold, 1e-15/1e-5 and 6e-7/1e-3 with the thresholds of the class. The midpoint itself is off by some
  // tenths of step^2.
  double const close = is_double ? 2e-9 : 2e-2;
  for (auto const& flux : fluxes)
    for (Real const C : {Real(0.001), Real(0.2), Real(0.5), Real(0.95)})
      for (Real const step :
           {Real(0), std::numeric_limits<Real>::epsilon(), Real(1e-12), Real(1e-6), Real(1e-5), Real(1e-3)}) {
        Real const room = std::min(C, 1 - C), other = C + step * room;
        INFO("from " << C << " by " << step);
        Real const found = mean(flux, C, other);
        CHECK(std::abs(double(found) / flux.value((double(C) + double(other)) / 2) - 1) < close + sq(double(step)) / 4);
        CHECK(found == mean(flux, other, C));
      }
}

#ifdef SCREE_HAS_PACKS
TEMPLATE_LIST_TEST_CASE("the mean flux of packs is that of numbers", "", Reals) {
  using Real = TestType;
  using Lanes = Pack<Real>;
  // Both ends, equal, nearly equal and different concentrations in adjacent lanes: a value in one lane must not affect
  // another, as potentials at the ends, which are infinite, might.
  Real const near = Real(0.3) * (1 + 8 * std::numeric_limits<Real>::epsilon());
  Real const all[] = {0, 1, Real(0.3), near, Real(0.8), Real(0.3), 1, 0, 0, Real(0.5)};
  constexpr int count = 10;
  bool same = true;
  for (auto const& flux : fluxes)
    for (int first = 0; first < count; ++first)
      for (int apart = 0; apart < count; ++apart) {
        auto const a = [&](int lane) { return all[(first + lane) % count]; };
        auto const b = [&](int lane) { return all[(first + lane + apart) % count]; };
        auto const theta = [&](auto const& C) { return Lanes::of([&](int lane) { return flux.potential(C(lane)); }); };
        auto const packs = flux.mean(Lanes::of(a), Lanes::of(b), theta(a), theta(b));
        for (int lane = 0; lane < Lanes::size; ++lane) {
          Real const number = mean(flux, a(lane), b(lane));
          // A compiler may contract products and sums in one and not in the other.
          same = same && std::abs(packs[lane] - number) <= 8 * std::numeric_limits<Real>::epsilon() * number;
        }
      }
  CHECK(same);
}
#endif

}  // namespace scree::test::flux_tests
