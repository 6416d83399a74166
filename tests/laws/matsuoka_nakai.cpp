// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"
#include "in_section.hpp"
#include "random_stresses.hpp"

#include <scree/laws/matsuoka_nakai.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/tension_cutoff.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace scree::test::matsuoka_nakai_tests {
namespace {

using Sand = InSection<MuOfI<>>;

/// Sand whose friction does not depend on the shear rate.
Sand sand(double mu) { return {{.elastic = soft(), .grains = {5e-4}, .mu_s = mu, .mu_d = mu}}; }
/// Principal stresses, compression positive, in descending order.
std::array<double, 3> principal(Mat<3, double> const& sigma) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(-sigma, Eigen::EigenvaluesOnly);
  auto const& s = solver.eigenvalues();
  return {s[2], s[1], s[0]};
}
/// I1 I2/I3.
double constant_of(std::array<double, 3> const& s) {
  return (s[0] + s[1] + s[2]) * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]) / (s[0] * s[1] * s[2]);
}
/// I1 I2/I3 of a stress with the principal stresses p (1 + k), p, p (1 - k).
double constant_in_plane_shear(double k) { return (9 - 3 * k * k) / (1 - k * k); }
Mat<3, double> stress_of(double s1, double s2, double s3) {
  Mat<3, double> sigma = Mat<3, double>::Zero();
  sigma(0, 0) = -s1, sigma(1, 1) = -s2, sigma(2, 2) = -s3;
  return sigma;
}
double sine_of_friction_angle(Mat<3, double> const& sigma) {
  auto const s = principal(sigma);
  return (s[0] - s[2]) / (s[0] + s[2]);
}

}  // namespace

TEST_CASE("Matsuoka-Nakai: stresses at yield have one ratio I1 I2/I3, for any stress and friction") {
  RandomStresses<3, double> random;
  int yielding = 0;
  for (int n = 0; n < 20'000; ++n) {
    double const mu = 0.05 + 1.5 * (n % 31) / 30.0, k = friction_ratio(mu);
    Mat<3, double> const trial = random.next(), borne = sand(mu).admissible(trial, Point<>{}, NoHistory{});
    double const p = pressure_of(trial);
    if (p <= 0) {
      CHECK(borne.isZero(0));
      continue;
    }
    CAPTURE(mu, p);
    CHECK(std::abs(pressure_of(borne) - p) < 1e-9 * trial.norm());
    auto const s = principal(borne);
    REQUIRE(s[2] > 0);
    double const excess = constant_of(s) / constant_in_plane_shear(k) - 1;
    // The ratio is 9 without shear, whatever the friction; a trial beyond yield by 1e5 leaves the error of its
    // deviator.
    if (borne == trial) {
      CHECK(excess < 1e-9);
    } else {
      ++yielding;
      CHECK(std::abs(excess) < 1e-9);
      Mat<3, double> const before = deviator_of(trial), after = deviator_of(borne);
      CHECK((before / before.norm() - after / after.norm()).norm() < 1e-9);
      CHECK(borne.norm() < trial.norm());
    }
  }
  CHECK(yielding > 8000);
}

TEST_CASE("Matsuoka-Nakai: plane shear is that of the cone; compression and extension have one angle of friction") {
  for (double const mu : {0.1, 0.25, 0.382, 0.6, 1.0, 3.0}) {
    double const k = friction_ratio(mu), p = 700;
    Sand const law = sand(mu);
    auto const at_yield = [&](double a, double b, double c) {
      return law.admissible(Mat<3, double>(10 * p * deviator_of(stress_of(a, b, c)) + stress_of(p, p, p)), Point<>{},
                            NoHistory{});
    };
    Mat<3, double> const shear = at_yield(1, 0, -1), compression = at_yield(2, -1, -1), extension = at_yield(1, 1, -2);
    CAPTURE(mu, sine_of_friction_angle(shear), sine_of_friction_angle(compression));
    CHECK(relative(sine_of_friction_angle(shear), k) < 1e-12);
    CHECK(relative(sine_of_friction_angle(compression), sine_of_friction_angle(extension)) < 1e-12);
    CHECK(sine_of_friction_angle(compression) < k);
    // 8 tan(phi)^2 = I1 I2/I3 - 9 in both, whatever the third stress
    double const sine = sine_of_friction_angle(compression);
    CHECK(relative(8 * sine * sine / (1 - sine * sine), constant_in_plane_shear(k) - 9) < 1e-11);
    CHECK(equivalent_shear_stress(deviator_of(compression)) > k * p);
    CHECK(relative(equivalent_shear_stress(deviator_of(shear)), law.shear_strength(p, Point<>{})) < 1e-12);
    CHECK(equivalent_shear_stress(deviator_of(extension)) < k * p);
  }
}

TEST_CASE("Matsuoka-Nakai: compression of one axis at constant pressure on the sides ends at the angle of friction") {
  Sand const law = sand(0.6);
  for (double const way : {-1.0, 1.0}) {  // compressed; extended
    Mat<3, double> sigma = stress_of(500, 500, 500);
    double const dt = 1e-5;
    for (int n = 0; n < 20'000; ++n) {  // the sides move so that their trial stress stays the same
      Mat<3, double> L = Mat<3, double>::Zero();
      L(2, 2) = way;
      double const K = law.bulk_modulus(), G = law.elastic.shear_modulus();
      L(0, 0) = L(1, 1) = -(K - 2 * G / 3) / (2 * (K + G / 3)) * way - (sigma(0, 0) + 500) / (2 * (K + G / 3) * dt);
      sigma = law.admissible(Mat<3, double>(sigma + dt * law.stress_rate(sigma, L, Point<>{})), Point<>{}, NoHistory{});
    }
    double const sine = sine_of_friction_angle(sigma), c = constant_in_plane_shear(friction_ratio(0.6)) - 9;
    CAPTURE(way, sigma(0, 0), sigma(2, 2), std::asin(sine) * 57.29578);
    CHECK(relative(sigma(0, 0), -500) < 0.02);  // what the last step has returned
    CHECK(relative(sine, std::sqrt(c / (8 + c))) < 1e-10);
  }
}

TEST_CASE("Matsuoka-Nakai: simple shear in plane strain and in space ends at k, with mu(I) too") {
  for (double const gamma_dot : {1e-2, 10.0, 1000.0}) {
    double const p = 200;
    MuOfI<> const cone{.elastic = soft(), .grains = {5e-4}};
    Element<Sand> round{Sand{cone}};
    Element<Sand, 3> in_space{Sand{cone}};
    Element<MuOfI<>> plain{cone};
    double const strain = 40 * p / cone.elastic.shear_modulus();
    round.set_pressure(p), in_space.set_pressure(p), plain.set_pressure(p);
    round.shear_on(simple_shear(gamma_dot), strain / gamma_dot, 8000);
    in_space.shear_on(simple_shear<3>(gamma_dot), strain / gamma_dot, 8000);
    plain.shear_on(simple_shear(gamma_dot), strain / gamma_dot, 8000);
    CAPTURE(gamma_dot, round.sigma[3] / p);
    CHECK(relative(round.sigma[3], plain.sigma[3]) < 1e-9);
    CHECK(relative(in_space.sigma[4], plain.sigma[3]) < 1e-9);
    CHECK(relative(round.p(), p) < 1e-12);
  }
}

TEMPLATE_TEST_CASE("Matsuoka-Nakai: a second return changes nothing, and what is no number bears nothing", "", float,
                   double) {
  using Real = TestType;
  Real const epsilon = std::numeric_limits<Real>::epsilon(), nan = std::numeric_limits<Real>::quiet_NaN(),
             infinite = std::numeric_limits<Real>::infinity();
  RandomStresses<2, Real> random;
  for (int n = 0; n < 5000; ++n) {
    StressTensor<Real> const trial = random.next();
    for (double const mu : {0.0, 0.382, 1e9}) {
      Sand const law = sand(mu);
      Point<Real> const point;
      StressTensor<Real> const once = law.admissible(trial, point, NoHistory{});
      REQUIRE(once.allFinite());
      StressTensor<Real> const twice = law.admissible(once, point, NoHistory{});
      REQUIRE((once - twice).norm() <= 200 * epsilon * once.norm());
    }
    for (Real const bad : {nan, infinite, -infinite}) {
      StressTensor<Real> wrong = trial;
      wrong(n % 3, n % 2) = bad;
      CHECK(sand(0.382).admissible(wrong, Point<Real>{}, NoHistory{}).isZero(0));
    }
  }
  CHECK(sand(0.382).admissible(StressTensor<Real>(StressTensor<Real>::Zero()), Point<Real>{}, NoHistory{}).isZero(0));
}

/// A friction that a user makes as large as a ratio of 1.2.
struct Steep : MuOfI<> {
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&&) const {
    return return_to_yield(trial, Real(1.2), point);
  }
};

TEST_CASE("Matsuoka-Nakai: no stress is tension, however large the friction") {
  InSection<Steep> const law{{{.elastic = soft(), .grains = {5e-4}}}};
  for (auto const& trial : {stress_of(900, -300, -300), stress_of(500, 500, -700), stress_of(600, 100, -400)}) {
    auto const s = principal(law.admissible(trial, Point<>{}, NoHistory{}));
    CAPTURE(s[0], s[1], s[2]);
    CHECK(s[2] > -1e-5 * s[0]);
  }
}

TEST_CASE("Matsuoka-Nakai: the bound from below is one, so that what it leaves out changes nothing") {
  double least = 2;
  for (int n = 0; n <= 60; ++n) {
    double const k = 0.02 * n;
    for (int m = -50; m <= 50; ++m) {
      double const ratio = MatsuokaNakai{}.ratio(k, m / 50.0), bound = MatsuokaNakai{}.least_ratio(k);
      REQUIRE(ratio >= bound * (1 - 1e-12));
      if (k > 0) least = std::min(least, ratio / bound);
      REQUIRE(float(ratio) >= MatsuokaNakai{}.least_ratio(float(k)) * (1 - 1e-6F));
    }
  }
  CHECK(least < 1.001);  // it is reached at k = 1 in extension
}

TEST_CASE("Matsuoka-Nakai: it serves other laws of friction, below a cut-off and with a memory") {
  InSection<RisingMuOfI<>> const rising{{{.elastic = soft(), .grains = {5e-4}}, 0.05}};
  InSection<VolumeMemory<TensionCutoff<MuOfI<>>>> const remembering{{{sand(0.6), 0}}};
  Mat<3, double> const trial = stress_of(9000, 100, 100);
  Point<> point{50};
  double const p = pressure_of(trial), k = rising.shear_strength(p, point) / p;
  CHECK(relative(constant_of(principal(rising.admissible(trial, point, NoHistory{}))), constant_in_plane_shear(k)) <
        1e-10);
  CHECK(relative(constant_of(principal(remembering.admissible(trial, Point<>{}, point))),
                 constant_in_plane_shear(friction_ratio(0.6))) < 1e-10);
  CHECK(remembering.admissible(Mat<3, double>(-trial), Point<>{}, point).isZero(0));
}

}  // namespace scree::test::matsuoka_nakai_tests
