// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/rigid/measured_mass.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/wall_loads.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

// Rigid bodies and grains.
namespace scree::test::on_sand_tests {
using namespace fields;
namespace {

struct Block : RigidBody {
  static constexpr std::string_view name = "block";
};
template <class Q, class Integrator = Midpoint>
struct Sand : Formulated<Q, Granular<>> {
  using bodies = Bodies<Material, Block>;
  using integrator = Integrator;
  using diagnostics = WallForces;
};
constexpr double dr = 0.1;
Granular<> sand(double gravity) {
  Granular<> physics;
  physics.law.elastic = {1e5, 0.3, 1500};
  physics.law.grains = {0.01};
  physics.gravity = {gravity};
  return physics;
}
/// A block within a lump of sand that moves and is under stress.
template <class F>
Solver<F> lump() {
  constexpr int dim = F::dim;
  using real = typename F::real;
  using X = Vec<dim, double>;
  Box<dim> const block{X::Constant(2 * dr), X::Constant(5 * dr)};
  Groups<dim> blocks;
  blocks.add("block", fill_lattice(block, dr));
  Points<dim> grains;
  for (auto const& x : fill_lattice(Box<dim>{X::Zero(), X::Constant(8 * dr)}, dr))
    if (!block.contains(x)) grains.push_back(x);
  Rigid<dim> body;
  body.properties = mass_properties(block, 2500, dr);
  body.velocity[0] = 0.1;
  body.angular_velocity[0] = 0.5;
  Solver<F> solver({.spacing = dr, .physics = sand(0), .rigid = {.bodies = {body}}, .lost_share = 1},
                   particles_of<Material>(cast<real>(grains)), particles_of<Block>(blocks));
  solver.set(velocity, [](auto const& x) {
    auto u = (x * real(-0.2)).eval();
    u[0] += real(0.3) * x[dim - 1];
    return u;
  });
  solver.set(stress, [](auto const& x) {
    value_t<F, Stress> s = value_t<F, Stress>::Zero();
    for (int k = 0; k < 3; ++k) s[k] = real(-300) * (1 + x[0] + x[1]);
    return s;
  });
  return solver;
}
template <class S>
auto momentum(S const& solver) {
  constexpr int dim = S::policy::dim;
  Vec<dim, double> sum = Vec<dim, double>::Zero();
  for (auto const& u : solver.material().to_host(velocity)) sum += 1500 * std::pow(dr, dim) * u.template cast<double>();
  auto const& states = solver.template body<RigidStates>();
  return std::pair(
      sum, Vec<dim, double>(states.to_host(rigid_velocity)[0] * solver.settings().rigid.bodies[0].properties.mass));
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a rigid body and the grains around it keep their momentum together", "", Policies) {
  using Q = TestType;
  auto const check = [](auto solver) {
    auto const [grains, block] = momentum(solver);
    for (int k = 0; k < 40; ++k) solver.step(1);
    auto const [grains_after, block_after] = momentum(solver);
    double const exchanged = (block_after - block).norm(), all = (grains_after + block_after - grains - block).norm();
    INFO("exchanged " << exchanged << ", change of the sum " << all);
    CHECK(exchanged > 0.03 * block.norm());
    CHECK(all < ulps<Q>(100) * (grains.norm() + block.norm()));
    auto const L = solver.template body<RigidStates>().to_host(angular_momentum)[0];
    CHECK(L.norm() > 0);
  };
  check(lump<Sand<Q>>());
  if constexpr (Q::dim == 2) check(lump<Sand<Q, SymplecticEuler>>()), check(lump<Sand<Q, VelocityVerlet>>());
}

TEMPLATE_LIST_TEST_CASE("force and moment on a rigid body are the sums over its particles", "", Policies) {
  using Q = TestType;
  constexpr int dim = Q::dim;
  auto solver = lump<Sand<Q>>();
  for (int k = 0; k < 10; ++k) solver.step(1);
  solver.update_rates();
  auto const& block = solver.template body<Block>();
  auto const x = block.to_host(position), F = block.to_host(wall_force);
  auto const& states = solver.template body<RigidStates>();
  WallLoad<dim> load;
  for (std::size_t k = 0; k < x.size(); ++k)
    load.add(F[k].template cast<double>(), x[k].template cast<double>() - states.to_host(rigid_centre)[0],
             Vec<dim, double>::Zero());
  Turn<dim> moment;
  if constexpr (dim == 2)
    moment[0] = load.moment;
  else
    moment = load.moment;
  CHECK(load.force.norm() > 1);
  CHECK((states.to_host(rigid_force)[0] - load.force).norm() < 1e-12 * load.force.norm());
  CHECK(moment.norm() > 0.01);
  CHECK((states.to_host(rigid_moment)[0] - moment).norm() < 1e-11 * moment.norm());
}

TEMPLATE_TEST_CASE("a rigid body on grains goes on from a snapshot bit for bit", "", Midpoint, SymplecticEuler,
                   VelocityVerlet) {
  using F = Sand<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, TestType>;
  auto before = lump<F>(), after = lump<F>();
  for (int k = 0; k < 20; ++k) before.step(1);
  after.restore(before.snapshot());
  for (int k = 0; k < 40; ++k) before.step(1), after.step(1);
  CHECK(before.time() == after.time());
  CHECK(before.material().to_host(position) == after.material().to_host(position));
  CHECK(before.material().to_host(stress) == after.material().to_host(stress));
  auto const &a = before.template body<RigidStates>(), &b = after.template body<RigidStates>();
  CHECK(a.to_host(rigid_centre) == b.to_host(rigid_centre));
  CHECK(a.to_host(angular_momentum) == b.to_host(angular_momentum));
  CHECK(a.to_host(rigid_force) == b.to_host(rigid_force));
  CHECK(before.template body<Block>().to_host(velocity) == after.template body<Block>().to_host(velocity));
}

TEST_CASE("a block at rest on sand bears its weight on the grains and neither sinks nor drifts") {
  struct Bed : Formulation<2> {
    using space = Kokkos::DefaultHostExecutionSpace;
    using physics = Granular<>;
    using bodies = Bodies<Material, Wall, Block>;
    using integrator = SymplecticEuler;
  };
  double const h = 0.02;
  Box<2> const box{{0, 0}, {0.6, 0.2}}, block{{0.2, 0.2}, {0.4, 0.3}};
  Box<2> const open{{0, 0}, {0.6, 0.5}}, outer{{-3 * h, -3 * h}, {0.6 + 3 * h, 0.5}};
  Granular<> physics = sand(9.81);
  physics.law.elastic.young = 1e6;
  physics.law.grains = {1e-3};
  Groups<2> blocks;
  blocks.add("block", fill_lattice(block, h));
  Rigid<2> body;
  body.properties = mass_properties(block, 1200, h);
  Solver<Bed> solver({.spacing = h, .physics = physics, .rigid = {.bodies = {body}}},
                     particles_of<Material>(fill_lattice(box, h)), particles_of<Wall>(fill_between(open, outer, h)),
                     particles_of<Block>(blocks));
  solver.set(stress, [](auto const& x) {
    double const weight = std::abs(x[0] - 0.3) < 0.1 ? 1200 * 9.81 * 0.1 : 0, p = 1500 * 9.81 * (0.2 - x[1]) + weight;
    return Vec<4, double>(-0.6 * p, -p, -0.6 * p, 0);
  });
  auto const& states = solver.body<RigidStates>();
  solver.run(2.0);
  auto const x0 = states.to_host(rigid_centre)[0];
  double const angle0 = states.to_host(rigid_attitude)[0][0];
  double force = 0;
  long number = 0;
  solver.run(3.0, {}, [&](auto const& now) {
    if (now.steps() % 10 == 0) force += states.to_host(rigid_force)[0][1], ++number;
    return false;
  });
  auto const x = states.to_host(rigid_centre)[0];
  INFO("moved by " << x[0] - x0[0] << ", " << x[1] - x0[1] << " m, turned by "
                   << states.to_host(rigid_attitude)[0][0] - angle0 << " in 1 s; force over weight "
                   << force / double(number) / (body.properties.mass * 9.81) << ", settled to " << x0[1]);
  CHECK(std::abs(force / double(number) / (body.properties.mass * 9.81) - 1) < 5e-3);
  CHECK((x - x0).norm() < 1e-5);
  CHECK(std::abs(states.to_host(rigid_attitude)[0][0] - angle0) < 1e-4);
}

}  // namespace scree::test::on_sand_tests
