// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"

#include <scree/laws/mu_of_i.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::mu_of_i_tests {
namespace {

using Law = MuOfI<BidisperseGrains>;
Law const law{.elastic = soft(), .grains = {.d_small = 2.5e-4, .d_large = 5e-4}};
double const G = law.elastic.shear_modulus(), nan = std::numeric_limits<double>::quiet_NaN();

struct Flow {
  double p, gamma_dot, C;
};

// Simple shear at constant volume over many times the yield strain.
template <int Dim>
Element<Law, Dim> sheared(Flow const& flow) {
  Element<Law, Dim> element{law};
  element.set_pressure(flow.p);
  element.point.C = flow.C;
  double const yields_at = 0.54 * flow.p / G;
  element.shear_on(simple_shear<Dim>(flow.gamma_dot), 40 * yields_at / flow.gamma_dot, 8000);
  return element;
}
// k_mu(mu(I)) without regularisation.
double k_of(double I) {
  double const mu = law.mu_s + (law.mu_d - law.mu_s) / (law.I0 / I + 1);
  return 3 * mu / std::sqrt(9 + 12 * mu * mu);
}

}  // namespace

TEST_CASE("mu(I): simple shear finds k_mu(mu(I)) for I from 1e-4 to 1") {
  for (double const p : {20.0, 200.0})
    for (double const C : {0.0, 1.0})
      for (double const I : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
        double const d = C == 0 ? 5e-4 : 2.5e-4, gamma_dot = I * std::sqrt(p / 2500) / d;
        auto const element = sheared<2>({p, gamma_dot, C});
        double const tau = element.sigma[3], k = k_of(I), S = element.tau();
        CAPTURE(p, C, I, tau / p, k, relative(tau / p, k));
        CHECK(relative(tau / p, k) < (p == 20 ? 5e-8 : 5e-6));  // (k p/G)^2/2 and the regularisation
        CHECK(relative(element.p(), p) < 1e-13);
        // Exact for the Jaumann rate in steady shear: tau = S sqrt(1 - (S/G)^2), sigma_xx - sigma_zz = 2 S^2/G.
        CHECK(relative(S, law.shear_strength(p, element.point)) < 1e-13);
        CHECK(relative(tau, S * std::sqrt(1 - sq(S / G))) < 1e-13);
        CHECK(relative(element.sigma[0] - element.sigma[1], 2 * S * S / G) < 1e-8);
        CHECK(std::abs(element.sigma[2] + p) < 1e-10 * p);
      }
}

TEST_CASE("mu(I): ratios of shear stress to pressure of the prototype") {
  struct Row {
    Flow flow;
    double ratio;
  };
  for (Row const& row : {Row{{20, 1, 0}, 0.35401}, Row{{20, 10, 0}, 0.38663}, Row{{20, 100, 0}, 0.48312},
                         Row{{20, 1000, 0}, 0.52880}, Row{{200, 100, 0}, 0.43194}, Row{{200, 100, 1}, 0.40222}}) {
    auto const in_plane = sheared<2>(row.flow);
    auto const in_space = sheared<3>(row.flow);
    CAPTURE(row.flow.p, row.flow.gamma_dot, row.flow.C, in_plane.sigma[3] / row.flow.p);
    CHECK(relative(in_plane.sigma[3] / row.flow.p, row.ratio) < 1.5e-5);
    CHECK(relative(in_space.sigma[4], in_plane.sigma[3]) < 1e-12);
  }
  CHECK(std::abs(friction_ratio(0.382) - 0.3495) < 5e-5);
  CHECK(std::abs(friction_ratio(0.643) - 0.5163) < 5e-5);
  CHECK(std::abs(friction_ratio(0.682) - 0.5358) < 1e-4);
}

TEST_CASE("mu(I): it yields at the strain k p/G, and not before") {
  double const p = 200, k = friction_ratio(law.friction(p, 1e-3, 5e-4)), yields_at = k * p / G;
  Element<Law> element{law};
  element.set_pressure(p);
  element.shear_on(simple_shear(1e-3), 0.99 * yields_at / 1e-3, 990);
  CHECK(relative(element.sigma[3], 0.99 * k * p) < 1e-5);
  element.shear_on(simple_shear(1e-3), 0.02 * yields_at / 1e-3, 20);
  CHECK(relative(element.tau(), k * p) < 1e-13);
}

TEST_CASE("mu(I): tension ends at the apex, and the material bears again when it is compressed") {
  Element<Law> element{law};
  element.set_pressure(100);
  double const K = law.bulk_modulus();
  Mat<2, double> apart = simple_shear(20.0);
  apart(0, 0) = apart(1, 1) = 1;
  element.shear_on(apart, 49.0 / K, 49);  // 2 K tr(eps)/2 = 98 Pa
  CHECK(relative(element.p(), 2) < 1e-9);
  CHECK(element.tau() <= (1 + 1e-14) * law.shear_strength(element.p(), element.point));
  element.shear_on(apart, 2.0 / K, 2);
  CHECK(element.sigma.isZero(0));
  element.shear_on(apart, 1, 100);
  CHECK(element.sigma.isZero(0));
  element.shear_on(-apart, 10.0 / K, 10);
  CHECK(relative(element.p(), 20) < 1e-9);
  CHECK(relative(element.tau(), law.shear_strength(element.p(), element.point)) < 1e-13);
}

TEST_CASE("mu(I): a stress that is not a number bears nothing and does not end the check of yielding") {
  for (int entry = 0; entry < 4; ++entry)
    for (double const bad : {nan, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
      Element<Law> element{law};
      element.set_pressure(100);
      element.sigma[entry] = bad;
      element.shear_on(simple_shear(10.0), 1e-6, 1);
      CAPTURE(entry, bad);
      CHECK(element.sigma.isZero(0));
      element.shear_on(simple_shear(10.0) - Mat<2, double>::Identity(), 0.01, 100);
      CHECK(element.p() > 100);
      CHECK(relative(element.tau(), law.shear_strength(element.p(), element.point)) < 1e-13);
    }
  Mat<3, double> sheared = -100 * Mat<3, double>::Identity();
  sheared(0, 1) = sheared(1, 0) = 80;
  for (Point<> const& point : {Point<>{nan, 0}, Point<>{1, nan}})
    CHECK(law.admissible(sheared, point, NoHistory{}).isZero(0));
  CHECK_FALSE(law.admissible(sheared, Point<>{1, 0}, NoHistory{}).isZero(0));
  CHECK(law.friction(-5.0, 1.0, 5e-4) == law.friction(0.0, 1.0, 5e-4));
}

TEST_CASE("grains: the mean diameter follows the concentration of small ones") {
  CHECK(UniformGrains{1e-3}.mean_diameter(Point<>{}) == 1e-3);
  CHECK(law.grains.mean_diameter(Point<>{0, 0}) == 5e-4);
  CHECK(law.grains.mean_diameter(Point<>{0, 1}) == 2.5e-4);
  CHECK(std::abs(law.grains.mean_diameter(Point<>{0, 0.3}) - 4.25e-4) < 1e-18);
}

}  // namespace scree::test::mu_of_i_tests
