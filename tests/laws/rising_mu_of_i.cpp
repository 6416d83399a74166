// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"

#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/well_posedness.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::rising_mu_of_i_tests {
namespace {

RisingMuOfI<> const law{{.elastic = soft(), .grains = {5e-4}}, 0.05};
double const G = law.elastic.shear_modulus(), nan = std::numeric_limits<double>::quiet_NaN(),
             infinite = std::numeric_limits<double>::infinity();

// mu without regularisation.
double mu_of(double I) { return (law.mu_s * law.I0 + law.mu_d * I + law.mu_inf * I * I) / (law.I0 + I); }
double shear_rate_at(double I, double p) { return I * std::sqrt(p / law.grain_density) / law.grains.diameter; }

}  // namespace

TEST_CASE("rising mu(I): simple shear finds k_mu(mu(I)) for I from 1e-4 to 100") {
  for (double const p : {20.0, 200.0})
    for (double const I : {1e-4, 1e-2, 0.1, 1.0, 10.0, 100.0}) {
      Element<RisingMuOfI<>> element{law};
      element.set_pressure(p);
      double const gamma_dot = shear_rate_at(I, p);
      element.shear_on(simple_shear(gamma_dot), 40 * 0.87 * p / G / gamma_dot, 8000);
      double const tau = element.sigma[3], k = friction_ratio(mu_of(I)), S = element.tau();
      CAPTURE(p, I, tau / p, k, relative(tau / p, k));
      CHECK(relative(tau / p, k) < (p == 20 ? 1.5e-7 : 1.5e-5));  // (k p/G)^2/2 and the regularisation
      CHECK(relative(element.p(), p) < 1e-13);
      CHECK(relative(S, law.shear_strength(p, element.point)) < 1e-13);
      CHECK(relative(tau, S * std::sqrt(1 - sq(S / G))) < 1e-13);
    }
}

TEST_CASE("rising mu(I): without mu_inf it is mu(I), bit for bit") {
  RisingMuOfI<BidisperseGrains> const flat{{.elastic = soft(), .grains = {2.5e-4, 5e-4}}, 0};
  MuOfI<BidisperseGrains> const& plain = flat;
  for (double const p : {-1.0, 0.0, 1e-3, 20.0, 1e5})
    for (double const gamma_dot : {0.0, 1e-6, 1.0, 1e4})
      for (double const C : {0.0, 0.3}) {
        Point<> const point{gamma_dot, C};
        CHECK(flat.friction(p, gamma_dot, 5e-4) == plain.friction(p, gamma_dot, 5e-4));
        CHECK(flat.shear_strength(p, point) == plain.shear_strength(p, point));
        Mat<3, double> trial = -p * Mat<3, double>::Identity();
        trial(0, 1) = trial(1, 0) = 2 * p + 1;
        CHECK(flat.admissible(trial, point, NoHistory{}) == plain.admissible(trial, point, NoHistory{}));
      }
}

TEST_CASE("rising mu(I): the slope of mu is that of the formula") {
  double const p = 100, d = law.grains.diameter, step = 1e-5;
  for (double const I : {1e-2, 0.3, 3.0, 30.0}) {
    double const rate = shear_rate_at(I, p);
    double const found =
        (law.friction(p, rate * (1 + step), d) - law.friction(p, rate * (1 - step), d)) / (2 * step * I);
    double const exact =
        (law.mu_d - law.mu_s) * law.I0 / sq(law.I0 + I) + law.mu_inf * I * (2 * law.I0 + I) / sq(law.I0 + I);
    CAPTURE(I, found, exact);
    CHECK(relative(found, exact) < 1e-6);  // lambda of 1e-3 against shear rates of 4 and more, and rounding
  }
}

TEST_CASE("rising mu(I): friction is finite without pressure, and a stress that is not a number bears nothing") {
  double const d = law.grains.diameter;
  CHECK(law.friction(0.0, 0.0, d) == law.mu_s);
  CHECK(std::isfinite(law.friction(0.0, 1.0, d)));
  CHECK(law.friction(-5.0, 1.0, d) == law.friction(0.0, 1.0, d));
  CHECK(std::isfinite(law.friction(0.0f, 1.0f, float(d))));
  CHECK(law.shear_strength(0.0, Point<>{1, 0}) == 0);
  CHECK(law.shear_strength(0.0, Point<>{0, 0}) == 0);
  CHECK(relative(friction_ratio(law.friction(1e-12, 1e3, d)), std::sqrt(3.0) / 2) < 1e-9);
  CHECK(relative(double(friction_ratio(law.friction(1e-12f, 1e3f, float(d)))), std::sqrt(3.0) / 2) < 1e-6);
  RisingMuOfI<> steepest = law;
  steepest.mu_inf = 10;
  CHECK(relative(double(friction_ratio(steepest.friction(0.0f, 1.0f, float(d)))), std::sqrt(3.0) / 2) < 1e-6);

  Mat<3, double> sheared = -100 * Mat<3, double>::Identity();
  sheared(0, 1) = sheared(1, 0) = 90;
  for (double const rate : {nan, infinite}) CHECK(law.admissible(sheared, Point<>{rate, 0}, NoHistory{}).isZero(0));
  for (double const bad : {nan, infinite, -infinite}) {
    Mat<3, double> broken = sheared;
    broken(0, 0) = bad;
    CHECK(law.admissible(broken, Point<>{1, 0}, NoHistory{}).isZero(0));
  }
}

TEST_CASE("rising mu(I): tension ends at the apex, and what opened in a volume memory closes first") {
  Element<VolumeMemory<RisingMuOfI<>>> element{{law}};
  element.set_pressure(100);
  Mat<2, double> apart = simple_shear(20.0);
  apart(0, 0) = apart(1, 1) = 1;
  double const K = law.bulk_modulus();
  element.shear_on(apart, 100 / K, 100);  // 2 K tr(eps) = 200 Pa
  CHECK(element.sigma.isZero(0));
  element.shear_on(-apart, 100 / K, 100);
  CHECK(relative(element.p(), 100) < 1e-3);
  CHECK(element.tau() <= (1 + 1e-14) * law.shear_strength(element.p(), element.point));
}

}  // namespace scree::test::rising_mu_of_i_tests
