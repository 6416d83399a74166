// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/tension_cutoff.hpp>
#include <scree/laws/volume_memory.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

// Warnings of laws of a user before the first step.
namespace scree::test::response_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
double const nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

/// Elastic, with shares of the stress that it keeps and of the rate that it has.
struct Own {
  double rest_density = 1500, K = 1e6, c = 30, keeps = 1, stiffens = 1;
  using reads = Fields<ShearRate>;
  using history = Fields<>;
  SCREE_FN double density() const { return rest_density; }
  SCREE_FN double bulk_modulus() const { return K; }
  SCREE_FN double sound_speed() const { return c; }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const&, Mat<3, Real> const& L, Point const&) const {
    return Real(stiffens * K) * trace(L) * identity_matrix<StressTensor<Real>>();
  }
  template <class Real, class Point, class Memory>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const&, Memory&&) const {
    return Real(keeps) * trial;
  }
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const&) const {
    return p;
  }
};
/// `Own` with a statement on its cohesion.
template <bool Cohesionless>
struct Says : Own {
  static constexpr bool cohesionless = Cohesionless;
};
template <class Law>
struct Models : GranularModels {
  using law = Law;
};
/// A friction of 0.5 on a circular cone, in place of that of the law, which says that it takes a section.
struct Overruled : MuOfI<> {
  template <class Real, class Point, class Memory>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const&, Memory&&) const {
    return return_to_cone(trial, Real(0.5));
  }
};
struct Honest : Overruled {
  static constexpr bool takes_section = false;
};
template <class Law>
struct OnTheCone : Models<Law> {
  using section = CircularCone;
};
template <class Law, class OfLaw = Models<Law>>
void limits(Law const& law, int dimensions = 2) {
  Granular<OfLaw> const physics{.law = law};
  physics.limits({.dimensions = dimensions, .spacing = 0.1, .smoothing_length = 0.15});
}

}  // namespace

TEST_CASE("a law of a user whose numbers are not above 0 is refused") {
  CHECK_NOTHROW(limits(Own{}));
  for (double const bad : {0.0, -1e6, nan, inf}) {
    CHECK_THROWS_WITH(limits(Own{.K = bad}), StartsWith("scree: bulk_modulus() (Pa) of the law must be above 0"));
    CHECK_THROWS_WITH(limits(Own{.c = bad}), StartsWith("scree: sound_speed() (m/s) of the law must be above 0"));
    CHECK_THROWS_WITH(limits(Own{.rest_density = bad}), StartsWith("scree: density() (kg/m^3) of the law must be"));
  }
}

TEST_CASE("a law that says that it has no cohesion and keeps a tension is refused") {
  CHECK_THROWS_WITH(limits(Says<true>{}),
                    StartsWith("scree: `cohesionless` of the law is true, but admissible() keeps a "));
  CHECK_NOTHROW(limits(Says<false>{}));
  CHECK_NOTHROW(limits(MuOfI<>{.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}}));
  CHECK_NOTHROW(limits(TensionCutoff<MuOfI<>>{{.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}}, 500}));
}

TEST_CASE("a law of a user that does not resist compression is refused, also inside of another law") {
  for (double const none : {0.0, -1.0, nan, inf}) {
    CHECK_THROWS_WITH(limits(Own{.keeps = none}), StartsWith("scree: admissible() of the law gives "));
    CHECK_THROWS_WITH(limits(Own{.stiffens = none}), StartsWith("scree: stress_rate() of the law gives "));
    CHECK_THROWS_WITH(limits(VolumeMemory<Own>{{.keeps = none}}), StartsWith("scree: admissible()"));
    CHECK_THROWS_WITH(limits(TensionCutoff<Own>{{.stiffens = none}}), StartsWith("scree: stress_rate()"));
    Groups<2> groups;
    groups.add("sand", {{0, 0}});
    ByGroup<Own> law(groups);
    law.set(0, {.keeps = none});
    CHECK_THROWS_WITH(law.check(), ContainsSubstring("admissible()") && ContainsSubstring("(group 0 of ByGroup)"));
  }
  CHECK_NOTHROW(limits(Own{.keeps = 0.1, .stiffens = 0.01}));
}

TEST_CASE("a law in space that says that it takes a section, and has a circular cone, is refused") {
  Overruled const sand{{.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}}};
  VolumeMemory<Overruled> const within{sand};
  CHECK_THROWS_WITH(limits(sand, 3), StartsWith("scree: `takes_section` of the law is true, but admissible()"));
  CHECK_THROWS_WITH(limits(within, 3), StartsWith("scree: `takes_section` of the law is true, but admissible()"));
  CHECK_NOTHROW(limits(sand, 2));
  CHECK_NOTHROW(limits(Honest{sand}, 3));
  CHECK_NOTHROW((limits<Overruled, OnTheCone<Overruled>>(sand, 3)));
  // Material without friction has no section either.
  for (double const mu : {0.0, 1e-9, 0.1, 0.382, 9.5}) {
    MuOfI<> const law{.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}, .mu_s = mu, .mu_d = mu + 0.3};
    CHECK_NOTHROW(limits(law, 3));
    CHECK_NOTHROW(limits(VolumeMemory<MuOfI<>>{law}, 3));
  }
  MuOfI<PolydisperseGrains<3>> mixed{.elastic = {1e5, 0.3, 1500}, .grains = {{1e-3, 2e-3, 3e-3}}};
  CHECK_NOTHROW(limits(mixed, 3));
}

TEST_CASE("laws of the library resist compression") {
  Elastic const elastic{1e6, 0.3, 1500};
  CHECK_NOTHROW(limits(elastic));
  CHECK_NOTHROW(limits(MuOfI<>{.elastic = elastic, .grains = {1e-3}}));
  CHECK_NOTHROW(limits(DruckerPrager{elastic, {.friction = 0.4}}));
  CHECK_NOTHROW(limits(TensionCutoff<DruckerPrager>{{elastic, {.friction = 0.4, .cohesion = 100}}}));
  CHECK_NOTHROW(limits(VolumeMemory<MuOfI<>>{{.elastic = elastic, .grains = {1e-3}}}));
}

}  // namespace scree::test::response_tests
