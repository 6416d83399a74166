// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/tension_cutoff.hpp>
#include <scree/laws/volume_memory.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <utility>

namespace scree::test::plausible_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
double const g = 9.81;

MuOfI<> grains(double bed, double solid) {
  return {.elastic = {1e6, 0.3, bed}, .grains = {1e-3}, .grain_density = solid};
}
struct Rates {
  double mu_s, mu_d, I0;
};
MuOfI<> with(Rates const& rates) {
  auto law = grains(1500, 2500);
  law.mu_s = rates.mu_s, law.mu_d = rates.mu_d, law.I0 = rates.I0;
  return law;
}

}  // namespace

TEST_CASE("a bed that is denser than its grains is refused") {
  CHECK_THROWS_WITH(grains(1500, 2.65).check(),
                    ContainsSubstring("rest_density (kg/m^3) of the law must be at most the "
                                      "grain_density of MuOfI, 2.65 kg/m^3") &&
                        ContainsSubstring("not 1500"));
  CHECK_THROWS_WITH((VolumeMemory<RisingMuOfI<>>{{grains(2650, 2500), 0.05}}.check()),
                    ContainsSubstring("must be at most the grain_density"));
  CHECK_THROWS_WITH((MixtureDensity<MuOfI<>, 2>{grains(4000, 2500), {1500, 2000}}.check()),
                    ContainsSubstring("must be at most the grain_density"));
  CHECK_NOTHROW(grains(2500, 2500).check());
}

TEST_CASE("densities of a bed in g/cm^3 are doubted, and those of all grains on earth and elsewhere are not") {
  CHECK_THAT(doubts_of_law(grains(1.5, 2.65), g), ContainsSubstring("is 1.5 kg/m^3") && ContainsSubstring("g/cm^3"));
  CHECK_THAT(doubts_of_law(DruckerPrager{.elastic = {1e6, 0.3, 2}}, g), ContainsSubstring("g/cm^3"));
  CHECK_THAT(doubts_of_law(Hypoplastic{.rest_density = 1.6}, g), ContainsSubstring("g/cm^3"));
  CHECK_THAT(doubts_of_law(MixtureDensity<MuOfI<>, 2>{grains(1500, 2500), {1500, 2.6}}, g),
             ContainsSubstring("is 2.6 kg/m^3"));
  CHECK_THAT(doubts_of_law(grains(1.5, 2500), 1.62), ContainsSubstring("fill only 0.06 % of the bed"));
  // Beads of foam, hollow grains, snow, powder, plastic, glass in water, magnetite, tungsten.
  struct Grains {
    double bed, solid;
  };
  for (auto const& [bed, solid] :
       {Grains{10, 18}, Grains{18, 30}, Grains{20, 917}, Grains{40, 2200}, Grains{1030, 1050}, Grains{2000, 2500},
        Grains{3000, 5200}, Grains{13000, 19300}, Grains{22000, 22500}})
    for (double const gravity : {g, 1.62, 0.0, 24.8}) {
      CAPTURE(bed, solid, gravity);
      CHECK_NOTHROW(grains(bed, solid).check());
      CHECK(doubts_of_law(grains(bed, solid), gravity) == "");
    }
  // Without dimensions: no gravity of the earth in m/s^2.
  for (double const gravity : {0.0, 1.0, 10.0}) CHECK(doubts_of_law(grains(1, 1.7), gravity) == "");
}

TEST_CASE("an I0 in percent is doubted, and those of all fits and of a linear friction are not") {
  CHECK_THAT(doubts_of_law(with({0.382, 0.682, 27.9}), g),
             ContainsSubstring("with an I0 of 27.9") && ContainsSubstring("risen by only 0.01 at an inertial"));
  CHECK_THAT(doubts_of_law(with({0.3, 0.6, 5}), g), ContainsSubstring("I0 of grains is 0.05 to 1"));
  for (Rates const& fit : {Rates{0.382, 0.643, 0.279}, Rates{0.342, 0.557, 0.069}, Rates{0.1, 0.9, 0.01},
                           Rates{0.26, 10, 9}, Rates{0.3, 0.6, 1.9}, Rates{0.5, 0.5, 30}, Rates{0, 0, 0.3}}) {
    CAPTURE(fit.mu_s, fit.mu_d, fit.I0);
    CHECK(doubts_of_law(with(fit), g) == "");
  }
  CHECK(doubts_of_law(RisingMuOfI<>{with({0.3, 0.6, 5}), 1}, g) == "");
}

TEST_CASE("a cohesion above Young's modulus is doubted, and that of clay, ice and gels is not") {
  auto const soil = [](double young, double cohesion) {
    return DruckerPrager{.elastic = {young, 0.3, 1500}, .cone = plane_strain_cone({0.3, cohesion})};
  };
  CHECK_THAT(doubts_of_law(soil(5, 2e4), g), ContainsSubstring("is above Young's modulus, 5 Pa"));  // MPa
  CHECK_THAT(doubts_of_law(TensionCutoff<DruckerPrager>{soil(5e3, 2e4), 0}, g), ContainsSubstring("given in Pa?"));
  for (auto const& [young, cohesion] : {std::pair(5e6, 2e4), std::pair(9e9, 1e6), std::pair(1e3, 700.0)})
    CHECK(doubts_of_law(soil(young, cohesion), g) == "");
}

}  // namespace scree::test::plausible_tests
