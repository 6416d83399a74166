// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/checks/start.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/openings/inlet.hpp>
#include <scree/setup/hexagonal.hpp>
#include <scree/setup/rings.hpp>
#include <scree/setup/walls.hpp>

#include <support/formulations.hpp>
#include <support/granular_box.hpp>
#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace scree::test::start_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

template <int Dim>
PlacedParticles placed(Points<Dim> const& points, double volume) {
  PlacedParticles result;
  for (auto const& x : points) result.places.push_back({x[0], x[1], Dim == 3 ? x[Dim - 1] : 0.0});
  result.volumes.assign(points.size(), volume);
  return result;
}
void check(PlacedParticles material, PlacedParticles const& wall, double spacing, int dim,
           std::vector<Period> const& periods) {
  std::size_t const owned = material.places.size();
  material.places.insert(material.places.end(), wall.places.begin(), wall.places.end());
  material.volumes.insert(material.volumes.end(), wall.volumes.begin(), wall.volumes.end());
  check_start(material, owned, spacing, dim, periods);
}
/// The message of check_start() for points with the volumes of a spacing, or "".
template <int Dim>
std::string complaint(Points<Dim> const& material, Points<Dim> const& wall, double spacing,
                      std::vector<Period> const& periods = {}) {
  double const volume = std::pow(spacing, Dim);
  try {
    check(placed<Dim>(material, volume), placed<Dim>(wall, volume), spacing, Dim, periods);
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}
template <int Dim>
Points<Dim> together(Points<Dim> a, Points<Dim> const& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
template <int Dim>
Box<Dim> cube(double low, double high) {
  return {Vec<Dim, double>::Constant(low), Vec<Dim, double>::Constant(high)};
}
template <int Dim>
Bed<Dim> bed() {
  return open_bed<Dim>(Vec<Dim, double>::Constant(1.2), 0.1);
}

template <int Dim>
void check_that_beds_pass() {
  INFO(Dim);
  auto const [material, wall] = bed<Dim>();
  CHECK(complaint<Dim>(material, wall, 0.1) == "");
  CHECK(complaint<Dim>(material, {}, 0.1) == "");
  CHECK(complaint<Dim>({}, wall, 0.1) == "");
  CHECK(complaint<Dim>({}, {}, 0.1) == "");
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto points = fill_lattice(cube<Dim>(0, Dim == 2 ? 6 : 2), 0.1);
    jitter(points, 0.03, seed);
    CHECK(complaint<Dim>(points, {}, 0.1) == "");
    CHECK(complaint<Dim>(points, {}, 0.1, {{0, 0, Dim == 2 ? 6.0 : 2.0}}) == "");
  }
}
template <int Dim>
void check_that_faults_are_found() {
  INFO(Dim);
  auto const [material, wall] = bed<Dim>();
  using vector = Vec<Dim, double>;
  // Every particle twice, and a single one.
  CHECK_THAT(complaint<Dim>(together<Dim>(material, material), wall, 0.1),
             ContainsSubstring("scree: at the start particle 0 at (0.05, 0.05") &&
                 ContainsSubstring("is 0 m from particle ") &&
                 ContainsSubstring("; if this is meant, set `start_checks = false`"));
  CHECK_THAT(complaint<Dim>(together<Dim>(material, {material[77]}), wall, 0.1), ContainsSubstring("particle 77 at ("));
  // Two particles at almost the same position.
  auto moved = material;
  for (auto& x : moved) x += vector::Constant(0.04);
  CHECK_THAT(complaint<Dim>(together<Dim>(material, moved), {}, 0.1), ContainsSubstring("times as dense"));
  // The spacing in the settings too large or too small.
  CHECK_THAT(complaint<Dim>(material, wall, 0.2),
             ContainsSubstring(Dim == 2 ? "stands in a material and walls 3.99" : "7.99"));
  CHECK_THAT(complaint<Dim>(material, wall, 0.05), ContainsSubstring("has no neighbour within 1.5 spacings (0.075 m)"));
  // The bed overlaps the floor, on the same lattice and on another one.
  auto sunk = material;
  for (auto& x : sunk) x[Dim - 1] -= 0.1;
  CHECK_THAT(complaint<Dim>(sunk, wall, 0.1), ContainsSubstring("is 0 m from particle") || ContainsSubstring("e-1"));
  CHECK_THAT(complaint<Dim>(sunk, wall, 0.1), ContainsSubstring(" of the wall: a tenth of the spacing, 0.01 m"));
  for (auto& x : sunk) x[0] += 0.05, x[Dim - 1] -= 0.25;
  CHECK_THAT(complaint<Dim>(sunk, wall, 0.1), ContainsSubstring("do bodies overlap"));
  // A row at both ends of a period.
  CHECK_THAT(complaint<Dim>(material, {}, 0.1, {{0, 0, 1.1}}), ContainsSubstring("m from particle"));
}

}  // namespace

TEST_CASE("lattices, jittered and beside walls, may start") {
  check_that_beds_pass<2>();
  check_that_beds_pass<3>();
}

TEST_CASE("rings, hexagonal lattices, a few particles and free ones may start") {
  auto const rings = fill_rings(Ball<2>{{0, 0}, 1}, 0.07, HalfSpace<2>{{0, 0.2}, {0, 1}});
  auto all = placed<2>(rings.points, 0);
  all.volumes = rings.volumes;
  CHECK_NOTHROW(check(all, placed<2>(wall_rings(Ball<2>{{0, 0}, 1}, 0.07, 3), 0.0049), 0.07, 2, {}));
  // The same bed on a lattice next to the rings of the wall.
  auto const lattice = fill_lattice(Ball<2>{{0, 0}, 1} & HalfSpace<2>{{0, 0.2}, {0, 1}}, 0.07);
  CHECK(complaint<2>(lattice, wall_rings(Ball<2>{{0, 0}, 1}, 0.07, 3), 0.07) == "");
  CHECK(complaint<2>(fill_hexagonal(cube<2>(0, 1), 0.05), {}, 0.05) == "");
  CHECK(complaint<3>(fill_hexagonal(cube<3>(0, 1), 0.1), {}, 0.1) == "");
  CHECK(complaint<2>({Vec<2, double>(1, 2)}, {}, 0.1) == "");
  CHECK(complaint<2>({Vec<2, double>(1, 2), Vec<2, double>(5, 2), Vec<2, double>(1e300, 0)}, {}, 0.1) == "");
}

TEST_CASE("layers of few rows on steep ground may start, jittered too, at their spacing and at no other") {
  double const dr = 0.1;
  for (double const slope : {0.4, 0.7, 1.0})
    for (double const rows : {1.5, 2.0, 2.5, 3.0}) {
      Points<3> material, wall;
      double const thick = rows * dr * std::hypot(1, slope);  // vertically, m
      for (auto const& x : fill_lattice(Box<3>{{0, 0, -0.6}, {2.5, 1.5, 3.2}}, dr)) {
        double const above = x[2] - slope * x[0];
        if (above > 0 && above < thick)
          material.push_back(x);
        else if (above <= 0 && above > -0.35 * std::hypot(1, slope))
          wall.push_back(x);
      }
      CAPTURE(slope, rows);
      CHECK(complaint<3>(material, wall, dr) == "");
      for (double const factor : {0.9, 0.95, 1.05, 1.1})
        if (rows > 2) CHECK_THAT(complaint<3>(material, wall, factor * dr), ContainsSubstring("settings.spacing"));
      jitter(material, 0.1 * dr, 3);
      CHECK(complaint<3>(material, wall, dr) == "");
    }
}

TEST_CASE("particles twice in a place, in walls, or at another spacing than said may not start") {
  check_that_faults_are_found<2>();
  check_that_faults_are_found<3>();
}

TEST_CASE("two particles in one place are found among a million, and so is one that overlaps a wall") {
  auto const points = fill_lattice(cube<2>(0, 100), 0.1);
  REQUIRE(points.size() == 1'000'000);
  CHECK(complaint<2>(points, {}, 0.1) == "");
  for (std::size_t const i : {654'321u, 654'322u})
    CHECK_THAT(complaint<2>(together<2>(points, {points[i]}), {}, 0.1),
               ContainsSubstring("particle " + std::to_string(i) + " at (") &&
                   ContainsSubstring("is 0 m from particle 1000000:"));
  CHECK_THAT(complaint<2>(points, {points[123'457] + Vec<2, double>(0.004, 0)}, 0.1),
             ContainsSubstring("particle 123457 at (") && ContainsSubstring("is 0.004 m from particle 0 of the wall"));
}

TEST_CASE("many particles in one place are refused at once") {
  CHECK_THAT(complaint<3>(Points<3>(200'000, Vec<3, double>(1, 2, 3)), {}, 0.1),
             ContainsSubstring("particle 0 at (1, 2, 3) m is 0 m from particle 1:"));
}

TEST_CASE("a solver looks at the start before its first step, and once") {
  auto const [material, wall] = bed<2>();
  struct Steps : NothingEvolves {
    auto limits(Resolution const&) const { return std::tuple(limit("step", 1.0)); }
  };
  using S = Solver<Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Steps>>;
  S wrong({.spacing = 0.2}, material, wall);
  CHECK_THROWS_WITH(wrong.step(1), ContainsSubstring("times as dense"));
  CHECK_THROWS_WITH(wrong.run(1), ContainsSubstring("times as dense"));
  CHECK(wrong.time() == 0);
  CHECK_THROWS_WITH(wrong.check_start(), ContainsSubstring("times as dense"));
  wrong.set(position, [](auto const& x) { return Vec<2, double>(2 * x + Vec<2, double>(0, 5)); });
  CHECK_NOTHROW(wrong.run(1));
  wrong.set(position, [](auto const&) { return Vec<2, double>(0, 5); });
  CHECK_NOTHROW(wrong.run(2));

  S meant({.spacing = 0.2, .start_checks = false}, material, wall);
  CHECK_NOTHROW(meant.run(1));
  S right({.spacing = 0.1}, material, wall), restored({.spacing = 0.1}, material, wall);
  right.set(position, [](auto const&) { return Vec<2, double>(0, 5); });
  CHECK_THROWS_WITH(right.run(1), ContainsSubstring("is 0 m from particle"));
  restored.restore(right.snapshot());
  CHECK_NOTHROW(restored.run(1));
}

TEST_CASE("a check of the start finds what the first step would, and the step looks again") {
  auto const bed = open_bed<2>({1, 0.5}, 0.05);
  using S = Solver<Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Granular<>>>;
  Granular<> sand{.law = {.elastic = {1e6, 0.3, 1500}, .grains = {1e-3}}};
  auto const made = [&](Granular<> const& physics, SolverSettings<typename S::policy> settings = {}) {
    settings.spacing = 0.05, settings.physics = physics;
    S solver(settings, bed.material, bed.wall);
    return solver;
  };
  auto const refused = [](S solver, char const* why) {
    CHECK_THROWS_WITH(solver.check_start(), ContainsSubstring(why));
    CHECK_THROWS_WITH(solver.step(1), ContainsSubstring(why));
    CHECK(solver.steps() == 0);
  };
  auto soft = sand, slow = sand;
  soft.law.elastic.young = 1;
  refused(made(soft), "would crush it");
  slow.cfl = -1;
  refused(made(slow), "cfl");
  auto fast = made(sand);
  fast.set(velocity, [](auto const&) { return Vec<2, double>(1e4, 0); });
  refused(std::move(fast), "outside the validity of the model");
  auto broken = made(sand);
  broken.set(stress, [](auto const&) { return Vec<4, double>(0, std::nan(""), 0, 0); });
  refused(std::move(broken), "finite");

  auto good = made(sand);
  good.check_start();
  CHECK(good.steps() == 0);
  good.set(position, [](auto const&) { return Vec<2, double>(0.1, 0.1); });
  CHECK_THROWS_WITH(good.step(1), ContainsSubstring("is 0 m from particle"));
}

TEMPLATE_TEST_CASE("a check of the start changes no bit of a run, from its beginning and from a snapshot", "", Midpoint,
                   SymplecticEuler) {
  auto const start = granular_box::turning<double, TestType>();
  auto later = granular_box::turning<double, TestType>();
  std::vector<Snapshot> all{start.snapshot()};
  // Segregation comes at every seventh step, and reads there what the step before left.
  for (long const steps : {14, 17}) all.push_back(granular_box::stepped(later, steps).snapshot());
  for (auto const& from : all) {
    auto plain = granular_box::turning<double, TestType>(), checked = granular_box::turning<double, TestType>();
    plain.restore(from), checked.restore(from);
    checked.check_start();
    CHECK(checked.steps() == from.steps);
    for (auto* solver : {&plain, &checked}) granular_box::stepped(*solver, from.steps + 25);
    CHECK(plain.time() == checked.time());
    CHECK(plain.material().to_host(position) == checked.material().to_host(position));
    CHECK(plain.material().to_host(stress) == checked.material().to_host(stress));
    CHECK(plain.material().to_host(concentration) == checked.material().to_host(concentration));
  }
}

TEST_CASE(
    "a solver looks at volumes that are set: before its first step, and during a run, where they may not get worse") {
  auto const [material, wall] = bed<2>();
  struct Steps : NothingEvolves {
    auto limits(Resolution const&) const { return std::tuple(limit("step", 1.0)); }
  };
  using S = Solver<Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Steps>>;
  S solver({.spacing = 0.1}, material, wall);
  auto const all = [](double V) { return [V](auto const&) { return V; }; };
  double const nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (double const none : {0.0, -0.01, nan, infinite}) {
    CHECK_THROWS_WITH(solver.set(volume, all(none)),
                      ContainsSubstring("the volume (m^dim) of particle 0 of the material must be above 0 and finite"));
    int number = 0;
    CHECK_THROWS_WITH(solver.set(volume, [&](auto const&) { return number++ == 17 ? none : 0.01; }),
                      ContainsSubstring("particle 17 of the material"));
    CHECK_THROWS_WITH(solver.set<Wall>(volume, all(none)), ContainsSubstring("particle 0 of the wall"));
  }
  solver.set(volume, all(0.0001));
  CHECK_THROWS_WITH(solver.run(1), ContainsSubstring("the volumes are too small"));
  solver.set(volume, all(0.011));
  CHECK_NOTHROW(solver.run(1));
  CHECK_THROWS_WITH(solver.set(volume, all(0.0001)),
                    ContainsSubstring("scree: after set() the volumes of the particles fill 0.01"));
  CHECK(solver.material().to_host(volume) == std::vector<double>(material.size(), 0.011));
  CHECK_NOTHROW(solver.set(volume, all(0.01)));
  // A bed that was compressed by 1.44 continues from a snapshot, and its volumes may approach those that fit.
  solver.set(position, [](auto const& x) { return Vec<2, double>(x / 1.2); });
  S restored({.spacing = 0.1}, material, wall);
  restored.restore(solver.snapshot());
  CHECK_NOTHROW(restored.run(2));
  CHECK_NOTHROW(restored.set(volume, all(0.009)));
  CHECK_THROWS_WITH(restored.set(volume, all(0.0105)), ContainsSubstring("after set()"));
  S unchecked({.spacing = 0.1, .start_checks = false}, material, wall);
  unchecked.set(volume, all(0.0001));
  CHECK_NOTHROW(unchecked.run(1));
}

namespace {

/// Points with a share of their spacing as uniform jitter along each axis, checked with other spacings.
template <int Dim>
void check_spacings(Points<Dim> points, Points<Dim> const& wall, double spacing, double jittered) {
  INFO(Dim << " dimensions, " << points.size() << " points, jitter " << jittered);
  jitter(points, jittered * spacing, 7);
  for (double const right : {0.995, 1.0, 1.005}) {
    INFO(right);
    CHECK(complaint<Dim>(points, wall, right * spacing) == "");
  }
  for (double const wrong :
       {0.3, 0.5, 0.6, 0.67, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1.05, 1.1, 1.2, 1.25, 1.3, 1.6, 3.0}) {
    INFO(wrong);
    CHECK_THAT(complaint<Dim>(points, wall, wrong * spacing), ContainsSubstring("spacing"));
  }
}
Points<2> layer_of(int rows) { return fill_lattice(Box<2>{{0, 0}, {4, rows * 0.1}}, 0.1); }
Packing packing(PlacedParticles const& particles, double spacing, int dimensions) {
  return packing_of(particles, particles.places.size(), spacing, dimensions, {});
}

}  // namespace

TEST_CASE("a spacing in the settings that is off by 5 % or more may not start, one off by 0.5 % may") {
  auto const rings = fill_rings(Ball<2>{{0, 0}, 1}, 0.07).points;
  for (double const jittered : {0.0, 0.1, 0.2, 0.3}) {
    auto const [bed2, wall2] = bed<2>();
    check_spacings<2>(bed2, wall2, 0.1, jittered);
    check_spacings<2>(bed2, {}, 0.1, jittered);
    check_spacings<2>(fill_hexagonal(cube<2>(0, 1.5), 0.1), {}, 0.1, jittered);
    check_spacings<2>(rings, {}, 0.07, jittered);
    auto const [bed3, wall3] = bed<3>();
    check_spacings<3>(bed3, wall3, 0.1, jittered);
    check_spacings<3>(bed3, {}, 0.1, jittered);
    check_spacings<3>(fill_hexagonal(cube<3>(0, 1.2), 0.1), {}, 0.1, jittered);
  }
}

namespace {

/// The message for a bed on a floor of four spacings that has a spacing of its own, volumes over those of the bed, and
/// a gap below the bed, in spacings of the bed.
template <int Dim>
std::string complaint_of_floor(double spacing, double volume, double gap, double jittered = 0) {
  double const dr = 0.1, width = spacing * dr;
  Box<Dim> bed, floor;
  for (int axis = 0; axis < Dim - 1; ++axis) bed.low[axis] = 0, bed.high[axis] = 1.5;
  bed.low[Dim - 1] = gap * dr, bed.high[Dim - 1] = gap * dr + 1;
  floor = bed;
  for (int axis = 0; axis < Dim - 1; ++axis) floor.low[axis] = -4 * dr, floor.high[axis] = 1.5 + 4 * dr;
  int const rows = int(std::ceil(4 / spacing));
  floor.low[Dim - 1] = -rows * width, floor.high[Dim - 1] = 0;
  auto material = fill_lattice(bed, dr), wall = fill_lattice(floor, width);
  jitter(material, jittered * dr, 7), jitter(wall, jittered * dr, 8);
  try {
    check(placed<Dim>(material, std::pow(dr, Dim)), placed<Dim>(wall, volume * std::pow(dr, Dim)), dr, Dim, {});
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("walls of another spacing or with other volumes may not start, beside gaps they may", "",
                       ((int Dim), Dim), 2, 3) {
  for (double const jittered : {0.0, 0.2})
    for (double const gap : {0.0, 0.1, 0.3, 0.7, 2.0}) {
      INFO("jitter " << jittered << ", gap " << gap);
      CHECK(complaint_of_floor<Dim>(1, 1, gap, jittered) == "");
    }
  for (double const spacing : {0.7, 0.75, 0.85, 1.2, 1.5}) {
    INFO("spacing " << spacing);
    CHECK_THAT(complaint_of_floor<Dim>(spacing, 1, 0), ContainsSubstring("spacing and volumes of the walls"));
    CHECK(complaint_of_floor<Dim>(spacing, std::pow(spacing, Dim), 0) == "");  // volumes of its own
  }
  for (double const volume : {0.3, 0.5, 0.8, 1.25, 2.0}) {
    INFO("volume " << volume);
    CHECK_THAT(complaint_of_floor<Dim>(1, volume, 0), ContainsSubstring("spacing and volumes of the walls"));
  }
  CHECK_THAT(complaint_of_floor<Dim>(0.7, 1, 0),
             ContainsSubstring("scree: at the start the particles of walls fill ") && ContainsSubstring(", 0.1 m?"));
}

namespace {

/// The message for a bed of 15 spacings on particles of walls, of the volume spacing^dim.
template <int Dim>
std::string complaint_on(Points<Dim> const& wall, double volume = 1) {
  Box<Dim> bed{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(1.5)};
  bed.high[Dim - 1] = 0.8;
  try {
    auto const material = fill_lattice(bed, 0.1);
    check(placed<Dim>(material, std::pow(0.1, Dim)), placed<Dim>(wall, volume * std::pow(0.1, Dim)), 0.1, Dim, {});
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}
/// A floor of two rows or more, `spacing` apart; the first row is half a spacing of the floor, or of the bed, below it.
template <int Dim>
Points<Dim> floor_of(double spacing, bool is_near) {
  double const width = 0.1 * spacing;
  auto const beyond = [&](double x) { return std::ceil(x / width) * width; };
  Box<Dim> box;
  for (int axis = 0; axis < Dim - 1; ++axis) box.low[axis] = -beyond(0.4), box.high[axis] = beyond(1.9);
  box.low[Dim - 1] = -std::max(2 * width, beyond(0.4)), box.high[Dim - 1] = 0;
  auto floor = fill_lattice(box, width);
  if (is_near)
    for (auto& x : floor) x[Dim - 1] += width / 2 - 0.05;
  return floor;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("walls that are so sparse that they are not on all sides may not start, single particles may",
                       "", ((int Dim), Dim), 2, 3) {
  for (double const spacing : {1.67, 1.8, 2.0, 2.1, 2.5, 3.0})
    for (bool const is_near : {false, true}) {
      INFO("spacing " << spacing << (is_near ? ", near" : ""));
      CHECK_THAT(complaint_on<Dim>(floor_of<Dim>(spacing, is_near)),
                 ContainsSubstring("the particles of walls are too far apart") && ContainsSubstring("0.1 m?"));
      if (!is_near) CHECK(complaint_on<Dim>(floor_of<Dim>(spacing, false), std::pow(spacing, Dim)) == "");  // its own
    }
  CHECK(complaint_on<Dim>(floor_of<Dim>(1, false)) == "");
  CHECK_THAT(complaint_on<Dim>(floor_of<Dim>(2, false)),
             ContainsSubstring(Dim == 2 ? "their volumes are 0.25 times" : "their volumes are 0.125 times"));
  // Pins: one below the bed, and some above its surface.
  Vec<Dim, double> pin = Vec<Dim, double>::Constant(0.75);
  pin[Dim - 1] = -0.05;
  CHECK(complaint_on<Dim>({pin}) == "");
  Points<Dim> pins;
  for (int k = 0; k < 4; ++k) pin[0] = 0.35 * k + 0.1, pin[Dim - 1] = 1.05, pins.push_back(pin);
  CHECK(complaint_on<Dim>(pins) == "");
  // A floor of the right spacing, and as many pins.
  auto floor = floor_of<Dim>(1, false);
  std::size_t const particles = floor.size();
  for (std::size_t k = 0; k + 1 < particles; ++k) pin[0] = double(k), pin[Dim - 1] = 5, floor.push_back(pin);
  CHECK(complaint_on<Dim>(floor) == "");
}

TEMPLATE_TEST_CASE_SIG("a sparse floor among many walls of the right spacing gives a warning, alone it may not start",
                       "", ((int Dim), Dim), 2, 3) {
  // A bed with thick sides along the first axis, and a floor of pins in two rows.
  double const width = 4;
  Box<Dim> bed{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(0.8)};
  bed.high[0] = width;
  auto const material = fill_lattice(bed, 0.1);
  auto sides = bed;
  sides.low[0] = -4, sides.high[0] = width + 4;
  Points<Dim> right;
  for (auto const& x : fill_lattice(sides, 0.1))
    if (x[0] < 0 || x[0] > width) right.push_back(x);
  REQUIRE(right.size() > material.size());
  auto const complaint_of = [&](double apart, bool has_sides) {
    auto walls = has_sides ? right : Points<Dim>();
    auto below = bed;
    below.low[Dim - 1] = -0.2 * apart, below.high[Dim - 1] = 0;
    for (auto& x : fill_lattice(below, 0.1 * apart)) {
      x[Dim - 1] += 0.05 * (apart - 1);  // the first row is half a spacing below the bed
      walls.push_back(x);
    }
    auto const all = placed<Dim>(together<Dim>(material, walls), std::pow(0.1, Dim));
    std::string said;
    StartWords const words{.warn = [&](std::string const& text) { said += text; }};
    try {
      check_start(all, material.size(), 0.1, Dim, {}, words);
    } catch (std::invalid_argument const& error) {
      said += error.what();
    }
    return said;
  };
  CHECK(complaint_of(1, true) == "");
  CHECK(complaint_of(1, false) == "");
  for (double const apart : {2.0, 4.0, 5.0}) {
    INFO("floor of " << apart << " spacings");
    CHECK_THAT(complaint_of(apart, true), StartsWith("scree: warning: the particles of a wall are far apart"));
    CHECK_THAT(complaint_of(apart, false), ContainsSubstring("are too far apart"));
  }
}

TEST_CASE("the message on a wrong spacing has the median and a spacing that fits") {
  auto const message = complaint<2>(layer_of(20), {}, 0.08);
  // 0.8^2 is 0.64; the kernel of the smaller support sees the lattice as 1.018.
  CHECK_THAT(message, ContainsSubstring("scree: at the start the volumes of the particles fill 0.651") &&
                          ContainsSubstring("from 0.95 to 1.05 is allowed") &&
                          ContainsSubstring("is settings.spacing, 0.08 m, that of the particles? About 0.099") &&
                          ContainsSubstring("if this is meant, set `start_checks = false`"));
}

TEST_CASE("layers of one row and of more may start, free, on a wall, and around a period, with jitter") {
  auto const floor = fill_lattice(Box<2>{{-0.4, -0.4}, {4.4, 0}}, 0.1);
  for (int const rows : {1, 2, 3, 4, 5, 6})
    for (double const jittered : {0.0, 0.1, 0.2})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        INFO(rows << " rows, jitter " << jittered << ", seed " << seed);
        auto points = layer_of(rows);
        jitter(points, jittered * 0.1, seed);
        CHECK(complaint<2>(points, {}, 0.1) == "");
        CHECK(complaint<2>(points, {}, 0.1, {{0, 0, 4}}) == "");
        CHECK(complaint<2>(points, floor, 0.1) == "");
      }
}

TEST_CASE(
    "columns of a few spacings across may start, round and square, and so may the layer of an inlet of that width") {
  for (int const across : {1, 2, 3, 4, 5, 6, 8})
    for (bool const round : {false, true}) {
      INFO(across << " spacings across, " << (round ? "round" : "square"));
      double const width = 0.1 * across;
      auto const keep = [&](std::vector<Vec<3, double>> all) {
        if (round) std::erase_if(all, [&](auto const& x) { return std::hypot(x[0], x[1]) >= width / 2; });
        return all;
      };
      auto const points_in = [](Box<3> const& box) { return std::vector<Vec<3, double>>(fill_lattice(box, 0.1)); };
      Box<3> box{{-width / 2, -width / 2, 0}, {width / 2, width / 2, 1.2}};
      auto const column = keep(points_in(box));
      CHECK(complaint<3>(column, {}, 0.1) == "");
      if (across > 1) CHECK(complaint<3>(column, {}, 0.075) != "");
      box.high[2] = 0.1;
      CHECK_NOTHROW(detail::check_layer(Inlet<3>{.layer = keep(points_in(box)), .velocity = {0, 0, -1}}, 0.1));
      if (across > 1)
        CHECK_THROWS(detail::check_layer(Inlet<3>{.layer = keep(points_in(box)), .velocity = {0, 0, -1}}, 0.075));
    }
}

TEST_CASE("a layer in which no particle has others on all sides is judged by its nearest neighbours and volumes") {
  for (int const rows : {1, 2, 3}) {
    INFO(rows);
    CHECK(packing(placed<2>(layer_of(rows), 0.01), 0.1, 2).full == 0);
    CHECK_THAT(complaint<2>(layer_of(rows), {}, 0.08),
               ContainsSubstring("the nearest neighbour of a particle is 1.25 times settings.spacing, 0.08 m, away") &&
                   ContainsSubstring("a spacing of about 0.1 m would fit"));
    CHECK_THAT(complaint<2>(layer_of(rows), {}, 0.15),
               ContainsSubstring(rows < 3 ? "0.6667 times settings.spacing" : "times as dense"));
    for (double const share : {0.01, 0.7, 1.3})
      CHECK_THROWS_WITH(check(placed<2>(layer_of(rows), share * 0.01), {}, 0.1, 2, {}),
                        ContainsSubstring("times spacing^2 (median; from 0.75 to 1.25 is allowed)"));
    CHECK_NOTHROW(check(placed<2>(layer_of(rows), 0.8 * 0.01), {}, 0.1, 2, {}));
  }
}

TEST_CASE(
    "volumes may differ from those of the spacing by a quarter, and by more where the particles are as far apart") {
  auto const points = layer_of(10);
  for (double const share : {0.8, 0.96, 1.04, 1.2})
    CHECK_NOTHROW(check(placed<2>(points, share * 0.01), {}, 0.1, 2, {}));
  CHECK_THROWS_WITH(check(placed<2>(points, 0.01 * 0.01), {}, 0.1, 2, {}), ContainsSubstring("volumes are too small"));
  CHECK_THROWS_WITH(check(placed<2>(points, 1.3 * 0.01), {}, 0.1, 2, {}), ContainsSubstring("volumes are too large"));
  // Finer particles with their own volumes next to coarser ones.
  auto both = placed<2>(layer_of(10), 0.01);
  auto const fine = placed<2>(fill_lattice(Box<2>{{4, 0}, {8, 1}}, 0.07), 0.0049);
  both.places.insert(both.places.end(), fine.places.begin(), fine.places.end());
  both.volumes.insert(both.volumes.end(), fine.volumes.begin(), fine.volumes.end());
  CHECK_NOTHROW(check(both, {}, 0.1, 2, {}));
}

TEST_CASE("grains keep their volume if that is not what they take at a start, and lose it where they spread") {
  for (double const share : {0.76, 0.8, 1.0, 1.2}) {
    auto const packed = [&](double apart) {
      auto const points = fill_lattice(Box<2>{{0, 0}, {3 * apart, 3 * apart}}, 0.1 * apart);
      return packing(placed<2>(points, share * 0.01), 0.1, 2);
    };
    INFO("volumes of " << share << " spacing^2");
    CHECK(packed(1).may_start());
    CHECK(packed(1).keeps_volume());
    CHECK_FALSE(packed(1.2).keeps_volume());
    if (share >= 1) CHECK_FALSE(packed(0.9).keeps_volume());
  }
}

TEST_CASE("the median over ranks is that of all particles together") {
  auto const particles = placed<2>(layer_of(10), 0.009);
  auto const alone = packing(particles, 0.1, 2);
  auto const doubled = packing_of(particles, particles.places.size(), 0.1, 2, {}, {0, [](long x) { return 2 * x; }});
  CHECK(doubled.full == 2 * alone.full);
  CHECK(doubled.density == alone.density);
  CHECK(std::abs(alone.density - 0.9 * 1.0051) < 1e-4);  // 1.0051: the sum of the kernel over a square lattice
}

}  // namespace scree::test::start_tests
