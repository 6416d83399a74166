// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/progress.hpp>

#include <support/printed.hpp>
#include <support/rigid_bodies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <limits>

// Checks of the settings and the displacement of rigid bodies by the positions of their particles.
namespace scree::test::extent_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;

template <int Dim>
using OnHost = Free<Policy<Dim, double, Kokkos::DefaultHostExecutionSpace>>;
double const dr = 0.1;

/// A block 0.4 m wide above zero, and its mass properties.
template <int Dim>
Box<Dim> shape() {
  Vec<Dim, double> low = Vec<Dim, double>::Constant(-0.2), high = Vec<Dim, double>::Constant(0.2);
  low[Dim - 1] = 0, high[Dim - 1] = 0.4;
  return {low, high};
}
template <int Dim>
Rigid<Dim> block() {
  return {.properties = mass_properties(shape<Dim>(), 1000, dr)};
}
/// A block over a floor that is `half` wide to each side.
template <int Dim>
Solver<OnHost<Dim>> over_floor(Rigid<Dim> const& body, double half = 2, double lost_share = 1e-3, bool checks = true,
                               RigidContact const& contact = {.modulus = 1e6, .friction = 0}) {
  Groups<Dim> blocks;
  blocks.add("block", fill_lattice(shape<Dim>(), dr));
  return Solver<OnHost<Dim>>({.spacing = dr,
                              .physics = {},
                              .rigid = {.bodies = {body}, .contact = contact},
                              .lost_share = lost_share,
                              .start_checks = checks},
                             particles_of<Material>(std::vector<Vec<Dim, double>>()),
                             particles_of<Wall>(floor_of<Dim>(half, dr)), particles_of<Block>(blocks));
}
template <int Dim, class Change>
std::string complaint(Change const& change, bool checks = true) {
  auto body = block<Dim>();
  change(body);
  try {
    over_floor<Dim>(body, 2, 1e-3, checks).step(1e-6);
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}
template <int Dim>
void check_settings() {
  INFO(Dim);
  auto const moved = [](double by) { return [by](auto& body) { body.properties.centre[0] += by; }; };
  auto const heavier = [](double times) { return [times](auto& body) { body.properties.inertia *= times; }; };
  CHECK(complaint<Dim>(moved(0)) == "");
  CHECK(complaint<Dim>(moved(0.2)) == "");
  for (double const far : {0.3, 5.0, -5.0, 1e9})
    CHECK_THAT(
        complaint<Dim>(moved(far)),
        ContainsSubstring("centre of a rigid body (m) must be inside of the box of its particles, from (-0.25, ") &&
            ContainsSubstring("(rigid body 0); if this is meant, set `start_checks = false`"));
  CHECK(complaint<Dim>(heavier(1e-3)) == "");
  CHECK(complaint<Dim>(heavier(2)) == "");
  for (double const times : {10.0, 1e3, 1e9})
    CHECK_THAT(complaint<Dim>(heavier(times)),
               ContainsSubstring("largest principal moment of a rigid body (kg m^2) must be at most ") &&
                   ContainsSubstring("that of its mass"));
  CHECK(complaint<Dim>(moved(5), false) == "");
  CHECK(complaint<Dim>(heavier(1e9), false) == "");
  // Where the motion is given, centre and inertia follow from nothing.
  CHECK(complaint<Dim>([](auto& body) {
          body.given_velocity.fill(0.0), body.properties.centre[0] += 5, body.properties.inertia *= 1e9;
        }) == "");
  CHECK(complaint<Dim>([](auto& body) { body.given_turning.fill(0.0), body.properties.inertia *= 1e9; }) == "");
}
}  // namespace

TEST_CASE("the centre of a rigid body is within its particles, and its inertia that of its mass within them") {
  check_settings<2>();
  check_settings<3>();
}

TEST_CASE("a rigid body that falls off the floor stops the run, unless bodies may leave") {
  auto body = block<2>();
  body.properties.centre[0] = 0;
  body.velocity = {3, 0};
  auto solver = over_floor<2>(body, 0.5);
  CHECK_THROWS_AS(solver.run(2), OutsideValidity);
  // 0.5 m of floor, a support of 0.45 m, and the way from the centre to the corners of the block.
  double const x = state_of(solver).x[0], radius = 0.25;
  CHECK(x > 0.5);
  CHECK(x < 0.5 + 0.45 + radius + 0.2);
  auto again = over_floor<2>(body, 0.5);
  CHECK_THROWS_WITH(again.run(2), ContainsSubstring("scree: rigid body 0 with its centre at (") &&
                                      ContainsSubstring("set `lost_share = 1`"));
  auto leaves = over_floor<2>(body, 0.5, 1);
  CHECK_NOTHROW(leaves.run(0.6));
  CHECK(state_of(leaves).x[0] > 1.5);
  // Upwards the domain is open.
  body.velocity = {0, 20};
  CHECK_NOTHROW(over_floor<2>(body, 0.5).run(0.5));
}

TEST_CASE("a rigid body through a floor that does not hold it stops the run") {
  RigidContact const none{.acts = false, .largest_overlap = std::numeric_limits<double>::infinity()};
  auto solver = over_floor<2>(block<2>(), 2, 1e-3, true, none);
  CHECK_THROWS_AS(solver.run(2), OutsideValidity);
  CHECK(state_of(solver).x[1] > -1.5);
}

TEST_CASE("limits of rigid bodies and motions far below those of the physics are named, with both steps") {
  auto const limit = [](char const* name, double step) { return TimeStepLimit{name, step, TimeStepLimit::never}; };
  double const never = TimeStepLimit::never;
  auto const note = [&](double physics, double motion, double springs) {
    return note_on({limit("force", 1), limit("acoustic", physics), limit("motion", motion), limit("springs", springs)},
                   2);
  };
  CHECK(note(1e-4, never, 0.9e-5) ==
        "the steps are those of the limit 'springs', 9e-06 s, which is 11.1 times shorter than the next one, "
        "'acoustic', 0.0001 s");
  CHECK(note(1e-4, 1e-9, 1e-7).starts_with("the steps are those of the limit 'motion', 1e-09 s"));
  CHECK(note(1e-4, never, 1.1e-5) == "");
  CHECK(note(1e-4, 1e-5, never) == "");
  CHECK(note(1e-4, never, never) == "");
  CHECK(note_on({limit("motion", 1e-9)}, 0) == "");
}

TEST_CASE("progress says once that springs set the steps of a run") {
  struct Slow {
    double time() const { return 1; }
    long steps() const { return 2; }
    std::string note_on_steps() const { return "springs are slow"; }
  };
  auto const text = printed([&](std::FILE* stream) {
    Progress progress({.stream = stream, .terminal = false});
    for (int k = 0; k < 5; ++k) progress.after_step(Slow());
  });
  CHECK(text == "note: springs are slow\n");
}

}  // namespace scree::test::extent_tests
