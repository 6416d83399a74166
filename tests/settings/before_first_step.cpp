// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/segregating.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/tension_cutoff.hpp>
#include <scree/motion/delayed.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/schlick_closure.hpp>
#include <scree/segregation/size_ratio_closure.hpp>
#include <scree/segregation/trewhela_closure.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// A solver checks its models before the first step, wherever they are.
namespace scree::test::before_first_step_tests {
using namespace fields;
namespace {

using Catch::Matchers::StartsWith;
double const spacing = 0.1;
Box<2> const box{{0, 0}, {0.4, 0.4}};

template <class Physics, class OfMotion = AtRest, class OfDiagnostics = NoDiagnostics>
struct Case : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Physics;
  using motion = OfMotion;
  using diagnostics = OfDiagnostics;
};
template <class Physics, class Points = std::vector<Vec<2, double>>>
void step(Physics const& physics, Points const& points = fill_lattice(box, spacing)) {
  Solver<Case<Physics>> solver({.spacing = spacing, .physics = physics}, points);
  if constexpr (requires { physics.transport; }) solver.set(concentration, [](auto const&) { return 0.5; });
  solver.step(1e-6);
}

MuOfI<> const sand{.elastic = {1e6, 0.3, 1500}, .grains = {1e-3}};
MuOfI<> with_mu_s(double mu_s) {
  auto law = sand;
  law.mu_s = mu_s;
  return law;
}
char const* const about_mu_s = "scree: mu_s (-) of MuOfI must be 0 or more, not -1";

template <class OfLaw>
struct Models : GranularModels {
  using law = OfLaw;
};
template <class OfLaw>
using With = Granular<Models<OfLaw>>;

/// Models of a user with settings of their own.
struct Wind {
  double push = 0;  // m/s^2
  using reads = Fields<Velocity>;
  void check() const { check_setting(push >= 0, "push of Wind (m/s^2)", push, "0 or more"); }
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    return std::remove_cvref_t<decltype(i[velocity])>(push * i[velocity]);
  }
};
struct Rough : AdamiWalls {
  double roughness = 0;  // m
  void check() const { check_setting(roughness >= 0, "roughness (m)", roughness, "0 or more"); }
};
struct Windy : GranularModels {
  using forces = std::tuple<Wind>;
  using walls = Rough;
};
/// Contains a model of the library and checks nothing itself.
struct ByHand {
  Granular<> inside = {};
  using evolves = Granular<>::evolves;
  auto stages(Resolution const& resolution) const { return inside.stages(resolution); }
  auto limits(Resolution const& resolution) const { return inside.limits(resolution); }
};
/// Checks itself.
struct OfUser {
  double rate = 0;  // 1/s
  using evolves = Fields<Velocity, Position>;
  void check() const { check_setting(rate > 0, "rate (1/s) of OfUser", rate, "above 0"); }
  std::tuple<> passes(Resolution const&) const { return {}; }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
struct Output {
  double width = 1;  // m
  void check() const { check_setting(width > 0, "width (m) of Output", width, "above 0"); }
  std::tuple<> passes(Resolution const&) const { return {}; }
};

}  // namespace

TEST_CASE("a law is checked before the first step, alone, in others, by group, combined and by hand") {
  CHECK_NOTHROW(step(Granular<>{.law = sand}));
  CHECK_THROWS_WITH(step(Granular<>{.law = with_mu_s(-1)}), StartsWith(about_mu_s));
  CHECK_THROWS_WITH(step(With<VolumeMemory<MuOfI<>>>{.law = {with_mu_s(-1)}}), StartsWith(about_mu_s));
  auto const groups = Groups<2>().add("all", fill_lattice(box, spacing));
  ByGroup<MuOfI<>> law(groups);
  law.set(0, with_mu_s(-1));
  CHECK_THROWS_WITH(step(With<ByGroup<MuOfI<>>>{.law = law}, groups), StartsWith(about_mu_s));
  CHECK_THROWS_WITH(step(With<VolumeMemory<ByGroup<MuOfI<>>>>{.law = {law}}, groups), StartsWith(about_mu_s));
  ConservativeSegregation<ConstantClosure> segregation;
  CHECK_NOTHROW(step(combine(Granular<>{.law = sand}, segregation)));
  CHECK_THROWS_WITH(step(combine(Granular<>{.law = with_mu_s(-1)}, segregation)), StartsWith(about_mu_s));
  CHECK_THROWS_WITH(step(combine(Granular<>{.law = sand}, segregation, 0)),
                    StartsWith("scree: period (steps) of the transport in Combined must be 1 or more, not 0"));
  segregation.closure.velocity = -1;
  CHECK_THROWS_WITH(step(combine(Granular<>{.law = sand}, segregation)),
                    StartsWith("scree: velocity (m/s) of ConstantClosure"));
  CHECK_NOTHROW(step(ByHand{{.law = sand}}));
  CHECK_THROWS_WITH(step(ByHand{{.law = with_mu_s(-1)}}), StartsWith(about_mu_s));
}

TEST_CASE("a law that is ill-posed at every inertial number is warned about once, and no other is") {
  auto const groups = Groups<2>().add("all", fill_lattice(box, spacing));
  auto const warnings = [&](auto const& physics, bool start_checks = true) {
    std::vector<std::string> said;
    Solver<Case<std::remove_cvref_t<decltype(physics)>>> solver(
        {.spacing = spacing,
         .physics = physics,
         .start_checks = start_checks,
         .warn = [&](std::string const& text) { said.push_back(text); }},
        groups);
    if constexpr (requires { physics.transport; }) solver.set(concentration, [](auto const&) { return 0.5; });
    solver.check_start();
    for (int n = 0; n < 3; ++n) solver.step(1e-6);
    for (auto const& text : said) CHECK_THAT(text, StartsWith("scree: warning: the friction of the law rises too"));
    return said.size();
  };
  MuOfI<> constant = sand, nothing = sand;
  constant.mu_d = constant.mu_s, nothing.mu_s = nothing.mu_d = 0;
  CHECK(warnings(Granular<>{.law = constant}) == 1);
  CHECK(warnings(Granular<>{.law = constant}, false) == 0);
  CHECK(warnings(Granular<>{.law = sand}) == 0);
  CHECK(warnings(Granular<>{.law = nothing}) == 0);
  CHECK(warnings(combine(Granular<>{.law = constant}, ConservativeSegregation<ConstantClosure>{})) == 1);
  for (auto const& [law, expected] : {std::pair(sand, 0u), std::pair(constant, 1u)}) {
    VolumeMemory<ByGroup<MuOfI<>>> by_group{ByGroup<MuOfI<>>(groups)};
    by_group.set(0, law);
    CHECK(warnings(With<VolumeMemory<ByGroup<MuOfI<>>>>{.law = by_group}) == expected);
  }
}

TEST_CASE("gravity that acts upwards and soil without strength are warned about, each once") {
  using Soil = With<DruckerPrager>;
  auto const said = [&](auto const& physics) {
    std::vector<std::string> all;
    Solver<Case<std::remove_cvref_t<decltype(physics)>>> solver(
        {.spacing = spacing, .physics = physics, .warn = [&](std::string const& text) { all.push_back(text); }},
        fill_lattice(box, spacing));
    solver.check_start();
    for (int n = 0; n < 3; ++n) solver.step(1e-6);
    return all;
  };
  char const* const upwards = "scree: warning: gravity acts upwards: its inclination is ";
  char const* const liquid = "scree: warning: the cone of the law has neither friction nor cohesion";
  for (double const angle : {0.0, 0.5, -std::numbers::pi / 2, std::numbers::pi / 2})
    CHECK(said(Granular<>{.law = sand, .gravity = {.inclination = angle}}).empty());
  for (double const degrees : {2.0, -3.0}) {
    auto const once = said(Granular<>{.law = sand, .gravity = {.inclination = degrees}});
    REQUIRE(once.size() == 1);
    CHECK_THAT(once[0], StartsWith(upwards));
    CHECK(said(Granular<>{.law = sand, .gravity = {.magnitude = 0, .inclination = degrees}}).empty());
  }
  CHECK(said(Soil{.law = {sand.elastic, {.friction = 0.4}}}).empty());
  CHECK(said(Soil{.law = {sand.elastic, {.cohesion = 100}}}).empty());
  auto const nothing = said(Soil{.law = {sand.elastic}});
  REQUIRE(nothing.size() == 1);
  CHECK_THAT(nothing[0], StartsWith(liquid));
  CHECK(said(With<TensionCutoff<DruckerPrager>>{.law = {{sand.elastic}}}).size() == 1);
  auto const both = said(Soil{.law = {sand.elastic}, .gravity = {.inclination = 3}});
  REQUIRE(both.size() == 1);
  CHECK_THAT(both[0], StartsWith(upwards));
  CHECK(both[0].find(std::string("\n") + liquid) != std::string::npos);
}

TEST_CASE("a diameter of grains in mm is warned about, once, in every law and beside a transport") {
  auto const groups = Groups<2>().add("all", fill_lattice(box, spacing));
  auto const said = [&](auto const& physics) {
    std::vector<std::string> all;
    Solver<Case<std::remove_cvref_t<decltype(physics)>>> solver(
        {.spacing = spacing, .physics = physics, .warn = [&](std::string const& text) { all.push_back(text); }},
        groups);
    if constexpr (requires { physics.transport; }) solver.set(concentration, [](auto const&) { return 0.5; });
    solver.check_start();
    for (int n = 0; n < 3; ++n) solver.step(1e-6);
    for (auto const& text : all)
      CHECK_THAT(text, StartsWith("scree: warning: the diameter of the grains, 2 m, is 20 "));
    return all.size();
  };
  MuOfI<> millimetres = sand, wide = sand;
  millimetres.grains.diameter = 2, wide.grains.diameter = 10 * spacing;
  CHECK(said(Granular<>{.law = wide}) == 0);
  CHECK(said(Granular<>{.law = millimetres}) == 1);
  CHECK(said(With<VolumeMemory<MuOfI<>>>{.law = {millimetres}}) == 1);
  CHECK(said(combine(Granular<>{.law = millimetres}, ConservativeSegregation<ConstantClosure>{})) == 1);
  ByGroup<MuOfI<>> law(groups);
  CHECK(said(With<ByGroup<MuOfI<>>>{.law = law.set(0, millimetres)}) == 1);
  MuOfI<BidisperseGrains> const mixed{.elastic = sand.elastic, .grains = {1, 2}};
  CHECK(said(combine(With<MuOfI<BidisperseGrains>>{.law = mixed}, ConservativeSegregation<ConstantClosure>{})) == 1);
}

TEST_CASE("densities in g/cm^3 and an I0 in percent are warned about, once, in every law") {
  auto const groups = Groups<2>().add("all", fill_lattice(box, spacing));
  auto const said = [&](auto const& physics, char const* expected) {
    std::string all;
    Solver<Case<std::remove_cvref_t<decltype(physics)>>> solver(
        {.spacing = spacing, .physics = physics, .warn = [&](std::string const& text) { all += text + '\n'; }}, groups);
    solver.check_start();
    for (int n = 0; n < 3; ++n) solver.step(1e-6);
    auto const at = all.find(expected);
    return at != std::string::npos && all.find(expected, at + 1) == std::string::npos;
  };
  MuOfI<> light = sand, percent = sand;
  light.elastic.rest_density = 1.5, light.grain_density = 2.65, percent.I0 = 27.9;
  char const *const of_density = "the density of the material is 1.5 kg/m^3", *const of_I0 = "with an I0 of 27.9";
  CHECK(said(Granular<>{.law = light}, of_density));
  CHECK(said(Granular<>{.law = percent}, of_I0));
  CHECK(said(With<DruckerPrager>{.law = {light.elastic, {.friction = 0.4}}}, of_density));
  ByGroup<MuOfI<>> law(groups);
  CHECK(said(With<VolumeMemory<ByGroup<MuOfI<>>>>{.law = {law.set(0, percent)}}, of_I0));
}

TEST_CASE("grains of a closure that are lighter than the bed are refused") {
  ConservativeSegregation<TrewhelaClosure> in_g_per_cm3{{.d_small = 1e-3, .d_large = 2e-3, .grain_density = 2.65}};
  CHECK_THROWS_WITH(step(combine(Granular<>{.law = sand}, in_g_per_cm3)),
                    StartsWith("scree: rest_density (kg/m^3) of the law must be at most the grain_density of the "
                               "closure, 2.65 kg/m^3"));
  in_g_per_cm3.closure.grain_density = 2650;
  CHECK_NOTHROW(step(combine(Granular<>{.law = sand}, in_g_per_cm3)));
}

TEST_CASE("a closure that is used outside of what it was fitted to is warned about once") {
  auto const said = [&](auto const& physics) {
    std::vector<std::string> all;
    Solver<Case<std::remove_cvref_t<decltype(physics)>>> solver(
        {.spacing = spacing, .physics = physics, .warn = [&](std::string const& text) { all.push_back(text); }},
        fill_lattice(box, spacing));
    solver.set(concentration, [](auto const&) { return 0.5; });
    solver.check_start();
    for (int n = 0; n < 3; ++n) solver.step(1e-6);
    return all;
  };
  using Sorted = ConservativeSegregation<SchlickClosure>;
  Sorted const within{{.d_small = 1e-3, .d_large = 3e-3}}, beyond{{.d_small = 1e-3, .d_large = 4e-3}};
  CHECK(said(combine(Granular<>{.law = sand}, within)).empty());
  auto const once = said(combine(Granular<>{.law = sand}, beyond));
  REQUIRE(once.size() == 1);
  CHECK_THAT(once[0], StartsWith("scree: warning: SchlickClosure was fitted to grains whose sizes differ by at most a "
                                 "factor of 3; here it is 4"));
  MuOfI<> constant = sand;
  constant.mu_d = constant.mu_s;
  auto const both = said(combine(Granular<>{.law = constant}, beyond));
  REQUIRE(both.size() == 1);
  CHECK_THAT(both[0], StartsWith("scree: warning: the friction"));
  CHECK(both[0].find("\nscree: warning: SchlickClosure") != std::string::npos);
  CHECK(warning_of_closure(SizeRatioClosure<3>{.diameters = {1e-3, 2e-3, 2.9e-3}}).empty());
  CHECK(!warning_of_closure(SizeRatioClosure<3>{.diameters = {2e-3, 4e-3, 1e-3}}).empty());
  CHECK(warning_of_closure(ConstantClosure{}).empty());
}

TEST_CASE("models of a user are checked before the first step") {
  CHECK_NOTHROW(step(Granular<Windy>{.law = sand}));
  CHECK_THROWS_WITH(step(Granular<Windy>{.law = sand, .forces = {Wind{-1}}}), StartsWith("scree: push of Wind"));
  CHECK_THROWS_WITH(step(Granular<Windy>{.law = sand, .walls = {{}, -1}}), StartsWith("scree: roughness (m) must"));
  CHECK_NOTHROW(step(OfUser{1}));
  CHECK_THROWS_WITH(step(OfUser{}), "scree: rate (1/s) of OfUser must be above 0, not 0");
}

TEST_CASE("a motion and diagnostics are checked when a solver is made") {
  using P = Case<OfUser, Delayed<Rotation>, Output>;
  auto const make = [](Delayed<Rotation> const& motion, Output const& output) {
    Solver<P>({.spacing = spacing, .physics = {1}, .motion = motion, .diagnostics = output},
              fill_lattice(box, spacing));
  };
  CHECK_NOTHROW(make({.start = 1, .stop = 1}, {}));
  CHECK_THROWS_WITH(make({.start = 1, .stop = 0.5}, {}), "scree: stop (s) of Delayed must be start or later, not 0.5");
  CHECK_THROWS_WITH(make({}, {0}), "scree: width (m) of Output must be above 0, not 0");
}

TEST_CASE("a solver that goes on from a snapshot checks its models too") {
  Solver<Case<OfUser>> good({.spacing = spacing, .physics = {1}}, fill_lattice(box, spacing));
  good.step(1e-3);
  Solver<Case<OfUser>> bad({.spacing = spacing, .physics = {0}}, fill_lattice(box, spacing));
  bad.restore(good.snapshot());
  CHECK_THROWS_WITH(bad.step(1e-3), StartsWith("scree: rate (1/s) of OfUser"));
}

TEST_CASE("a group that a law inside of another does not know stops the run") {
  auto const groups = Groups<2>()
                          .add("known", fill_lattice(box, spacing))
                          .add("new", fill_lattice(Box<2>{{1, 0}, {1.4, 0.4}}, spacing));
  ByGroup<MuOfI<>> law(Groups<2>().add("known", fill_lattice(box, spacing)));
  law.set(0, sand);
  CHECK_THROWS_AS(step(With<VolumeMemory<ByGroup<MuOfI<>>>>{.law = {law}}, groups), OutsideValidity);
}

}  // namespace scree::test::before_first_step_tests
