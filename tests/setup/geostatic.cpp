// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/geostatic.hpp>

#include <scree/laws/matsuoka_nakai.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::geostatic_tests {
namespace {
Geostatic const bed{.surface_height = 0.4, .density = 1500, .gravity = 9.81, .K0 = 0.6};

double pressure(Mat<3, double> const& stress) { return -stress.trace() / 3; }
double root_J2(Mat<3, double> const& stress) {
  Mat<3, double> const s = stress + pressure(stress) * Mat<3, double>::Identity();
  return std::sqrt((s * s).trace() / 2);
}
double ratio_at(double K0) {
  auto bed_at = bed;
  bed_at.K0 = K0;
  Mat<3, double> const stress = bed_at(Vec<3, double>(0, 0, 0.1));
  return root_J2(stress) / pressure(stress);
}
}  // namespace

TEST_CASE("geostatic: stress of a bed at rest, with up in its place") {
  double const q = 1500 * 9.81 * 0.3;
  Mat<3, double> const in_space = bed(Vec<3, double>(7, 8, 0.1)), in_plane = bed(Vec<2, double>(7, 0.1));
  CHECK(in_space.isApprox(Mat<3, double>(Vec<3, double>(-0.6 * q, -0.6 * q, -q).asDiagonal())));
  CHECK(in_plane.isApprox(Mat<3, double>(Vec<3, double>(-0.6 * q, -q, -0.6 * q).asDiagonal())));
  CHECK(bed(Vec<2, double>(0, 0.5)).norm() == 0);
  CHECK(bed(Vec<3, double>(0, 0, 0.4)).norm() == 0);
  CHECK(bed(Vec<2, float>(0, 0.1F)).isApprox(in_plane, 1e-6));
}

TEST_CASE("geostatic: it bears the weight of the bed") {
  double const z = 0.17, step = 1e-3;
  Mat<3, double> const above = bed(Vec<2, double>(0, z + step)), below = bed(Vec<2, double>(0, z - step));
  CHECK(std::abs((above - below)(1, 1) / (2 * step) - 1500 * 9.81) < 1e-6);  // div sigma = density g
}

TEST_CASE("geostatic: the ratio of shear stress to pressure is that of the tensor") {
  for (double const K0 : {0.0, 0.3, 0.5687, 1.0, 1.7, 4.0})
    CHECK(std::abs(geostatic_stress_ratio(K0) - ratio_at(K0)) < 1e-12);
}

TEST_CASE("geostatic: the limits of K0 lie on the yield surface") {
  CHECK(std::abs(least_admissible_K0(0.3495) - 0.569) < 5e-4);
  for (double const friction : {0.0, 0.1, 0.3495, 0.8}) {
    CAPTURE(friction);
    CHECK(std::abs(ratio_at(least_admissible_K0(friction)) - friction) < 1e-12);
    CHECK(std::abs(ratio_at(greatest_admissible_K0(friction, CircularCone{})) - friction) < 1e-12);
    CHECK(least_admissible_K0(friction) <= 1);
    CHECK(greatest_admissible_K0(friction) >= 1);
  }
  CHECK(least_admissible_K0(2, CircularCone{}) == 0);
  CHECK(least_admissible_K0(2) < 1e-15);
  CHECK(std::isinf(greatest_admissible_K0(1, CircularCone{})));
  CHECK_THROWS_AS(least_admissible_K0(-0.1), std::invalid_argument);
}

TEST_CASE("geostatic: on the section of Matsuoka and Nakai the limits of K0 have one angle of friction") {
  for (double const friction : {0.1, 0.3495, 0.8}) {
    // 8 tan(phi)^2 = I1 I2/I3 - 9 with that of plane shear; Rankine's limits are (1 - sin)/(1 + sin) and its inverse.
    double const excess = (9 - 3 * friction * friction) / (1 - friction * friction) - 9;
    double const sine = std::sqrt(excess / (8 + excess));
    double const least = least_admissible_K0(friction, MatsuokaNakai{});
    CHECK(std::abs(least / ((1 - sine) / (1 + sine)) - 1) < 1e-12);
    CHECK(std::abs(greatest_admissible_K0(friction, MatsuokaNakai{}) * least - 1) < 1e-12);
    CHECK(least < least_admissible_K0(friction));
    CHECK(least_admissible_K0(friction) == least_admissible_K0(friction, CircularCone{}));
    CHECK(greatest_admissible_K0(friction) == greatest_admissible_K0(friction, MatsuokaNakai{}));
    auto other = bed;
    other.K0 = (least + least_admissible_K0(friction)) / 2;
    CHECK_NOTHROW(admissible(other, friction, MatsuokaNakai{}));
    CHECK_THROWS_AS(admissible(other, friction), std::invalid_argument);
  }
}

TEST_CASE("geostatic: without a section a bed is refused that a cone squeezes upwards in the plane, or sand in space") {
  using Catch::Matchers::ContainsSubstring;
  auto squeezed = bed;
  squeezed.K0 = 1.95;  // on a cone up to 2.01, on MatsuokaNakai up to 1.89
  CHECK_NOTHROW(admissible(squeezed, 0.3495, CircularCone{}));
  CHECK_THROWS_WITH(admissible(squeezed, 0.3495, MatsuokaNakai{}), !ContainsSubstring("on one of them"));
  CHECK_THROWS_WITH(admissible(squeezed, 0.3495), ContainsSubstring("on one of them: admissible(bed"));
}

TEST_CASE("geostatic: a K0 outside of the yield surface is refused") {
  using Catch::Matchers::ContainsSubstring;
  auto other = bed;
  other.K0 = 0.56;
  CHECK_THROWS_WITH(admissible(other, 0.3495), ContainsSubstring("0.56") && ContainsSubstring("0.568"));
  CHECK_THROWS_AS(admissible(other, 0.3495), std::invalid_argument);
  other.K0 = 2.1;
  CHECK_THROWS_AS(admissible(other, 0.3495), std::invalid_argument);
  other.K0 = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(admissible(other, 0.3495), std::invalid_argument);
  other.K0 = least_admissible_K0(0.3495);
  CHECK(admissible(other, 0.3495).K0 == other.K0);
  CHECK(admissible(bed, 0.3495).surface_height == 0.4);
  other.gravity = -9.81;
  CHECK_THROWS_WITH(admissible(other, 0.3495), ContainsSubstring("gravity"));
}

}  // namespace scree::test::geostatic_tests
