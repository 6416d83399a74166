// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/segregating.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/passes/outside_validity.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace scree::test::own_weight_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

struct Sand : Formulation<2> {
  using physics = Granular<>;
};
struct Mixture : Formulation<2> {
  using physics = SegregatingGranular<Granular<>, ConservativeSegregation<ConstantClosure>>;
};
Granular<>& mechanics_of(Granular<>& physics) { return physics; }
template <class Physics>
Granular<>& mechanics_of(Physics& physics) {
  return physics.mechanics;
}

/// One step of a bed of 0.4 x 0.2 m of a material of 5 kPa, at 9.81 m/s^2, with some density.
template <class F>
void one_step(double density, double inclination = 0, bool checks = true) {
  SolverSettings<F> settings{.spacing = 0.02, .start_checks = checks};
  auto& mechanics = mechanics_of(settings.physics);
  mechanics.law.elastic = {5e3, 0, density};  // c^2 is 5e3/density
  mechanics.law.grains = {1e-3}, mechanics.law.grain_density = 5000;
  mechanics.gravity = {9.81, inclination};
  mechanics.largest_mach = 1e9;
  Solver<F>(settings, fill_lattice(Box<2>{{0, 0}, {0.4, 0.2}}, 0.02)).step(1e-6);
}

TEST_CASE("a bed that its own weight would crush is refused, and a wrong unit is named as the cause") {
  // The particles are 0.18 m apart: 5e3/density = 9.81 0.18 at 2832 kg/m^3.
  CHECK_NOTHROW(one_step<Sand>(2800));
  CHECK_THROWS_MATCHES(
      one_step<Sand>(2860), std::invalid_argument,
      MessageMatches(ContainsSubstring("the weight of the material would crush it: g H is 1.766 m^2/s^2 "
                                       "with a depth H of 0.18 m") &&
                     ContainsSubstring("check the units of stiffness (Pa)")));
  CHECK_THROWS_AS(one_step<Mixture>(2860), std::invalid_argument);
  CHECK_NOTHROW(one_step<Mixture>(2800));
  CHECK_NOTHROW(one_step<Sand>(2860, 0, false));
}

TEST_CASE("a bed that its own weight compresses by a tenth is warned of, once, and a stiffer one is not") {
  auto const said = [](double young, double gravity) {
    std::vector<std::string> all;
    SolverSettings<Sand> settings{.spacing = 0.02, .warn = [&](std::string const& text) { all.push_back(text); }};
    settings.physics.law = {.elastic = {young, 0, 1000}, .grains = {1e-3}};
    settings.physics.gravity = {gravity};
    Solver<Sand> solver(settings, fill_lattice(Box<2>{{0, 0}, {0.4, 0.2}}, 0.02));
    solver.check_start();
    for (int n = 0; n < 3; ++n) solver.step(1e-6);
    return all;
  };
  // 9.81 0.18/c^2 is 0.1 with c^2 = 17.66 m^2/s^2.
  auto const soft = said(17.2e3, 9.81);
  REQUIRE(soft.size() == 1);
  CHECK_THAT(soft[0], ContainsSubstring("compresses the material by 10 % at its bottom") &&
                          ContainsSubstring("12 sqrt(g H), 15.95 m/s, or more is recommended"));
  CHECK(said(18e3, 9.81).empty());
  CHECK(said(3e3, 1.62).empty());  // on the moon
  CHECK(said(100, 0).empty());
}

TEST_CASE("a thin layer along a slope, and separate beds, give no warning of a deep bed") {
  auto const said = [](std::vector<Vec<2, double>> const& points, double inclination) {
    std::string all;
    SolverSettings<Sand> settings{.spacing = 0.02, .warn = [&](std::string const& text) { all += text; }};
    settings.physics.law = {.elastic = {5e4, 0, 1000}, .grains = {1e-3}};
    settings.physics.gravity = {9.81, inclination};
    Solver<Sand>(settings, points).step(1e-6);
    return all;
  };
  // c^2 is 50 m^2/s^2, so that a depth of 0.51 m is the bar. The layer extends over 2 m along gravity.
  auto const layer = fill_lattice(Box<2>{{0, 0}, {5, 0.1}}, 0.02);
  CHECK(said(layer, 0.41) == "");
  auto beds = fill_lattice(Box<2>{{0, 0}, {0.4, 0.2}}, 0.02);
  for (auto const& x : fill_lattice(Box<2>{{2, 2}, {2.4, 2.2}}, 0.02)) beds.push_back(x);
  CHECK(said(beds, 0) == "");
  CHECK_THAT(said(fill_lattice(Box<2>{{0, 0}, {0.4, 1}}, 0.02), 0), ContainsSubstring("compresses the material by"));
}

TEST_CASE("the depth of a bed is its extent along gravity") {
  // Along the first coordinate the particles are 0.38 m apart: 1341 kg/m^3.
  CHECK_NOTHROW(one_step<Sand>(1330, std::acos(-1) / 2));
  CHECK_THROWS_AS(one_step<Sand>(1350, std::acos(-1) / 2), std::invalid_argument);
}

struct OfGroups : GranularModels {
  using law = ByGroup<MuOfI<>>;
};
struct Layers : Formulation<2> {
  using physics = Granular<OfGroups>;
};
/// One step of a bed of two layers as in one_step(), of different densities.
void one_step_of_layers(double below, double above) {
  Groups<2> layers;
  layers.add("below", fill_lattice(Box<2>{{0, 0}, {0.4, 0.1}}, 0.02))
      .add("above", fill_lattice(Box<2>{{0, 0.1}, {0.4, 0.2}}, 0.02));
  SolverSettings<Layers> settings{.spacing = 0.02};
  settings.physics.law = ByGroup<MuOfI<>>(layers);
  for (int k = 0; k < 2; ++k)
    settings.physics.law.set(k, {.elastic = {5e3, 0, k == 0 ? below : above}, .grains = {1e-3}, .grain_density = 5000});
  settings.physics.largest_mach = 1e9;
  Solver<Layers>(settings, layers).step(1e-6);
}

TEST_CASE("a bed of layers is refused if it would crush the material with the fastest sound") {
  CHECK_NOTHROW(one_step_of_layers(2860, 2800));
  CHECK_THROWS_WITH(one_step_of_layers(2860, 2900), ContainsSubstring("would crush it"));
}

struct OfMixture : GranularModels {
  using law = MixtureDensity<MuOfI<>, 2>;
};
struct Mixed : Formulation<2> {
  using physics = Granular<OfMixture>;
};
/// One step of a mixture with densities of its species, whose concentrations nothing transports.
void one_step_of_mixture(double density, Vec<2, double> const& concentrations) {
  SolverSettings<Mixed> settings{.spacing = 0.02};
  settings.physics.law = {{.elastic = {5e3, 0, density}, .grains = {1e-3}, .grain_density = 5000},
                          {density, 2 * density}};
  settings.physics.largest_mach = 1e9;
  Solver<Mixed> solver(settings, fill_lattice(Box<2>{{0, 0}, {0.4, 0.2}}, 0.02));
  solver.set(fields::concentrations<2>, [&](auto const&) { return concentrations; });
  solver.step(1e-6);
}

TEST_CASE("a bed of a mixture is refused if it would crush the lightest species") {
  CHECK_NOTHROW(one_step_of_mixture(2800, {0.5, 0.5}));
  CHECK_THROWS_WITH(one_step_of_mixture(2860, {0.5, 0.5}), ContainsSubstring("would crush it"));
}

TEST_CASE("a law with densities of species stops a run whose concentrations are no mixture, whatever transports them") {
  CHECK_THROWS_AS(one_step_of_mixture(2800, {0.5, 0.6}), OutsideValidity);
  CHECK_THROWS_AS(one_step_of_mixture(2800, {1.1, -0.1}), OutsideValidity);
}

}  // namespace
}  // namespace scree::test::own_weight_tests
