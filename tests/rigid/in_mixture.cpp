// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/rigid/measured_mass.hpp>
#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/species_segregation.hpp>
#include <scree/setup/setup.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// A rigid body among grains whose species have densities of their own.
namespace scree::test::in_mixture_tests {
using namespace fields;
namespace {

struct Block : RigidBody {
  static constexpr std::string_view name = "block";
};
struct Models : GranularModels {
  using law = MixtureDensity<MuOfI<>, 2>;
};
struct Mixed : Formulation<2> {
  using physics = Combined<Granular<Models>, SpeciesSegregation<ConstantSpecies<2>>>;
  using bodies = Bodies<Material, Block>;
  using integrator = SymplecticEuler;
};
using X = Vec<2, double>;
X const densities(4000, 800);

struct Momentum {
  X grains = X::Zero(), body = X::Zero();
  double mass = 0;  // of all, kg
};
Momentum momentum_of(Solver<Mixed> const& solver) {
  Momentum sum;
  auto const u = solver.material().to_host(velocity), C = solver.material().to_host(concentrations<2>);
  auto const V = solver.material().to_host(volume);
  for (std::size_t i = 0; i < u.size(); ++i)
    sum.grains += V[i] * C[i].dot(densities) * u[i], sum.mass += V[i] * C[i].dot(densities);
  double const m = solver.settings().rigid.bodies[0].properties.mass;
  sum.body = m * solver.body<RigidStates>().to_host(rigid_velocity)[0];
  sum.mass += m;
  return sum;
}

}  // namespace

TEST_CASE("a rigid body and grains whose masses change keep their momentum together") {
  double const dr = 0.1;
  Box<2> const block{X::Constant(2 * dr), X::Constant(5 * dr)};
  Groups<2> blocks;
  blocks.add("block", fill_lattice(block, dr));
  Points<2> grains;
  for (auto const& x : fill_lattice(Box<2>{X::Zero(), X::Constant(8 * dr)}, dr))
    if (!block.contains(x)) grains.push_back(x);
  Rigid<2> body;
  body.properties = mass_properties(block, 2500, dr);
  body.velocity = {0.5, 1};
  SolverSettings<Mixed> settings{.spacing = dr, .rigid = {.bodies = {body}}, .lost_share = 1};
  settings.physics.mechanics.law = {{.elastic = {1e5, 0.3, 1500}, .grains = {0.01}}, densities};
  settings.physics.transport.closure = {.velocities = {1, 0}, .diffusivity = 0.02};
  Solver<Mixed> solver(settings, particles_of<Material>(grains), particles_of<Block>(blocks));
  solver.set(velocity, [](auto const& x) { return X(0.3 * x[1], -std::cos(5 * x[0])); });
  solver.set(stress, [](auto const& x) { return Vec<4, double>(-300, -300 * (1 + x[0]), -300, 0); });
  solver.set(concentrations<2>, [](auto const& x) {
    double const C = 0.5 + 0.3 * std::sin(6 * x[1]);
    return X(C, 1 - C);
  });
  auto const before = momentum_of(solver);
  auto const C = solver.material().to_host(concentrations<2>);
  for (int k = 0; k < 40; ++k) solver.step(1);
  auto const after = momentum_of(solver);
  double most = 0;
  auto const now = solver.material().to_host(concentrations<2>);
  for (std::size_t i = 0; i < C.size(); ++i)
    most = std::max(most, std::abs(now[i].dot(densities) / C[i].dot(densities) - 1));
  X const given = before.mass * solver.time() * X(0, -9.81);
  double const made = (after.grains + after.body - before.grains - before.body - given).norm();
  double const exchanged =
      (after.body - before.body - settings.rigid.bodies[0].properties.mass * solver.time() * X(0, -9.81)).norm();
  INFO("masses changed by up to " << most << ", exchanged " << exchanged << " kg m/s, made " << made);
  CHECK(most > 0.05);
  CHECK(exchanged > 0.03 * before.body.norm());
  CHECK(made < 1e-13 * before.body.norm());
}

}  // namespace scree::test::in_mixture_tests
