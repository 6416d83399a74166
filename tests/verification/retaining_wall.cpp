// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "soil.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>
#include <vector>

// A smooth wall retains sand with a smooth floor. Pushed in or drawn back, it meets the thrust of Rankine (1857), K
// times the vertical stress of the sand along the wall, K_p = (1 + sin phi)/(1 - sin phi) or K_a = 1/K_p. This is exact
// for associated flow, psi = phi. The sand that the wall has pushed together is up to 3 % deeper there than at the
// start.
namespace scree::test::soil::retaining_wall_tests {
namespace {

double const height = 1, rho = 1600, phi = degrees(30);  // m, kg/m^3, rad

Case sand(Cone<double> const& cone, double inwards, int high = 20) {
  double const dr = height / high, t = rows * dr, wide = 3 * height;
  Case now{.spacing = dr, .soil = {{0, 0}, {wide, height}}, .gravity = g};
  now.walls.add("moving", fill_lattice(Box<2>{{-t, 0}, {0, height + 6 * t}}, dr));
  now.walls.add("floor", fill_lattice(Box<2>{{-2 * t, -t}, {wide + t, 0}}, dr));
  now.walls.add("side", fill_lattice(Box<2>{{wide, 0}, {wide + t, height + t}}, dr));
  now.law = {.elastic = {.young = 1000 * rho * g * height, .poisson = 0.3, .rest_density = rho}, .cone = cone};
  now.push = {.direction = X(inwards, 0), .speed = 0.02, .rise = 0.3};
  return now;
}
struct Pushed {
  double K;        ///< from the mean thrust on the last fifth of the wall's way, over its load at that time
  double K_start;  ///< the same over the load at the start, rho g H^2/2
  Packing packing;
};
/// The integral over the height of the vertical stress at the wall, N/m, from the weight of the grains that start in
/// the first three columns. Their width follows from their mean distance.
template <class S>
double load_along(S const& solver, std::vector<X> const& start, double wall_at) {
  auto const x = solver.material().to_host(fields::position);
  double const dr = solver.resolution().spacing;
  double distance = 0, moment = 0, grains = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (start[i][0] > 3 * dr) continue;
    distance += x[i][0] - wall_at, moment += rho * g * sq(dr) * x[i][1], grains += 1;
  }
  return moment / (2 * distance / grains);
}
/// The wall goes a way (m).
Pushed pushed(Case const& of, double distance) {
  auto solver = of.solver();
  set_slip(solver, of.walls, "moving", X(1, 0));
  set_slip(solver, of.walls, "side", X(-1, 0));
  set_slip(solver, of.walls, "floor", X(0, 1));
  Geostatic const at_rest{height, rho, g, 0.5};
  solver.set(fields::stress, [&](auto const& x) { return packed_stress<2>(at_rest, x); });
  auto const start = solver.material().to_host(fields::position);
  double const at_start = load_along(solver, start, 0);
  double const thrust = std::abs(resistance(of, solver, distance)), moved = of.push.distance(solver.time());
  // The load grows evenly over the last fifth of the way, in the mean of which the wall is at nine tenths.
  double const at_end = load_along(solver, start, moved * of.push.direction[0]);
  double const load = at_start + 0.9 * (at_end - at_start);
  return {thrust / load, thrust / at_start, solver.packing()};
}
/// `high`: spacings over the height.
Pushed passive(Cone<double> const& cone, int high = 20) { return pushed(sand(cone, 1, high), 0.025 * height); }
Pushed active(Cone<double> const& cone, int high = 20) { return pushed(sand(cone, -1, high), 0.01 * height); }
MohrCoulomb const associated{.friction_angle = phi, .dilatancy_angle = phi};

}  // namespace

TEST_CASE("a smooth wall pushed into sand meets Rankine's passive thrust", "[verification]") {
  auto const [K, K_start, packing] = passive(plane_strain_cone(associated));
  CAPTURE(K, K_start, packing.text());
  CHECK(std::abs(K / 3 - 1) < 0.03);
  CHECK(std::abs(K_start / 3 - 1) < 0.05);
  CHECK(is_packed_as_at_rest(packing));  // the wedge that dilates is less than half of the sand
}

TEST_CASE("a smooth wall drawn back from sand meets Rankine's active thrust", "[verification]") {
  auto const [K, K_start, packing] = active(plane_strain_cone(associated));
  CAPTURE(K, K_start, packing.text());
  CHECK(std::abs(K * 3 - 1) < 0.03);
  CHECK(std::abs(K_start * 3 - 1) < 0.03);
  CHECK(is_packed_as_at_rest(packing));
}

TEST_CASE("Rankine's thrusts at four angles of friction and 40 spacings", "[.long]") {
  for (double const degree : {25.0, 30.0, 35.0, 40.0}) {
    double const angle = degrees(degree), Kp = sq(std::tan(std::numbers::pi / 4 + angle / 2));
    auto const cone = plane_strain_cone({.friction_angle = angle, .dilatancy_angle = angle});
    auto const pushed_in = passive(cone, 40), drawn_back = active(cone, 40);
    INFO(degree << " degrees: passive " << pushed_in.K / Kp << ", active " << drawn_back.K * Kp << " of Rankine's");
    CHECK(std::abs(pushed_in.K / Kp - 1) < 0.03);
    CHECK(std::abs(drawn_back.K * Kp - 1) < 0.03);
  }
}

TEST_CASE("control: the cone of triaxial compression misses Rankine's thrusts", "[verification]") {
  int const high = 12;  // the right cone gives 3.12 and 0.333 with it, within the bars
  CHECK(passive(compression_cone(associated), high).K > 3.5);
  CHECK(active(compression_cone(associated), high).K < 0.29);
}

TEST_CASE("isochoric flow keeps the passive thrust between those of Davis and Rankine", "[verification]") {
  auto const [K, K_start, packing] = passive(plane_strain_cone({.friction_angle = phi}));
  double const mu = std::sin(phi), davis = sq(mu + std::sqrt(1 + sq(mu)));  // tan phi* = sin phi (Davis 1968)
  CAPTURE(K, K_start, davis, packing.text());
  CHECK((K > davis && K < 3));
  CHECK(is_packed_as_at_rest(packing));
}

}  // namespace scree::test::soil::retaining_wall_tests
