// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/passes/time_step.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <limits>

namespace scree::test::time_step_tests {
namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();

double look_and_choose(TimeStepControl& control, std::vector<TimeStepLimit> const& limits, double remaining) {
  control.look(limits, 0);
  return control.choose(remaining);
}
}  // namespace

TEST_CASE("the smallest limit decides the step, and is remembered by name") {
  TimeStepControl control;
  CHECK(look_and_choose(control, {{"diffusion", 0.5}, {"motion", 0.25}, {"segregation", 2}}, 100) == 0.25);
  CHECK(look_and_choose(control, {{"diffusion", 0.125}, {"motion", 0.25}}, 100) == 0.125);
  CHECK(look_and_choose(control, {{"diffusion", 0.5}, {"motion", 0.25}}, 100) == 0.25);
  CHECK(look_and_choose(control, {{"diffusion", infinite}}, 3) == 3);
  CHECK(control.counts() == std::map<std::string, long>{{"diffusion", 1}, {"motion", 2}, {"output", 1}});
}

TEST_CASE("a step never exceeds a limit nor what remains") {
  TimeStepControl control;
  for (double const remaining : {1e-9, 0.1, 0.30000000000000004, 1.0, 17.3})
    for (double const limit : {0.1, 0.07, 1e-4, 50.0}) {
      INFO(remaining << " s remain, limit " << limit);
      double const step = look_and_choose(control, {{"only", limit}}, remaining);
      CHECK(step <= limit * (1 + 1e-11));
      CHECK(step <= remaining);
      CHECK(step > 0.5 * std::min(limit, remaining) * (1 - 1e-11));
    }
}

TEST_CASE("steps up to an output are even: no sliver at the end") {
  for (double const limit : {0.1, 0.0999, 0.1001, 0.34}) {
    TimeStepControl control;
    double time = 0, shortest = 1;
    int steps = 0;
    while (time < 1 - 1e-9 && steps < 100) {
      double const dt = look_and_choose(control, {{"only", limit}}, 1 - time);
      time += dt;
      shortest = std::min(shortest, dt);
      ++steps;
    }
    INFO("limit " << limit << ": " << steps << " steps, the shortest " << shortest);
    CHECK(steps == static_cast<int>(std::ceil(1 / limit - 1e-9)));
    CHECK(shortest > (1 - 1e-9) / steps);
    CHECK(std::abs(time - 1) < 1e-12);
  }
}

TEST_CASE("a limit that is not a positive number stops with a message") {
  TimeStepControl control;
  for (double const bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), -infinite})
    CHECK_THROWS_WITH(look_and_choose(control, {{"motion", 1}, {"diffusion", bad}}, 1),
                      Catch::Matchers::StartsWith("scree: the diffusion limit of the time step is "));
}

TEST_CASE("a step that nothing limits needs an end") {
  TimeStepControl control;
  CHECK_THROWS_AS(look_and_choose(control, {}, infinite), std::invalid_argument);
  CHECK_THROWS_AS(look_and_choose(control, {{"only", infinite}}, infinite), std::invalid_argument);
  CHECK(look_and_choose(control, {{"only", 0.5}}, infinite) == 0.5);
  CHECK(look_and_choose(control, {{"only", 1e-300}}, 1e300) == 1e-300);
}

TEST_CASE("limits that follow the state are looked at before every step unless a constant one is far smaller") {
  TimeStepControl control;
  CHECK(control.must_look(0));
  control.look({{"acoustic", 1, infinite}, {"force", 3.9}}, 0);
  CHECK(control.must_look(1));
  // A quarter of the shortest time in which the state changes.
  control.look({{"acoustic", 1, infinite}, {"viscous", 2, infinite}, {"force", 48}, {"diffusion", 400}}, 5);
  CHECK_FALSE(control.must_look(16));
  CHECK(control.must_look(17));
  control.look({{"acoustic", 1, infinite}, {"force", infinite}}, 20);
  CHECK_FALSE(control.must_look(275));
  CHECK(control.must_look(276));
  control.look({{"acoustic", 1, infinite}, {"force", 0.9}}, 276);
  CHECK(control.must_look(277));
  CHECK(control.choose(100) == Catch::Approx(100.0 / 112));
}

TEST_CASE("a limit may follow from a state that changes slower than the limit is long") {
  TimeStepControl control;
  control.look({{"acoustic", 1, infinite}, {"diffusion", 4, 200}}, 0);
  CHECK_FALSE(control.must_look(49));
  CHECK(control.must_look(50));
}

TEST_CASE("a run that goes on takes the steps it would have taken") {
  std::vector<TimeStepLimit> const at_look{{"acoustic", 1, infinite}, {"force", 48}};
  std::vector<TimeStepLimit> const later{{"acoustic", 1, infinite}, {"force", 0.5}};
  TimeStepControl through, resumed;
  through.look(at_look, 0);
  CHECK(through.choose(100) == 1);
  resumed.restore(through.counts(), through.next_look());
  CHECK(resumed.counts() == std::map<std::string, long>{{"acoustic", 1}});
  // Before the next check neither notices that the force has grown.
  CHECK_FALSE(through.must_look(7));
  REQUIRE(resumed.must_look(7));
  resumed.look(later, 7);
  CHECK(resumed.choose(100) == through.choose(100));
  CHECK_FALSE(resumed.must_look(11));
  for (auto* control : {&through, &resumed}) {
    REQUIRE(control->must_look(12));
    control->look(later, 12);
    CHECK(control->choose(100) == 0.5);
  }
}

}  // namespace scree::test::time_step_tests
