// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "hochstetten.hpp"
#include "in_section.hpp"

#include <scree/laws/elastic.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/laws/mu_of_i.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/volume_memory.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <type_traits>

namespace scree::test::mixture_density_tests {
namespace {

using Mixture = Vec<2, double>;
Mixture const densities(3600, 900);

/// A point of a mixture in flow.
struct Point {
  double gamma_dot = 0;
  Mixture C;
  double gap = 0;
  double const& operator[](ShearRate) const { return gamma_dot; }
  Mixture const& operator[](Concentrations<2>) const { return C; }
  double& operator[](Opening) { return gap; }
  double const& operator[](Opening) const { return gap; }
};

template <class Law>
Law with_grains() {
  Law law;
  law.elastic = {1e6, 0.3, 1500};
  law.grains = {Mixture(1e-3, 2e-3)};
  return law;
}
StressTensor<double> sheared(double p, double tau) {
  StressTensor<double> sigma = -p * identity_matrix<StressTensor<double>>();
  sigma(0, 1) = sigma(1, 0) = tau;
  return sigma;
}

static_assert(ConstitutiveLaw<MixtureDensity<Elastic, 2>>);
static_assert(ConstitutiveLaw<MixtureDensity<Hypoplastic, 2>>);
static_assert(ConstitutiveLaw<VolumeMemory<MixtureDensity<RisingMuOfI<>, 2>>>);
static_assert(Cohesionless<MixtureDensity<MuOfI<>, 2>> && !Cohesionless<MixtureDensity<Elastic, 2>>);
static_assert(DensityOfMixture<VolumeMemory<MixtureDensity<MuOfI<>, 2>>> && !DensityOfMixture<MuOfI<>>);

}  // namespace

TEST_CASE("the density is that of the mixture, and waves are the slower the heavier it is") {
  Elastic const block{1e6, 0.3, 1500};
  MixtureDensity<Elastic, 2> const law{block, densities};
  double const modulus = block.bulk_modulus() + 4 * block.shear_modulus() / 3;
  for (double const C : {0.0, 0.3, 1.0}) {
    Point const point{.C = {C, 1 - C}};
    double const rho = C * 3600 + (1 - C) * 900, c = law.sound_speed(sheared(100, 0), point);
    CHECK(std::abs(law.density(point) / rho - 1) < 1e-15);
    CHECK(std::abs(c / std::sqrt(modulus / rho) - 1) < 1e-14);
    CHECK(law.bulk_modulus(sheared(100, 0), point) == block.bulk_modulus());
    CHECK(c <= law.largest_sound_speed() * (1 + 1e-15));
  }
  CHECK(std::abs(law.largest_sound_speed() / std::sqrt(modulus / 900) - 1) < 1e-14);
}

TEST_CASE("waves in a law whose stiffness depends on the state are the slower the heavier the mixture is") {
  struct OfVoids : Point {
    using Point::operator[];
    double e = 0.7;
    double const& operator[](VoidRatio) const { return e; }
  };
  MixtureDensity<Hypoplastic, 2> const law{hochstetten(), densities};
  auto const sigma = sheared(1e4, 0);
  double const of_light = law.sound_speed(sigma, OfVoids{{.C = {0, 1}}});
  CHECK(of_light > 10);
  CHECK(std::abs(of_light / law.sound_speed(sigma, OfVoids{{.C = {1, 0}}}) - 2) < 1e-13);  // four times as heavy
}

// 2500 kg/m^3 at a bulk density of 1500: a mixture of the bulk density rho has grains of 2500 rho/1500.
TEMPLATE_TEST_CASE("the inertial number has the density of the grains of the mixture", "", MuOfI<PolydisperseGrains<2>>,
                   RisingMuOfI<PolydisperseGrains<2>>) {
  auto const sand = with_grains<TestType>();
  MixtureDensity<TestType, 2> const law{sand, densities};
  double largest = 0;
  for (double const C : {0.0, 0.2, 0.7, 1.0}) {
    Point point{.gamma_dot = 30, .C = {C, 1 - C}};
    auto expected = sand;
    expected.grain_density = 2500 * (C * 3600 + (1 - C) * 900) / 1500;
    double const p = 200;
    CHECK(std::abs(law.shear_strength(p, point) / expected.shear_strength(p, point) - 1) < 1e-14);
    auto const trial = sheared(p, 500);
    CHECK((law.admissible(trial, point, point) - expected.admissible(trial, point, point)).norm() < 1e-11 * p);
    largest = std::max(largest, std::abs(sand.shear_strength(p, point) / expected.shear_strength(p, point) - 1));
    // The section of the point is that of the law inside. The trial is compressed along one axis.
    StressTensor<double> const squeezed = Vec<3, double>(-200, -200, -900).asDiagonal();
    auto const in_section = [&](auto const& each) {
      return InSection<std::remove_cvref_t<decltype(each)>>{each}.admissible(squeezed, point, point);
    };
    CHECK((in_section(law) - in_section(expected)).norm() < 1e-11 * p);
    CHECK((in_section(law) - law.admissible(squeezed, point, point)).norm() > 0.05 * p);
    // The same with a modifier around the densities and within them.
    VolumeMemory<MixtureDensity<TestType, 2>> const around{law};
    MixtureDensity<VolumeMemory<TestType>, 2> const within{{sand}, densities};
    CHECK(around.admissible(trial, point, point) == within.admissible(trial, point, point));
    CHECK((around.admissible(trial, point, point) - expected.admissible(trial, point, point)).norm() < 1e-11 * p);
  }
  CHECK(largest > 0.03);
}

TEST_CASE("densities of species are above zero") {
  using Catch::Matchers::ContainsSubstring;
  auto const check = [](Mixture const& of_species) {
    MixtureDensity<Elastic, 2>{{1e6, 0.3, 1500}, of_species}.check();
  };
  CHECK_NOTHROW(check(densities));
  CHECK_THROWS_WITH(check({1500, 0}), ContainsSubstring("densities[1] (kg/m^3) of MixtureDensity"));
  CHECK_THROWS_WITH(check({std::nan(""), 1}), ContainsSubstring("densities[0] (kg/m^3) of MixtureDensity"));
  CHECK_THROWS_WITH((MixtureDensity<Elastic, 2>{{-1, 0.3, 1500}, densities}.check()), ContainsSubstring("young"));
}

}  // namespace scree::test::mixture_density_tests
