// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/boundaries/plates.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/solver/set_group.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/wall_loads.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

// Sand at rest on one side or on both sides of a smooth upright plate in a box. Its stress next to the plate is that of
// its own depth, whatever there is on the other side.
namespace scree::test::plate::thin_plate_tests {
namespace {

using X = Vec<2, double>;
double const dr = 1e-3, K0 = 0.6;
int const across = 15, high = 20;

template <class Scheme>
struct Models : GranularModels {
  using walls = Scheme;
};
template <class Scheme>
struct Divided : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models<Scheme>>;
  using diagnostics = WallForces;
};

struct Case {
  int rows = 3;    ///< of the plate
  int right = 10;  ///< rows of sand on the right; 20 on the left
  long steps = 1000;
  bool checked = false;  ///< before the run
};
struct Found {
  double left = 0, right = 0;  ///< rms error of sigma_xx next to the plate over K0 rho g H, -
  double thrust = 0;           ///< on the plate over that of both sides, -
  double speed = 0;            ///< m/s
  int through = 0;             ///< particles on the wrong side
  Packing packing = {};
};

template <class Scheme>
Found found(Case const& c) {
  using namespace fields;
  double const side = across * dr, thick = c.rows * dr, far = 2 * side + thick, top = (high + 5) * dr;
  Groups<2> walls;
  walls.add("floor", fill_lattice(Box<2>{{-3 * dr, -3 * dr}, {far + 3 * dr, 0}}, dr));
  walls.add("left", fill_lattice(Box<2>{{-3 * dr, 0}, {0, top}}, dr));
  walls.add("right", fill_lattice(Box<2>{{far, 0}, {far + 3 * dr, top}}, dr));
  walls.add("plate", fill_lattice(Box<2>{{side, 0}, {side + thick, top}}, dr));
  Groups<2> sand;
  sand.add("left", fill_lattice(Box<2>{{0, 0}, {side, high * dr}}, dr));
  sand.add("right", c.right > 0 ? fill_lattice(Box<2>{{side + thick, 0}, {far, c.right * dr}}, dr) : std::vector<X>{});
  typename Divided<Scheme>::physics physics;
  physics.law = beads(10);
  physics.viscosity_speed = 1;
  Solver<Divided<Scheme>> solver({.spacing = dr, .physics = physics, .start_checks = c.checked}, sand, walls);
  if constexpr (std::is_same_v<Scheme, PlateWalls>)
    set_group<Wall>(solver, on_plate, walls, "plate", [](X const&) { return 1; });
  for (char const* name : {"left", "right", "plate"}) set_slip(solver, walls, name, X(1, 0));
  double const q = bed_density * g;
  auto const depth = [&](X const& x, bool left) { return (left ? high : c.right) * dr - x[1]; };
  auto const is_left = [&](int number) { return sand.range("left").contains(number); };
  auto const numbers = solver.material().to_host(identity);
  auto const x0 = solver.material().to_host(position);
  std::vector<Vec<4, double>> start(x0.size());
  for (std::size_t i = 0; i < x0.size(); ++i) {
    double const p = q * depth(x0[i], is_left(numbers[i]));
    start[i] = Vec<4, double>(-K0 * p, -p, -K0 * p, 0);
  }
  solver.set(stress, start, [](auto const& s) { return s; });
  for (long n = 0; n < c.steps; ++n) solver.step(1);
  Found f;
  auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  auto const who = solver.material().to_host(identity);
  double sums[2] = {}, counts[2] = {};
  for (std::size_t i = 0; i < x.size(); ++i) {
    bool const left = is_left(who[i]);
    f.through += left ? x[i][0] > side + thick / 2 : x[i][0] < side + thick / 2;
    f.speed = std::max(f.speed, u[i].norm());
    double const off = left ? side - x[i][0] : x[i][0] - side - thick;
    if (off > 3 * dr || x[i][1] < 3 * dr) continue;
    sums[left] += sq((sigma[i][0] + K0 * q * depth(x[i], left)) / (K0 * q * high * dr)), ++counts[left];
  }
  f.left = std::sqrt(sums[1] / counts[1]), f.right = counts[0] > 0 ? std::sqrt(sums[0] / counts[0]) : 0;
  double const exact = K0 * q * (sq(high * dr) - sq(c.right * dr)) / 2;
  f.thrust = wall_load(solver, walls, "plate").force[0] / exact;
  f.packing = solver.packing();
  return f;
}

/// Names of the faults; "" if there are none. Next to thick plates the errors are below 0.011 and the thrust is 0.975.
std::string faults_of(Found const& f) {
  UNSCOPED_INFO("left " << f.left << ", right " << f.right << ", thrust " << f.thrust << ", speed " << f.speed
                        << " m/s, packing " << f.packing.text());
  std::string found;
  if (!(f.left < 0.02 && f.right < 0.02)) found += "stress ";
  if (!(std::abs(f.thrust - 1) < 0.03)) found += "thrust ";
  if (!(f.speed < 2e-4)) found += "speed ";
  if (f.through > 0) found += "through ";
  if (!is_packed_as_at_rest(f.packing)) found += "packing ";
  return found;
}

}  // namespace

TEST_CASE("sand next to a plate of two rows or more feels its own side only") {
  auto const alone = found<PlateWalls>({.rows = 6, .right = 0});
  for (int const rows : {2, 3, 4})
    for (int const right : {0, 10, 18}) {
      INFO(rows << " rows, " << right << " rows of sand on the right");
      auto const f = found<PlateWalls>({.rows = rows, .right = right});
      CHECK(faults_of(f) == "");
      CHECK(std::abs(f.left - alone.left) < 1e-4);
    }
}
TEST_CASE("walls that extrapolate need four rows between sand on both sides") {
  CHECK(faults_of(found<AdamiWalls>({.rows = 4})) == "");
  CHECK(faults_of(found<AdamiWalls>({.rows = 3})) == "stress ");
  CHECK(faults_of(found<AdamiWalls>({.rows = 2})) == "stress thrust speed ");
  CHECK(faults_of(found<AdamiWalls>({.rows = 2, .right = 0})) == "");
}
TEST_CASE("a plate of one row does not part the sand on both sides") {
  CHECK(faults_of(found<PlateWalls>({.rows = 1})) != "");
  CHECK(faults_of(found<PlateWalls>({.rows = 1, .right = 0})) != "");
}

// The same cases, by what a solver says about them.
TEST_CASE("a wall too thin for sand on both sides is refused at the start") {
  auto const refused = [](std::string const& what) {
    return Catch::Matchers::MessageMatches(Catch::Matchers::ContainsSubstring(what));
  };
  Case const rows_4{.rows = 4, .steps = 1, .checked = true};
  Case const rows_3{.rows = 3, .steps = 1, .checked = true};
  Case const rows_2{.rows = 2, .steps = 1, .checked = true};
  Case const rows_1{.rows = 1, .steps = 1, .checked = true};
  Case const one_side{.rows = 1, .right = 0, .steps = 1, .checked = true};
  CHECK_NOTHROW(found<AdamiWalls>(rows_4));
  CHECK_THROWS_MATCHES(found<AdamiWalls>(rows_3), std::invalid_argument, refused("3 spacings apart"));
  CHECK_THROWS_MATCHES(found<AdamiWalls>(rows_2), std::invalid_argument, refused("2 spacings apart"));
  CHECK_THROWS_MATCHES(found<AdamiWalls>(one_side), std::invalid_argument, refused("one row"));
  CHECK_NOTHROW(found<PlateWalls>(rows_2));
  CHECK_THROWS_MATCHES(found<PlateWalls>(rows_1), std::invalid_argument, refused("through a plate of 1 spacings"));
  CHECK_THROWS_MATCHES(found<PlateWalls>(one_side), std::invalid_argument, refused("one row"));
}

// A wall of three rows has sand on the left; then on the right too.
TEST_CASE("a run stops when grains have come to the other side of a thin wall") {
  struct Filled : Formulation<2> {
    using space = Kokkos::DefaultHostExecutionSpace;
    using physics = Granular<>;
  };
  double const side = 12 * dr, thick = 3 * dr, far = 2 * side + thick, top = 40 * dr;
  std::vector<X> walls;
  for (auto const& box : {Box<2>{{-3 * dr, -3 * dr}, {far + 3 * dr, 0}}, Box<2>{{-3 * dr, 0}, {0, top}},
                          Box<2>{{far, 0}, {far + 3 * dr, top}}, Box<2>{{side, 0}, {side + thick, 20 * dr}}})
    for (auto const& x : fill_lattice(box, dr)) walls.push_back(x);
  auto const bed = [&](double from) { return fill_lattice(Box<2>{{from, 0}, {from + side, 15 * dr}}, dr); };
  Filled::physics physics;
  physics.law = beads(10);
  physics.cfl = 0.3;
  Solver<Filled> solver({.spacing = dr, .physics = physics}, bed(0), walls);
  solver.run(0.001);
  solver.add(bed(side + thick));
  CHECK_THROWS_AS(solver.run(0.1), OutsideValidity);
  CHECK(solver.steps() < 600);
}

}  // namespace scree::test::plate::thin_plate_tests
