// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "hochstetten.hpp"
#include "random_stresses.hpp"
#include "reference/hypoplastic_paths.hpp"

#include <scree/laws/tension_cutoff.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <utility>

namespace scree::test::hypoplastic_tests {
namespace {

using Tensor = StressTensor<double>;
static_assert(StiffnessOfState<Hypoplastic> && EvolvesHistory<Hypoplastic> && !ConstantStiffness<Hypoplastic>);

Sand<> sand(double lateral, double axial, double e) {
  Tensor const sigma = Vec<3, double>(-lateral, -axial, -lateral).asDiagonal();
  return {hochstetten(), sigma, e};
}
/// The largest error along a path, relative to the norm of the stress and to the void ratio.
template <class GradientOf>
double error_of(Sand<> point, GradientOf const& gradient, std::vector<reference::State> const& path,
                double per_unit = 4000) {
  double error = 0, strain = 0;
  for (auto const& row : path) {
    point.follow(gradient, row.strain - strain, std::max(20, int(per_unit * (row.strain - strain))));
    strain = row.strain;
    Tensor expected = Vec<3, double>(row.s11, row.s22, row.s33).asDiagonal();
    expected(0, 1) = expected(1, 0) = row.s12;
    error = std::max({error, (point.sigma - expected).norm() / expected.norm(), std::abs(point.e / row.e - 1)});
  }
  return error;
}

}  // namespace

TEST_CASE("hypoplastic: element tests follow an independent integration of the same equations") {
  CHECK(error_of(sand(1e5, 1e5, 0.85), drained, reference::triaxial_loose) < 1e-8);
  CHECK(error_of(sand(1e5, 1e5, 0.62), drained, reference::triaxial_dense) < 1e-8);
  CHECK(error_of(sand(1e4, 2e4, 0.85), oedometer, reference::oedometer_loose) < 1e-8);
  CHECK(error_of(sand(1e4, 2e4, 0.62), oedometer, reference::oedometer_dense) < 1e-8);
  CHECK(error_of(sand(5e4, 1e5, 0.85), sheared, reference::simple_shear_loose) < 1e-7);
  CHECK(error_of(sand(5e4, 1e5, 0.62), sheared, reference::simple_shear_dense) < 1e-7);
  double const loosest = hochstetten().void_ratios(1e4).loosest;
  CHECK(error_of(sand(1e4, 1e4, loosest), isotropic, reference::isotropic_loosest) < 1e-7);
}

TEST_CASE("hypoplastic: the loosest packing stays the loosest in isotropic compression") {
  auto loosest = sand(1e4, 1e4, hochstetten().void_ratios(1e4).loosest);
  loosest.follow(isotropic, 0.02, 2000);
  CHECK(loosest.p() > 5e5);
  CHECK(std::abs(loosest.e / loosest.law.void_ratios(loosest.p()).loosest - 1) < 1e-8);
}

TEST_CASE("hypoplastic: loose and dense sand end in the same critical state") {
  for (double const e : {0.62, 0.75, 0.85, 0.95}) {
    auto point = sand(1e5, 1e5, e);
    double peak = 0, looser = -1;
    for (int n = 0; n < 300; ++n) {
      point.follow(drained, 0.01, 20);
      peak = std::max(peak, point.friction_angle());
      looser = std::max(looser, point.e - e);
    }
    CAPTURE(e, peak, point.e, point.friction_angle());
    CHECK(std::abs(point.friction_angle() / point.law.critical_angle - 1) < 1e-3);
    CHECK(std::abs(point.e / point.law.void_ratios(point.p()).critical - 1) < 2e-3);
    // Dense sand has a peak and dilates, loose sand has neither.
    if (e < 0.7) CHECK((peak > 1.25 * point.law.critical_angle && looser > 0.15));
    if (e > 0.9) CHECK((peak < 1.001 * point.law.critical_angle && looser < 0));
  }
}

TEST_CASE("hypoplastic: in an oedometer loose sand is softer, and all sand stiffens with pressure") {
  double softer = std::numeric_limits<double>::infinity();
  for (double const e : {0.95, 0.8, 0.65}) {
    auto point = sand(5e3, 1e4, e);
    double before = 0;
    for (double const stress : {1e5, 1e6}) {
      // Compression index between two axial stresses a factor of 10 apart.
      while (point.sigma(1, 1) > -stress / 10) point.follow(oedometer, 1e-5, 1);
      double const e_1 = point.e;
      while (point.sigma(1, 1) > -stress) point.follow(oedometer, 1e-5, 1);
      double const index = (e_1 - point.e) / std::log(10);
      CAPTURE(e, stress, index);
      CHECK(index > before);
      before = index;
    }
    CHECK(before < 0.8 * softer);
    softer = before;
    auto const [e_d, e_c, e_i] = point.law.void_ratios(point.p());
    CHECK((point.e > e_d && point.e < e_i));
    double const at_rest = point.sigma(0, 0) / point.sigma(1, 1);
    CHECK((at_rest > 0.35 && at_rest < 0.55));  // Jaky: 1 - sin(phi_c) = 0.46
  }
}

TEST_CASE("hypoplastic: void ratios stay between the densest and the loosest while grains are in contact") {
  for (double const e : {0.56, 0.7, 0.9})
    for (double const lateral : {-1.0, -0.5, 0.0, 0.3}) {
      auto point = sand(1e4, 1e4, e);
      auto const gradient = [=](auto const&) { return compression(lateral); };
      for (int n = 0; n < 200 && point.p() < 1e7; ++n) {
        point.follow(gradient, 1e-4, 10);
        auto const [e_d, e_c, e_i] = point.law.void_ratios(point.p());
        CAPTURE(e, lateral, n, point.p(), point.e);
        REQUIRE(point.e > e_d);
        REQUIRE(point.e < e_i);
      }
    }
}

TEST_CASE("hypoplastic: the law does not depend on the axes") {
  Mat<3, double> const turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  auto point = sand(6e4, 1e5, 0.7), turned = point;
  point.sigma(0, 1) = point.sigma(1, 0) = 2e4;
  turned.sigma = turn * point.sigma * turn.transpose();
  Mat<3, double> L;
  L << 0.1, 1, -0.4, 0.3, -0.5, 0.2, 0.7, -0.1, 0.2;
  Tensor const expected = turn * point.stress_rate(L) * turn.transpose(),
               rate = turned.stress_rate(turn * L * turn.transpose());
  CHECK((rate - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE("hypoplastic: no wave is faster than the speed of sound") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  double closest = 0;
  for (int n = 0; n < 20000; ++n) {
    Vec<3, double> const direction = Vec<3, double>(normal(random), normal(random), normal(random)).normalized(),
                         motion = Vec<3, double>(normal(random), normal(random), normal(random)).normalized();
    double const ratio = 0.25 + 0.75 * (n % 7) / 6.0;
    auto point = sand(1e5, 1e5 / ratio, 0.56 + 0.4 * (n % 11) / 10);
    if (n % 2) point = sand(1e5, 1e5 * ratio, point.e);
    Tensor const L = motion * direction.transpose(),
                 rate = point.stress_rate(L) - rate_of_rotation<double>(point.sigma, L);
    double const modulus = (rate * direction).norm(), speed = point.law.sound_speed(point.sigma, OfVoids{point.e});
    REQUIRE(modulus <= (1 + 1e-12) * point.law.density() * sq(speed));
    closest = std::max(closest, modulus / (point.law.density() * sq(speed)));
  }
  CHECK(closest > 0.9);  // the bound is not much too high
}

TEST_CASE("hypoplastic: the bulk modulus is the mean of isotropic loading and unloading") {
  auto const point = sand(1e5, 1e5, 0.7);
  double const loading = pressure_of(point.stress_rate(compression(-1))) / 3,
               unloading = -pressure_of(point.stress_rate(-compression(-1))) / 3;
  CHECK(loading < 0.8 * unloading);
  CHECK(relative(point.law.bulk_modulus(point.sigma, OfVoids{0.7}), (loading + unloading) / 2) < 1e-12);
}

TEST_CASE("hypoplastic: below the least pressure the stiffness is that at it, so that stress returns from zero") {
  auto const law = hochstetten();
  auto none = sand(0, 0, 0.7);
  CHECK(law.sound_speed(none.sigma, OfVoids{0.7}) ==
        law.sound_speed(Tensor(-law.least_pressure * Tensor::Identity()), OfVoids{0.7}));
  CHECK(law.bulk_modulus(Tensor(Tensor::Identity() * 1e4), OfVoids{0.7}) > 0);
  none.follow(isotropic, 1e-2, 100);
  CHECK(none.p() > law.least_pressure);
}

TEST_CASE("hypoplastic: a stress that grains in contact cannot have is returned") {
  auto const law = hochstetten();
  auto const admitted = [&](Tensor const& trial, double e) { return law.admissible(trial, OfVoids{e}, NoHistory{}); };
  Tensor const pressed = sand(5e4, 1e5, 0).sigma;
  CHECK((admitted(pressed, 0.8) - pressed).norm() < 1e-12 * pressed.norm());
  CHECK(admitted(Tensor(-pressed), 0.8).isZero(0));
  CHECK(admitted(pressed, 1.06).isZero(0));  // looser than e_i0: no contacts
  double const e = 0.95, p = pressure_of(admitted(pressed, e));
  CHECK(p < 0.9 * pressure_of(pressed));
  CHECK(relative(law.void_ratios(p).loosest, e) < 1e-12);
  Tensor const bad = Tensor::Constant(std::numeric_limits<double>::quiet_NaN());
  CHECK(admitted(bad, 0.8).isZero(0));

  RandomStresses<3, double> random;
  for (int n = 0; n < 3000; ++n) {
    Tensor const trial = random.next(), once = admitted(trial, 0.7);
    double const largest = Eigen::SelfAdjointEigenSolver<Tensor>(once).eigenvalues()[2];
    REQUIRE(largest <= -0.0099 * pressure_of(once));
    REQUIRE((admitted(once, 0.7) - once).norm() <= 1e-12 * once.norm());
    REQUIRE(std::isfinite(law.sound_speed(once, OfVoids{0.7})));
    REQUIRE(law.stress_rate(once, trial, OfVoids{0.7}).allFinite());
  }
}

TEST_CASE("hypoplastic: parameters out of range are refused by their name") {
  auto const complaint = [](auto const& change) -> std::string {
    auto law = hochstetten();
    change(law);
    try {
      law.check();
    } catch (std::invalid_argument const& error) {
      return error.what();
    }
    return "";
  };
  CHECK(complaint([](auto&) {}) == "");
  CHECK(complaint([](auto& law) { law.critical_angle = 33; }).starts_with("scree: critical_angle (rad) must be above"));
  CHECK(complaint([](auto& law) { law.granulate_hardness = 0; }).starts_with("scree: granulate_hardness (Pa)"));
  CHECK(complaint([](auto& law) { law.exponent = 1; }).starts_with("scree: exponent (-) must be"));
  CHECK(complaint([](auto& law) { law.e_c0 = 0.5; }) == "scree: e_c0 (-) must be above e_d0, not 0.5");
  CHECK(complaint([](auto& law) { law.e_i0 = 0.9; }).starts_with("scree: e_i0 (-) must be above e_c0"));
  CHECK(complaint([](auto& law) { law.alpha = 10; }).starts_with("scree: alpha (-) must be so small that"));
  CHECK(complaint([](auto& law) { law.rest_density = 0; }).starts_with("scree: rest_density"));
  CHECK(complaint([](auto& law) { law.least_pressure = 0; }).starts_with("scree: least_pressure (Pa)"));
}

}  // namespace scree::test::hypoplastic_tests
