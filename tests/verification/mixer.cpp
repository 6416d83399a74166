// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/granular/wall_forces.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/wall_loads.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

// A vessel that turns one way, with a blade that turns the other.
namespace scree::test::mixer {
namespace {

using X = Vec<2, double>;
using Motion = MotionOfGroups<2, Rotation>;

struct Mixer : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  using motion = Motion;
  using diagnostics = WallForces;
};

double const dr = 2.5e-3, radius = 0.05;                      // m
double const of_vessel = 3, of_blade = -5;                    // rad/s
scree::Box<2> const bar{{-0.025, -2 * dr}, {0.025, 2 * dr}};  // thicker than a support

Groups<2> walls() {
  return Groups<2>().add("vessel", wall_rings(Ball<2>{{0, 0}, radius}, dr, 4)).add("blade", fill_lattice(bar, dr));
}
/// The bed covers the blade.
std::vector<X> bed() {
  std::vector<X> points;
  for (X const& x :
       fill_rings(Ball<2>{{0, 0}, radius}, dr, HalfSpace<2>{.point = X(0, 0.03), .normal = X(0, 1)}).points)
    if (!(std::abs(x[0]) < bar.high[0] + dr / 2 && std::abs(x[1]) < bar.high[1] + dr / 2)) points.push_back(x);
  return points;
}
Solver<Mixer> turning() {
  auto const wall = walls();
  Motion motion(wall);
  motion.set(wall.number("vessel"), Rotation{.rate = of_vessel}).set(wall.number("blade"), Rotation{.rate = of_blade});
  Granular<> physics;
  physics.law.elastic = {1e5, poisson, bed_density};
  physics.law.grains = {0.5e-3};
  Solver<Mixer> solver({.spacing = dr, .physics = physics, .motion = motion}, bed(), wall);
  solver.set(fields::stress, [](X const& x) { return packed_stress(Geostatic{0.03, bed_density, g, 1}, x); });
  return solver;
}

double turned(X const& a, X const& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Sums over the bed, per m of depth: its angular momentum about the axis, the rate of that and the torque of its
/// weight.
struct Balance {
  double angular_momentum = 0, rate = 0, of_weight = 0;
};
Balance balance_of(Solver<Mixer>& solver) {
  using namespace fields;
  solver.update_rates();
  auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity),
             a = solver.material().to_host(acceleration);
  auto const V = solver.material().to_host(volume);
  Balance sum;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const m = bed_density * V[i];
    sum.angular_momentum += m * turned(x[i], u[i]);
    sum.rate += m * turned(x[i], a[i]);
    sum.of_weight += m * turned(x[i], X(0, -g));
  }
  return sum;
}

}  // namespace

TEST_CASE("a blade turns one way in a vessel that turns the other, and the torques on both balance the bed") {
  using namespace fields;
  auto const wall = walls();
  auto solver = turning();
  auto const rest = solver.wall().to_host(position);
  double const start = balance_of(solver).angular_momentum;
  double sampled = 0, impulse = 0, torques = 0, gaps = 0, rates = 0;  // the first is a time, s
  while (solver.time() < 0.2) {
    solver.step(1);
    if (solver.steps() % 5 != 0) continue;
    auto const bed = balance_of(solver);
    auto const loads = wall_loads(solver, wall);
    auto const &vessel = loads[0], &blade = loads[1];
    double const dt = solver.time() - sampled, sum = bed.of_weight - vessel.moment - blade.moment;
    sampled = solver.time();
    impulse += dt * sum, torques += dt * (std::abs(vessel.moment) + std::abs(blade.moment));
    gaps += dt * std::abs(bed.rate - sum), rates += dt * std::abs(bed.rate);
    // Both work against the bed.
    REQUIRE((vessel.moment < 0 && blade.moment > 0));
    REQUIRE(std::abs(vessel.power / (of_vessel * vessel.moment) - 1) < 1e-9);
    REQUIRE(std::abs(blade.power / (of_blade * blade.moment) - 1) < 1e-9);
  }
  double const change = balance_of(solver).angular_momentum - start;
  INFO("torques " << torques << ", change of angular momentum " << change << " against " << impulse << ", gaps " << gaps
                  << ", rates " << rates << " N m s/m");
  show_packing(solver);
  CHECK(torques > 0.3);
  CHECK(rates > 5 * gaps);
  // Forces act along sigma x_ij, not along x_ij, so that pairs have a moment of their own: measured 1 % of the torques.
  CHECK(gaps < 0.02 * torques);
  CHECK(std::abs(change - impulse) < 0.02 * torques);

  auto const now = solver.wall().to_host(position);
  double worst = 0;
  for (int w = 0; w < solver.wall().size(); ++w) {
    auto const k = static_cast<std::size_t>(w);
    double const angle = solver.time() * (wall.range("blade").contains(w) ? of_blade : of_vessel);
    X const expected(std::cos(angle) * rest[k][0] - std::sin(angle) * rest[k][1],
                     std::sin(angle) * rest[k][0] + std::cos(angle) * rest[k][1]);
    worst = std::max(worst, (now[k] - expected).norm());
  }
  CHECK(worst < 1e-15);
}

}  // namespace scree::test::mixer
