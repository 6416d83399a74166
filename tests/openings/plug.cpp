// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/translation.hpp>
#include <scree/setup/geostatic.hpp>

#include "support.hpp"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace scree::test::plug_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using Sand = FedSand<OnHost>;
struct Belt : FedSand<OnHost> {
  using motion = Translation<2>;
};
struct Plain : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
};

/// The distance of the nearest two particles, m.
template <class S>
double nearest(S const& solver) {
  auto const x = solver.material().to_host(position);
  double found = 1e300;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) found = std::min(found, double((x[i] - x[j]).norm()));
  return found;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a plug is fed and drained at the same rate, and moves as one", "", Policies) {
  using F = FedSand<TestType>;
  constexpr int dim = F::dim, rows = dim == 2 ? 6 : 3;
  long const each = long(slab<dim>(-dr, 0, rows).size());
  double const period = dr / speed;
  auto solver = fed<F>(rows);
  auto const at_start = solver.material().size();
  solver.run(4.05 * period);
  for (int k = 4; k < 24; ++k) {
    auto const before = ledger(solver);
    solver.run((k + 1.05) * period);
    auto const now = ledger(solver);
    if (now.entered - before.entered != each) FAIL("entered: " << now.entered - before.entered);
    if (std::abs(now.left - before.left - each) > 1) FAIL("left: " << now.left - before.left);
    if (now.entered != (3 + k + 1) * each) FAIL("entered since the start: " << now.entered);
    check_ledger(solver);
  }
  CHECK(ledger(solver).at_start == at_start);
  CHECK(solver.turnover().added == solver.entered()[0].particles);
  CHECK(std::abs(solver.entered()[0].volume - double(28 * each - each) * std::pow(dr, dim)) < 1e-5);
  for (auto const& u : solver.material().to_host(velocity))
    CHECK((u.template cast<double>() - speed * Vec<dim, double>::Unit(0)).norm() < ulps<TestType>(100));
  CHECK(std::abs(nearest(solver) - dr) < 1e-3 * dr);
}

TEST_CASE("a bed stays at rest, with its pressure, as seen from the column that enters beside it") {
  // A bed rests in a box whose left side is the inlet; all moves with one speed, and the column of the inlet too.
  double const height = 0.8, rho = 1500;
  Vec<2, double> const u(0.2, 0);
  auto physics = weightless();
  physics.gravity = {9.81};
  physics.law.elastic = {1e6, 0.3, rho};
  double const length = 1.2, wall = 4 * dr;
  auto walls = fill_lattice(Box<2>{{-1.2, -wall}, {length + wall, 0}}, dr);
  for (auto const& x : fill_lattice(Box<2>{{length, 0}, {length + wall, height + wall}}, dr)) walls.push_back(x);
  Solver<Belt> solver({.spacing = dr, .physics = physics, .motion = {u}},
                      fill_lattice(Box<2>{{0, 0}, {length, height}}, dr), walls);
  Geostatic const at_rest{height, rho, 9.81, 0.5};
  auto const stress_at = [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); };
  solver.set(stress, stress_at);
  solver.set(velocity, [&](auto const&) { return u; });
  solver.feed({.layer = fill_lattice(Box<2>{{-dr, 0}, {0, height}}, dr), .velocity = u}, given(stress, stress_at));
  solver.run(4 * dr / u[0]);
  auto const x = solver.material().to_host(position);
  auto const v = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  double worst_stress = 0, worst_speed = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k][0] > 0.8 || x[k][0] < 0) continue;
    worst_speed = std::max(worst_speed, (v[k] - u).norm());
    worst_stress = std::max(worst_stress, std::abs(sigma[k][1] - at_rest(x[k])(1, 1)));
  }

  CHECK(worst_speed < 0.05 * u[0]);
  CHECK(worst_stress < 0.05 * rho * 9.81 * height);
}

TEST_CASE("a shower enters at its rate, to one particle, whatever the length of the steps") {
  for (double const longest : {1e-3, 0.00731, 0.0193}) {
    Solver<Sand> solver({.spacing = dr, .physics = weightless()}, fill_lattice(Box<2>{{0, -3}, {0.5, -2.5}}, dr));
    Inlet<2> inlet{.name = "sieve", .layer = fill_lattice(Box<2>{{0, 0}, {1.3, dr}}, dr), .velocity = {0, -1}};
    inlet.pushes = false;
    inlet.rate = 0.37 * 1.3 * speed;  // m^2/s
    solver.feed(inlet);
    solver.drain({.name = "floor", .reach = 0.2}, Beyond<2>{{0, -1}, {0, -1}});
    while (solver.time() < 2.5) {
      solver.step(longest);
      double const layers = 1 + std::floor(solver.time() / (dr / speed) * (1 + 1e-12));
      double const exact = inlet.rate * layers * dr / speed / (dr * dr);
      if (std::abs(double(solver.entered()[0].particles) - exact) > 1) FAIL(solver.time());
    }
    CHECK(solver.left()[0].particles > 0);
    check_ledger(solver);
  }
}

TEST_CASE("a drain hands over each particle once, with its time, within its reach") {
  auto solver = fed<Sand>();
  struct Handed {
    double time;
    int identity;
    double beyond;
    double C;
  };
  std::vector<Handed> out;
  double const reach = 0.05;
  solver.drain({.name = "second", .reach = reach}, beyond<2>(0.9), Fields<Position, Velocity>{},
               [&](double time, auto const& list) {
                 for (auto const& each : list)
                   out.push_back({time, each[identity], each[position][0] - 0.9, each[velocity][0]});
               });
  solver.run(2.5);
  auto const all = ledger(solver);
  REQUIRE(all.drains[0].particles == 0);
  CHECK(all.drains[1].particles == long(out.size()));
  CHECK(std::abs(all.drains[1].volume - double(out.size()) * dr * dr) < 1e-9);
  double largest = 0;
  for (auto const& each : out) largest = std::max(largest, each.beyond);
  CHECK(largest > 0);
  CHECK(largest <= reach);
  // Those present and those handed over are all that there have been.
  std::vector<int> numbers = solver.material().to_host(identity);
  for (auto const& each : out) numbers.push_back(each.identity);
  std::sort(numbers.begin(), numbers.end());
  REQUIRE(long(numbers.size()) == all.at_start + all.entered);
  for (std::size_t k = 0; k < numbers.size(); ++k) CHECK(numbers[k] == int(k));
}

TEST_CASE("inlets and drains that cannot work are refused") {
  auto solver = fed<Sand>();
  CHECK_THROWS_WITH(solver.feed(pushing<2>(4)), ContainsSubstring("with the name 'inlet' already"));
  CHECK_THROWS_WITH(solver.drain({.name = "a/b"}, beyond<2>(1)), ContainsSubstring("is no name"));
  CHECK_THROWS_WITH(solver.drain({.name = "far", .reach = -1}, beyond<2>(1)), ContainsSubstring("reach (m)"));
  Inlet<2> rain = pushing<2>(4);
  rain.name = "rain", rain.pushes = false, rain.rate = 1e-3;
  CHECK_THROWS_WITH(solver.feed(rain, given(volume, sq(dr) / 2)),
                    ContainsSubstring("has a rate and particles of a given volume"));
  Solver<Plain> plain({.spacing = dr, .physics = weightless()}, slab<2>(0, 0.5, 4));
  CHECK_THROWS_WITH(plain.feed(pushing<2>(4)), ContainsSubstring("carries = Fields<Held>"));

  double const none = std::numeric_limits<double>::quiet_NaN();
  for (double const bad : {0.0, none})
    CHECK_THROWS_WITH(solver.drain({.name = "other"}, Beyond<2>{{1, 0}, {bad, 0}}),
                      ContainsSubstring("length of the normal of Beyond must be above 0"));
  CHECK_THROWS_WITH(solver.drain({.name = "other"}, Beyond<2>{{none, 0}, {1, 0}}),
                    ContainsSubstring("point of Beyond (m) must be finite"));
  CHECK_THROWS_WITH(solver.drain({.name = "other"}, Within<2>{{0, 1}, {1, 1}}),
                    ContainsSubstring("high (m) of Within along axis 1 must be above its low, 1, not 1"));
  CHECK_THROWS_WITH(solver.remove(Beyond<2>{{1, 0}, {0, 0}}), ContainsSubstring("length of the normal of Beyond"));
  CHECK_THROWS_WITH(solver.remove(Within<2>{{1, 0}, {0, 1}}), ContainsSubstring("high (m) of Within along axis 0"));
  double const far = std::numeric_limits<double>::infinity();
  CHECK_NOTHROW(solver.drain({.name = "other"}, Within<2>{{2, -far}, {far, far}}));
  CHECK(solver.left().size() == 2);
}

TEST_CASE("an inlet or end that is refused leaves nothing behind") {
  using F = FedSand<Policy<2, double, Kokkos::DefaultHostExecutionSpace>>;
  Solver<F> solver({.spacing = dr, .physics = weightless()}, slab<2>(0, 0.8, 4));
  auto const before = solver.snapshot();
  CHECK_THROWS_AS(solver.feed(Inlet<2>{}), std::invalid_argument);
  CHECK_THROWS_AS(solver.open_end({.point = {-1, 0}, .normal = {1, 0}}, given(stress, Vec<4, double>(0, 0, 0, 0))),
                  std::invalid_argument);
  CHECK(solver.snapshot().arrays == before.arrays);
  CHECK(solver.snapshot().signature == before.signature);
  CHECK_NOTHROW(solver.restore(before));
  CHECK(solver.entered().empty());
}

TEST_CASE("an inlet may be half as fast as sound") {
  double const c = weightless().law.sound_speed();
  auto const feed = [&](double share, bool checks) {
    Solver<Sand> solver({.spacing = dr, .physics = weightless(), .start_checks = checks}, slab<2>(0, 0.8, 4));
    auto inlet = pushing<2>(4);
    inlet.velocity = {share * c, 0};
    solver.feed(inlet);
  };
  CHECK_NOTHROW(feed(0.49, true));
  for (double const share : {0.51, 0.9, 1.1, 50.0})
    CHECK_THROWS_WITH(feed(share, true), ContainsSubstring("speed (m/s) of inlet 'inlet' must be at most ") &&
                                             ContainsSubstring("half the speed of sound"));
  CHECK_NOTHROW(feed(0.9, false));
}

TEST_CASE("a lack of memory for particles that will enter shows before the run, with the memory they need") {
  auto solver = fed<Sand>();
  assume_free_memory(1e6);
  CHECK_NOTHROW(solver.reserve(1000));
  CHECK_THROWS_WITH(solver.reserve(1'000'000),
                    ContainsSubstring("1e+06 particles need ") && ContainsSubstring("memory, 0.001 GB are there"));
  assume_free_memory(std::numeric_limits<double>::infinity());
  int const before = solver.material().size();
  solver.reserve(100'000);
  CHECK(solver.material().size() == before);
  auto without = fed<Sand>();
  solver.run(0.5), without.run(0.5);
  CHECK(solver.material().to_host(position) == without.material().to_host(position));
}

TEST_CASE("particles that are in the way of a shower stop the run with a message") {
  Solver<Sand> solver({.spacing = dr, .physics = weightless()}, fill_lattice(Box<2>{{0, -0.5}, {0.5, 0}}, dr));
  solver.feed({.layer = fill_lattice(Box<2>{{0, -0.1}, {0.5, 0}}, dr), .velocity = {0, -1}, .pushes = false});
  CHECK_THROWS_WITH(solver.run(0.1), ContainsSubstring("among those that enter, particle 0") &&
                                         ContainsSubstring("those that are there") &&
                                         ContainsSubstring("; material has backed up to the inlet: move the inlet") &&
                                         !ContainsSubstring("start_checks"));
}

TEST_CASE("an inlet whose layer is in a wall names the wall and the place, also where material has backed up to it") {
  auto const floor = fill_lattice(Box<2>{{-0.4, -1}, {1.4, -0.6}}, dr);
  auto const bed = fill_lattice(Box<2>{{0, -0.6}, {1, 0}}, dr);
  auto const sides = fill_lattice(Box<2>{{1, -0.6}, {1.4, 0.4}}, dr);
  auto walls = floor;
  walls.insert(walls.end(), sides.begin(), sides.end());
  auto const complaint = [&](Box<2> const& layer, Vec<2, double> const& shift) -> std::string {
    Solver<Sand> solver({.spacing = dr, .physics = weightless()}, bed, walls);
    auto points = fill_lattice(layer, dr);
    for (auto& x : points) x += shift;
    solver.feed({.layer = points, .velocity = {0, -1}, .pushes = false});
    try {
      solver.run(1e-3);
    } catch (std::invalid_argument const& error) {
      return error.what();
    }
    return "";
  };
  CHECK(complaint({{0, 0.2}, {1, 0.3}}, {0, 0}) == "");
  CHECK(complaint({{0.7, 0.2}, {1, 0.3}}, {0, 0}) == "");  // up to the face of the wall
  CHECK_THAT(complaint({{0.7, 0.2}, {1.2, 0.3}}, {0, 0}),
             ContainsSubstring("particle 3 at (1.05, 0.25) m is ") && ContainsSubstring(" m from particle ") &&
                 ContainsSubstring(" of the wall: ") && ContainsSubstring("a wall is in the way of the inlet") &&
                 !ContainsSubstring("backed up") && !ContainsSubstring("start_checks"));
  CHECK_THAT(complaint({{0.7, -0.1}, {1.2, 0}}, {0, 0}),  // in the bed and in the wall
             ContainsSubstring("a wall is in the way of the inlet") && !ContainsSubstring("backed up"));
  // Half a spacing off the lattice of the wall no particles coincide.
  CHECK_THAT(complaint({{0.7, 0.2}, {1.4, 0.3}}, {0.05, -0.05}),
             ContainsSubstring("(at most 1.3)") && ContainsSubstring("a wall is in the way"));
  CHECK_THAT(complaint({{0, -0.1}, {0.9, 0}}, {0, 0}), ContainsSubstring("material has backed up to the inlet"));
}

TEST_CASE("the layer of an inlet has the spacing of the settings, and single points stand a support apart") {
  auto const feed = [](std::vector<Vec<2, double>> const& layer, bool checks = true, bool pushes = true) {
    Solver<Sand> solver({.spacing = dr, .physics = weightless(), .start_checks = checks}, slab<2>(0, 0.8, 4));
    solver.feed({.layer = layer, .velocity = {speed, 0}, .pushes = pushes});
  };
  auto const row = [](int count, double apart) {
    std::vector<Vec<2, double>> points;
    for (int k = 0; k < count; ++k) points.push_back({-0.05, (k + 0.5) * apart});
    return points;
  };
  for (int const count : {1, 2, 3, 4, 5, 12, 40}) {
    INFO(count);
    for (bool const pushes : {true, false}) CHECK_NOTHROW(feed(row(count, dr), true, pushes));
    CHECK_NOTHROW(feed(row(count, 3.01 * dr)));
    if (count == 1) continue;
    for (double const wrong : {0.5, 0.69, 1.3, 1.5, 2.0, 2.5})
      CHECK_THROWS_WITH(feed(row(count, wrong * dr)), ContainsSubstring("the layer of inlet 'inlet'") &&
                                                          ContainsSubstring("for fewer particles set `rate`"));
    CHECK_NOTHROW(feed(row(count, 2 * dr), false));
  }
  for (double const wrong : {0.8, 0.9, 0.94, 1.07, 1.1, 1.2})
    CHECK_THROWS_WITH(feed(row(40, wrong * dr)), ContainsSubstring("must be settings.spacing, 0.1 m, apart"));
}

TEST_CASE("particles that are added have the spacing of the settings") {
  Solver<Sand> solver({.spacing = dr, .physics = weightless()}, slab<2>(0, 0.8, 4));
  auto const block = [](double spacing) { return fill_lattice(Box<2>{{5, 0}, {7, 2}}, spacing); };
  for (double const wrong : {0.8, 0.9, 1.1, 1.2})
    CHECK_THROWS_WITH(solver.add(block(wrong * dr)), ContainsSubstring("among those to be added, the volumes"));
  CHECK(solver.material().size() == 32);
  CHECK_THROWS_WITH(solver.add(block(dr), given(volume, 0.0)), ContainsSubstring("particle 0 of those that are added"));
  CHECK_THROWS_WITH(solver.add(block(dr), given(volume, 0.01 * dr * dr)), ContainsSubstring("too small"));
  CHECK_NOTHROW(solver.add(block(0.9 * dr), given(volume, 0.81 * dr * dr)));
}

}  // namespace scree::test::plug_tests
