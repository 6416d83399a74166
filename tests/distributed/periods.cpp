// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/formulations.hpp>
#include <support/shear_box.hpp>

#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/species_segregation.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numeric>

// Cases with periodic ends and moving walls, on several ranks.
namespace scree::test::periods_tests {
using namespace fields;
namespace {

template <class F, class Make>
Outcome check_same_bits(int steps, Make const& make) {
  auto const one = outcome_on<F>(1, steps, make);
  Outcome several;
  for (int ranks : {2, 3, 4}) {
    INFO(ranks << " ranks");
    several = outcome_on<F>(ranks, steps, make);
    CHECK(several.hash == one.hash);
    CHECK(several.builds == one.builds);
  }
  return several;
}

struct Sheared : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
};
/// A block with fast shear between its periodic ends, over a floor.
template <class F>
Solver<F> sheared(Space const& space, SolverSettings<F> settings) {
  settings.spacing = 0.1;
  settings.periods = {{0, 0, 1.2}};
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}};
  settings.sort_period = 50;
  auto const bed = layer({1.2, 0.6}, 0.1);
  Solver<F> solver(space, settings, bed.material, bed.wall);
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(10 * x[1], 0.1 * std::sin(6 * x[0])); });
  return solver;
}

/// The shear box: walls and material move by the motion.
struct ShearBox : Formulation<2> {
  using space = Space;
  using physics = ConservativeSegregation<ConstantClosure>;
  using motion = OscillatingShear;
};
template <class F>
Solver<F> shear_box_at_rest(Space const& space, SolverSettings<F> settings) {
  auto const bed = open_bed<2>({shear_box::width, 1}, 0.05);
  settings.spacing = 0.05;
  settings.physics.closure = shear_box::closure();
  settings.motion = shear_box::motion();
  Solver<F> solver(space, settings, bed.material, bed.wall);
  solver.set(concentration, [](auto const& x) { return shear_box::layered(x[1]); });
  return solver;
}

/// Diffusion that is faster on the right.
struct UnevenClosure {
  using reads = Fields<Position>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[segregation_velocity] = 0.01;
    out[diffusivity] = 0.01 + 0.05 * i[position][0];
  }
};
struct Uneven : Formulation<2> {
  using space = Space;
  using physics = ConservativeSegregation<UnevenClosure>;
};
template <class F>
Solver<F> uneven(Space const& space, SolverSettings<F> settings) {
  auto const bed = open_bed<2>({1, 0.5}, 0.05);
  settings.spacing = 0.05;
  Solver<F> solver(space, settings, bed.material, bed.wall);
  solver.set(concentration, [](auto const& x) { return x[0] > 0.4 ? 0.8 : 0.1; });
  return solver;
}

/// A block in space, periodic along two axes.
struct Block : Formulation<3, float> {
  using space = Space;
  using physics = Granular<>;
};
template <class F>
Solver<F> block(Space const& space, SolverSettings<F> settings) {
  settings.spacing = 0.1;
  settings.periods = {{0, 0, 0.9}, {1, 0, 0.9}};
  settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
  Solver<F> solver(space, settings, cast<float>(fill_lattice(Box<3>{{0, 0, 0}, {0.9, 0.9, 0.4}}, 0.1)),
                   cast<float>(fill_lattice(Box<3>{{0, 0, -0.4}, {0.9, 0.9, 0}}, 0.1)));
  solver.set(velocity, [](auto const& x) { return Vec<3, float>(5 * x[2], -3 * x[2], 0); });
  return solver;
}

/// A box that turns with its sand of three sizes.
struct Drum : Formulation<2> {
  using space = Space;
  using physics = Combined<Granular<>, SpeciesSegregation<ConstantSpecies<3>>>;
  using motion = Rotation;
};
template <class F>
Solver<F> drum(Space const& space, SolverSettings<F> settings) {
  double const dr = 0.01;
  settings.spacing = dr;
  static_cast<MuOfI<>&>(settings.physics.mechanics.law) = {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}};
  settings.physics.transport.closure = {.velocities = {0.01, 0.004, 0}, .diffusivity = 1e-5};
  settings.motion = {.rate = 6};
  Box<2> const room{{-0.12, -0.12}, {0.12, 0.12}};
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{-0.12, -0.12}, {0.12, 0}}, dr), wall_around(room, dr, 4));
  solver.set(concentrations<3>, [](auto const& x) {
    return Vec<3, double>(x[0] > 0 ? 0.6 : 0.2, x[0] > 0 ? 0.4 : 0.3, x[0] > 0 ? 0.0 : 0.5);
  });
  return solver;
}

/// The same with species of different densities.
struct HeavyAndLight : Formulation<2> {
  struct Models : GranularModels {
    using law = MixtureDensity<MuOfI<>, 3>;
  };
  using space = Space;
  using physics = Combined<Granular<Models>, SpeciesSegregation<ConstantSpecies<3>>>;
  using motion = Rotation;
};
template <class F>
Solver<F> heavy_and_light(Space const& space, SolverSettings<F> settings) {
  settings.physics.mechanics.law.densities = {4000, 1500, 700};
  settings.physics.period = 2;
  return drum(space, settings);
}

}  // namespace

TEST_CASE("periodic ends have the same bits on any number of ranks", "") {
  auto const end = check_same_bits<Sheared>(400, sheared<OnRanks<Sheared>>);
  CHECK(end.migrated > 100);
}

TEST_CASE("two periods in space have the same bits on any number of ranks", "") {
  auto const end = check_same_bits<Block>(40, block<OnRanks<Block>>);
  CHECK(end.migrated > 100);
}

TEST_CASE("the oscillating shear box has the same bits on any number of ranks", "") {
  auto const end = check_same_bits<ShearBox>(300, shear_box_at_rest<OnRanks<ShearBox>>);
  CHECK(end.migrated > 10);
}

TEST_CASE("a limit of the step that binds on one rank holds for all", "") {
  check_same_bits<Uneven>(30, uneven<OnRanks<Uneven>>);
}

TEST_CASE("a box that turns with its sand has the same bits on any number of ranks", "") {
  auto const end = check_same_bits<Drum>(600, drum<OnRanks<Drum>>);
  CHECK(end.migrated > 10);
}

TEST_CASE("species of different densities have the same bits on any number of ranks") {
  auto const end = check_same_bits<HeavyAndLight>(600, heavy_and_light<OnRanks<HeavyAndLight>>);
  CHECK(end.migrated > 10);
}

// Images by PeriodicImages and by OtherRanks are the same.
TEST_CASE("one rank with periods has the bits of a solver of its own", "") {
  auto solver = sheared<Whole<Sheared>>(Space(), {});
  for (int k = 0; k < 100; ++k) solver.step(1);
  CHECK(outcome_on<Sheared>(3, 100, sheared<OnRanks<Sheared>>).hash == state_hash(solver));
}

}  // namespace scree::test::periods_tests
