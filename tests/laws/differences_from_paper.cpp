// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"

#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/mu_of_i.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// Constitutive equations of Zhu, Peng & Wu (2024) with printing errors: the printed form fails, the form of the library
// passes.
namespace scree::test::differences_from_paper_tests {
namespace {

double const G = soft().shear_modulus(), K = soft().bulk_modulus();

Mat<3, double> compressed_and_sheared(double p, double tau) {
  Mat<3, double> sigma = -p * Mat<3, double>::Identity();
  sigma(0, 1) = sigma(1, 0) = tau;
  return sigma;
}

// (2.16) and (2.17) as an ordinary differential equation at yield, in small steps. `volumetric` is the factor of K
// eps_v in (2.16), eps_v = tr(eps)/3: printed 1. Spin is excluded, L is symmetric. Returns sqrt(J2) - k p over p.
double yield_after_flow(double volumetric, double k) {
  Mat<3, double> eps = Mat<3, double>::Zero(), sigma = compressed_and_sheared(100, k * 100);
  eps.diagonal() << -0.4, -0.1, 0;
  eps(0, 1) = eps(1, 0) = 1;
  double const eps_v = eps.trace() / 3, dt = 1e-8;
  for (int n = 0; n < 100'000; ++n) {
    Mat<3, double> const s = deviator_of(sigma), e = eps - eps_v * Mat<3, double>::Identity();
    double const tau = equivalent_shear_stress(s), doubled = (s * eps).trace();
    double const multiplier = (3 * k * K * eps_v + G / tau * doubled) / G;  // (2.17)
    sigma += dt * (2 * G * e + volumetric * K * eps_v * Mat<3, double>::Identity() - multiplier * G / tau * s);
  }
  double const p = pressure_of(sigma);
  return (equivalent_shear_stress(deviator_of(sigma)) - k * p) / p;
}

}  // namespace

TEST_CASE("(2.11): p = tr(sigma)/3 admits no compressed stress") {
  double const k = friction_ratio(0.382);
  auto const sigma = compressed_and_sheared(100, 10);
  double const tau = equivalent_shear_stress(deviator_of(sigma)), printed = sigma.trace() / 3;
  CHECK(tau - k * printed > 0);                                // beyond yield although hardly sheared,
  CHECK(0 - k * -100 > 0);                                     // and so without any shear;
  CHECK(0 - k * (+100) < 0);                                   // while tension is admitted.
  CHECK(tau - k * pressure_of(sigma) < 0);                     // with p = -tr(sigma)/3 it is within,
  CHECK(return_to_cone(sigma, k) == sigma);                    // and stays unchanged,
  CHECK(return_to_cone(Mat<3, double>(-sigma), k).isZero(0));  // and tension is not admitted.
}

TEST_CASE("(2.16): the bulk modulus must meet tr(eps), three times eps_v") {
  // Young's modulus follows from free extension: eps = (1, -nu, -nu) must leave the sides without stress.
  Elastic const law = soft();
  Mat<3, double> eps = Mat<3, double>::Zero();
  eps.diagonal() << 1, -law.poisson, -law.poisson;
  double const eps_v = eps.trace() / 3;
  Mat<3, double> const zero_stress = Mat<3, double>::Zero(), rate = law.stress_rate(zero_stress, eps, Point<>{});
  CHECK(relative(rate(0, 0), law.young) < 1e-14);
  CHECK(std::abs(rate(1, 1)) < 1e-10);
  Mat<3, double> const printed =
      2 * G * (eps - eps_v * Mat<3, double>::Identity()) + K * eps_v * Mat<3, double>::Identity();
  CHECK(std::abs(printed(0, 0) / law.young - 1) > 0.2);
  CHECK(std::abs(printed(1, 1)) > 0.2 * law.young);
}

TEST_CASE("(2.16): with (2.17) as printed, only 3 K eps_v keeps the stress on the yield surface") {
  double const k = friction_ratio(0.382);
  CAPTURE(yield_after_flow(3, k), yield_after_flow(1, k));
  CHECK(std::abs(yield_after_flow(3, k)) < 1e-6);
  CHECK(yield_after_flow(1, k) > 0.01);
}

TEST_CASE("(2.12): the friction that simple shear meets is k_mu, not mu") {
  double const mu = 0.382, p = 20;
  Element<MuOfI<>> element{{.elastic = soft(), .grains = {5e-4}, .mu_s = mu, .mu_d = mu}};
  element.set_pressure(p);
  element.shear_on(simple_shear(1), 40 * p / G, 8000);
  double const ratio = element.sigma[3] / p;
  CHECK(relative(ratio, friction_ratio(mu)) < 1e-6);
  CHECK(relative(ratio, mu) > 0.08);
  // k_mu belongs to an associated rule: with it, the plane finds mu = tan(phi); the flow of (2.15) is isochoric.
  auto const associated = plane_strain_cone({std::atan(mu), 0, std::atan(mu)});
  auto const isochoric = plane_strain_cone({std::atan(mu), 0, 0});
  CHECK(relative(associated.friction, friction_ratio(mu)) < 1e-14);
  CHECK(relative(isochoric.friction, friction_ratio(mu)) > 0.02);
}

}  // namespace scree::test::differences_from_paper_tests
