// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/section.hpp>

#include "../laws/in_section.hpp"
#include "../laws/random_stresses.hpp"

#include <scree/granular/granular.hpp>
#include <scree/granular/parts.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/tension_cutoff.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace scree::test::section_tests {
namespace {

using OnHost = Policy<3, double, Kokkos::DefaultHostExecutionSpace>;
template <class Law, class Named = SectionByLaw>
struct With : GranularModels {
  using law = Law;
  using section = Named;
};
/// MuOfI as a law of a user that takes no section.
struct OfUser : MuOfI<> {
  static constexpr bool takes_section = false;
};
template <class Law, int dim, class Named = SectionByLaw>
using section_of = typename Granular<With<Law, Named>>::template section_in<dim>;
template <class Law>
constexpr bool of_sand_in_space =
    std::is_same_v<section_of<Law, 3>, MatsuokaNakai>&& std::is_same_v<section_of<Law, 2>, CircularCone>;
template <class Law>
constexpr bool as_it_is =
    std::is_same_v<section_of<Law, 3>, CircularCone>&& std::is_same_v<section_of<Law, 2>, CircularCone>;

MuOfI<> sand() { return {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}, .mu_s = 0.6, .mu_d = 0.9}; }
template <class Law>
Law filled() {
  if constexpr (requires { Law().groups(); }) {
    Groups<3> groups;
    groups.add("sand", {{0, 0, 0}});
    Law law(groups);
    law.set(0, {sand()});
    return law;
  } else {
    return {sand()};
  }
}

/// The stress that the pass of a solver stores for a trial stress, packed as in a number of dimensions.
template <int dim, class Named, class Law>
Vec<symmetric3_size<dim>, double> admitted(Law const& law, Vec<symmetric3_size<dim>, double> const& trial) {
  using P = Policy<dim, double, Kokkos::DefaultHostExecutionSpace>;
  using Admit = granular::Admit<Law, Named, Fields<>>;
  Record<P, reads_of<Admit>> i{};
  static_cast<scree::detail::Slot<P, Stress>&>(i).value = trial;
  Results<P, writes_of<Admit>> out;
  Admit{law}(i, out);
  return out[fields::stress];
}
template <int dim>
double ratio_of(Vec<symmetric3_size<dim>, double> const& stress) {
  Mat<3, double> const sigma = unpacked(stress);
  return equivalent_shear_stress(deviator_of(sigma)) / pressure_of(sigma);
}

template <int Dim, class Named>
struct Case : Formulation<Dim> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<With<MuOfI<>, Named>>;
};
/// Linear in the cosine, as in docs/extending.md; `Bound` is added to the bound of its ratios, `Shift` to them.
template <int Bound, int Shift>
struct Linear {
  template <class Real>
  SCREE_FN Real ratio(Real k, Real cosine) const {
    return k * (1 + k * cosine / 4) + Shift * Real(0.01);
  }
  template <class Real>
  SCREE_FN Real least_ratio(Real k) const {
    return k * (1 - k / 4) + Bound * Real(0.01);
  }
};
template <class S>
void take_section() {
  Granular<With<MuOfI<>, S>> physics;
  physics.law = sand();
  physics.limits({.dimensions = 3, .spacing = 0.01, .smoothing_length = 0.015});
}
struct Soil : Formulation<3> {
  using physics = Granular<With<DruckerPrager>>;
};
/// sqrt(J2)/p in the middle of a block that is compressed along the last axis beyond its strength, after one step.
template <int Dim, class Named>
double strength_in_run() {
  double const dr = 0.02, p = 1000, t = 2000;
  SolverSettings<Case<Dim, Named>> settings{.spacing = dr, .warn = {}};
  settings.physics.law = sand();
  using X = Vec<Dim, double>;
  Box<Dim> const block{X::Zero(), X::Constant(9 * dr)};
  Solver<Case<Dim, Named>> solver(settings, fill_lattice(block, dr), {});
  Mat<3, double> sigma = (t - p) * Mat<3, double>::Identity();
  sigma(Dim - 1, Dim - 1) -= 3 * t;
  solver.set(fields::stress, [&](auto const&) { return packed<Dim>(sigma); });
  solver.run(1e-6);
  auto const x = solver.material().to_host(fields::position);
  auto const stresses = solver.material().to_host(fields::stress);
  for (std::size_t n = 0; n < x.size(); ++n)
    if ((x[n] - X::Constant(4.5 * dr)).norm() < dr / 4) return ratio_of<Dim>(stresses[n]);
  return 0;
}

}  // namespace

TEST_CASE("in space laws of friction have the section of sand by default, other laws the surface that is theirs") {
  STATIC_CHECK(of_sand_in_space<MuOfI<>>);
  STATIC_CHECK(of_sand_in_space<MuOfI<BidisperseGrains>>);
  STATIC_CHECK(of_sand_in_space<RisingMuOfI<>>);
  STATIC_CHECK(of_sand_in_space<VolumeMemory<MuOfI<>>>);
  STATIC_CHECK(of_sand_in_space<ByGroup<VolumeMemory<MuOfI<>>>>);
  STATIC_CHECK(of_sand_in_space<TensionCutoff<MuOfI<>>>);
  STATIC_CHECK(of_sand_in_space<MixtureDensity<MuOfI<PolydisperseGrains<2>>, 2>>);
  STATIC_CHECK(as_it_is<DruckerPrager>);
  STATIC_CHECK(as_it_is<ByGroup<DruckerPrager>>);
  STATIC_CHECK(as_it_is<Elastic>);
  STATIC_CHECK(as_it_is<Hypoplastic>);
  STATIC_CHECK(as_it_is<OfUser>);
  // One that is named is taken, in the plane too.
  STATIC_CHECK(std::is_same_v<section_of<MuOfI<>, 3, CircularCone>, CircularCone>);
  STATIC_CHECK(std::is_same_v<section_of<MuOfI<>, 2, MatsuokaNakai>, MatsuokaNakai>);
  STATIC_CHECK(std::is_same_v<section_of<DruckerPrager, 3, CircularCone>, CircularCone>);
  // The law of a user stays what it is.
  STATIC_CHECK(std::is_same_v<decltype(Granular<>::law), MuOfI<>>);
}

TEMPLATE_TEST_CASE("a stress in space is returned to the section of sand, in the plane and by name to the cone", "",
                   MuOfI<>, VolumeMemory<MuOfI<>>, ByGroup<VolumeMemory<MuOfI<>>>, TensionCutoff<MuOfI<>>) {
  auto const law = filled<TestType>();
  double const k = friction_ratio(0.6);
  // Compressed along one axis, beyond yield: I1 I2/I3 is that of plane shear at the ratio k.
  Vec<6, double> squeezed = packed<3>(Mat<3, double>(Vec<3, double>(-10, -10, -900).asDiagonal()));
  auto const sand_in_space = admitted<3, SectionByLaw>(law, squeezed);
  double const s1 = -sand_in_space[2], s3 = -sand_in_space[0];
  CHECK(std::abs((s1 + 2 * s3) * (2 * s1 * s3 + s3 * s3) / (s1 * s3 * s3) * (1 - k * k) / (9 - 3 * k * k) - 1) < 1e-12);
  CHECK(ratio_of<3>(sand_in_space) > 1.1 * k);
  CHECK(std::abs(ratio_of<3>(admitted<3, CircularCone>(law, squeezed)) - k) < 1e-14);
  Vec<4, double> const in_plane = packed<2>(Mat<3, double>(Vec<3, double>(-10, -900, -10).asDiagonal()));
  CHECK(std::abs(ratio_of<2>(admitted<2, SectionByLaw>(law, in_plane)) - k) < 1e-14);
  CHECK(std::abs(ratio_of<2>(admitted<2, MatsuokaNakai>(law, in_plane)) - ratio_of<3>(sand_in_space)) < 1e-12);
}

TEST_CASE("in the plane, and on the cone in space, stresses have the bits that the law alone gives") {
  MuOfI<> const law = sand();
  RandomStresses<3, double> random;
  Record<OnHost, Fields<ShearRate>> const still{};
  int beside = 0;
  for (int n = 0; n < 5000; ++n) {
    Mat<3, double> const trial = random.next();
    auto const alone = law.admissible(trial, still, NoHistory{});
    Vec<6, double> const packed_trial = packed<3>(trial);
    REQUIRE(admitted<3, CircularCone>(law, packed_trial) == packed<3>(alone));
    InSection<MuOfI<>> const in_section{law};
    REQUIRE(admitted<3, SectionByLaw>(law, packed_trial) ==
            packed<3>(in_section.admissible(trial, still, NoHistory{})));
    beside += admitted<3, SectionByLaw>(law, packed_trial) != packed<3>(alone);
    Vec<4, double> const in_plane = packed<2>(trial);
    auto const plane = law.admissible(Mat<3, double>(unpacked(in_plane)), still, NoHistory{});
    REQUIRE(admitted<2, SectionByLaw>(law, in_plane) == packed<2>(plane));
  }
  CHECK(beside > 1000);
}

TEST_CASE("a run has the strength of its section") {
  double const k = friction_ratio(0.6), in_compression = MatsuokaNakai{}.ratio(k, 1.0);
  CHECK(std::abs(strength_in_run<3, SectionByLaw>() / in_compression - 1) < 1e-3);
  CHECK(std::abs(strength_in_run<3, CircularCone>() / k - 1) < 1e-3);
  CHECK(std::abs(strength_in_run<2, SectionByLaw>() / k - 1) < 1e-3);
}

TEST_CASE("a section whose bound is above its ratios, or that is not k in plane shear, is refused") {
  using Catch::Matchers::ContainsSubstring;
  using Catch::Matchers::MessageMatches;
  CHECK_NOTHROW(take_section<MatsuokaNakai>());
  CHECK_NOTHROW((take_section<Linear<0, 0>>()));
  for (int again = 0; again < 2; ++again) {
    CHECK_THROWS_MATCHES((take_section<Linear<1, 0>>()), std::invalid_argument,
                         MessageMatches(ContainsSubstring("least_ratio(0.05) of the section is 0.05938: ")));
    CHECK_THROWS_MATCHES((take_section<Linear<-9, 0>>()), std::invalid_argument,
                         MessageMatches(ContainsSubstring("it must be 0 or more")));
    CHECK_THROWS_MATCHES((take_section<Linear<0, 1>>()), std::invalid_argument,
                         MessageMatches(ContainsSubstring("ratio(0.05, 0) of the section is 0.06: in plane shear")));
  }
}

TEST_CASE("the section that acts is among the parts, of laws that take one") {
  using Catch::Matchers::ContainsSubstring;
  CHECK_THAT((parts_of<Case<3, SectionByLaw>>()), ContainsSubstring("  section: scree::MatsuokaNakai\n"));
  CHECK_THAT((parts_of<Case<3, CircularCone>>()), ContainsSubstring("  section: scree::CircularCone\n"));
  CHECK_THAT((parts_of<Case<2, SectionByLaw>>()), ContainsSubstring("  section: scree::CircularCone\n"));
  CHECK_THAT(parts_of<Soil>(), !ContainsSubstring("  section: "));
}

}  // namespace scree::test::section_tests
