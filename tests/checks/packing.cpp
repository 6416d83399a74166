// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/checks/packing.hpp>
#include <scree/granular/granular.hpp>

#include <support/formulations.hpp>
#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

namespace scree::test::packing_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;
using F = Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Granular<>>;

/// A bed under pressure in a box. Its volumes over spacing^2 are given; its particles have moved apart by a factor.
Solver<F> bed(double volumes, double apart, std::string& warning) {
  double const dr = 0.05;
  Granular<> sand;
  sand.law.elastic = {1e6, 0.3, 1500};
  sand.law.grains = {1e-3};
  auto const points = open_bed<2>({1, 0.6}, dr);
  Solver<F> made({.spacing = dr, .physics = sand, .warn = [&](std::string const& text) { warning += text; }},
                 points.material, points.wall);
  made.set(volume, [=](auto const&) { return volumes * dr * dr; });
  made.set(stress, [](auto const& x) {
    double const p = 1500 * 9.81 * (0.6 - x[1]);
    return Vec<4, double>(-p / 2, -p, -p / 2, 0);
  });
  made.set(position, [=](auto const& x) { return Vec<2, double>(apart * x); });
  return made;
}
/// The warnings of a run that continues a snapshot of a number of steps, in its first step.
std::string warning(double volumes, double apart, long steps = 2048) {
  std::string found;
  auto solver = bed(volumes, apart, found);
  auto snapshot = solver.snapshot();
  snapshot.steps = steps;
  solver.restore(snapshot);
  solver.step(1);
  return found;
}

}  // namespace

TEST_CASE("a bed at rest gives no warning of its packing, with volumes up to a quarter from the spacing too") {
  for (double const volumes : {0.76, 0.8, 1.0, 1.2, 1.24}) {
    INFO(volumes);
    CHECK(warning(volumes, 1) == "");
  }
}

TEST_CASE("a bed under pressure that has become looser or denser gives a warning, whatever its volumes are") {
  for (double const volumes : {0.8, 1.0}) {
    INFO(volumes);
    CHECK_THAT(warning(volumes, 1.2),
               ContainsSubstring("scree: warning: after step 2048, at 0 s, grains under pressure are packed 0.") &&
                   ContainsSubstring("depths and flow rates are larger than they should be"));
    CHECK(warning(volumes, 1.2, 2047) == "");
  }
  for (double const volumes : {1.0, 1.2})
    CHECK_THAT(warning(volumes, 0.9), ContainsSubstring("depths and flow rates are smaller than they should be"));
  // Particles that have come closer fill the space if their volumes are as much smaller.
  CHECK(warning(0.8, 0.9) == "");
}

TEST_CASE("a solver tells how grains under pressure are packed: median, loosest and densest twentieth") {
  std::string warnings;
  auto solver = bed(1, 1, warnings);
  Packing const at_rest = solver.packing();
  CAPTURE(at_rest.text());
  CHECK(std::abs(at_rest.density - 1) < 0.01);
  CHECK((at_rest.loose <= at_rest.density && at_rest.density <= at_rest.dense));
  CHECK((std::abs(at_rest.loose - 1) < 0.05 && std::abs(at_rest.dense - 1) < 0.05));
  CHECK_THAT(at_rest.text(), ContainsSubstring(" in " + std::to_string(at_rest.full) + " grains"));
  // a quarter of the bed is 12 % looser, a quarter without pressure much looser
  auto volumes = solver.material().to_host(volume);
  auto const x = solver.material().to_host(position);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i][0] < 0.5) volumes[i] *= x[i][1] < 0.3 ? 0.88 : 0.5;
  auto sigma = solver.material().to_host(stress);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i][0] < 0.5 && x[i][1] >= 0.3) sigma[i].setZero();
  Solver<F> uneven({.spacing = 0.05, .physics = solver.settings().physics, .start_checks = false}, x,
                   solver.wall().to_host(position));
  uneven.set(volume, volumes, [](double v) { return v; });
  uneven.set(stress, sigma, [](auto const& s) { return s; });
  Packing const found = uneven.packing();
  CAPTURE(found.text());
  CHECK(found.full < at_rest.full);  // those without pressure do not count
  CHECK(std::abs(found.density - 1) < 0.02);
  CHECK((found.loose > 0.8 && found.loose < 0.95));
  CHECK(std::abs(found.dense - 1) < 0.05);
  uneven.set(stress, [](auto const&) { return Vec<4, double>::Zero().eval(); });
  CHECK(uneven.packing().full == 0);
  CHECK(uneven.packing().text() == "no grains with others on all sides");
}

TEST_CASE("a packing keeps the volume if its volumes or its spacing say so") {
  Packing const few{.full = 29, .density = 0.1, .by_number = 0.1};
  CHECK(few.keeps_volume());
  for (double const usual : {0.85, 1.0, 1.1})
    for (double const any : {0.5, 0.84, 1.11, 2.0}) {
      CHECK(Packing{.full = 30, .density = usual, .by_number = any}.keeps_volume());
      CHECK(Packing{.full = 30, .density = any, .by_number = usual}.keeps_volume());
      CHECK_FALSE(Packing{.full = 30, .density = any, .by_number = any}.keeps_volume());
    }
  CHECK_FALSE(Packing{.full = 30, .density = 0.84, .by_number = 1.11}.keeps_volume());
}

}  // namespace scree::test::packing_tests
