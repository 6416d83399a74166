// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/segregation/constant_closure.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <random>

namespace scree::test::wall_force_tests {
using namespace fields;
namespace {

template <class Walls>
struct Models : GranularModels {
  using filter = NoFilter;
  using walls = Walls;
};
template <class Walls>
using Mechanics = Granular<Models<Walls>>;
template <class Q, class Walls>
using Box = Formulated<Q, Mechanics<Walls>, Rotation, WallForces>;

double const spacing = 0.1, density = 1500;

template <class Walls>
Mechanics<Walls> mechanics() {
  Mechanics<Walls> physics;
  physics.law = {.elastic = {1e5, 0.3, density}, .grains = {0.01}};
  physics.viscosity_speed = 2;
  return physics;
}
/// A bed between rotating walls; its particles are disordered, each with its own stress and velocity.
template <class Q, class Walls>
Solver<Box<Q, Walls>> shaken() {
  constexpr int dim = Q::dim;
  using Real = typename Q::real;
  auto bed = open_bed<dim>(Vec<dim, double>::Constant(0.6), spacing);
  jitter(bed.material, 0.2 * spacing, 4);
  auto solver = solver_of<Box<Q, Walls>>(bed, spacing, mechanics<Walls>(), Rotation{.rate = 0.7});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  solver.set(velocity, [&](auto const&) {
    Vec<dim, Real> u;
    for (int a = 0; a < dim; ++a) u[a] = Real(uniform(random));
    return u;
  });
  solver.set(stress, [&](auto const&) {
    Vec<symmetric3_size<dim>, Real> sigma;
    for (int a = 0; a < sigma.size(); ++a) sigma[a] = Real(1e3 * (uniform(random) - (a < 3 ? 2 : 0)));
    return sigma;
  });
  solver.update_rates();
  solver.update_diagnostics();
  return solver;
}

using Schemes = std::tuple<AdamiWalls, MirrorWalls>;

template <class Q, class Walls>
void check_reaction() {
  auto const solver = shaken<Q, Walls>();
  auto const a = solver.material().to_host(acceleration);
  auto const forces = solver.wall().to_host(wall_force);
  using X = Vec<Q::dim, double>;
  double const m = density * std::pow(spacing, Q::dim);
  X on_material = X::Zero(), on_wall = X::Zero();
  double magnitude = 0, of_walls = 0;
  X const weight = m * Gravity{}.vector<X>();
  for (auto const& each : a) {
    X const force = m * each.template cast<double>() - weight;  // material against material cancels
    on_material += force, magnitude += force.norm();
  }
  for (auto const& each : forces)
    on_wall += each.template cast<double>(), of_walls += each.template cast<double>().norm();
  INFO("on the material " << on_material.transpose() << ", on the wall " << on_wall.transpose() << " N");
  // Every pair is rounded twice, some 30 pairs per particle.
  CHECK((on_material + on_wall).norm() < ulps<Q>(30) * magnitude);
  CHECK(on_wall.norm() > 0.01 * of_walls);
  CHECK(on_wall.norm() > 1000 * ulps<Q>(30) * magnitude);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the force on the wall is that on the material turned round", "", Policies) {
  check_reaction<TestType, AdamiWalls>();
  check_reaction<TestType, MirrorWalls>();
}

TEST_CASE("the force on one wall particle is that of its pairs") {
  using Q = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto const solver = shaken<Q, AdamiWalls>();
  auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  auto const y = solver.wall().to_host(position), seen = solver.wall().to_host(dummy_velocity);
  auto const tau = solver.wall().to_host(stress);
  auto const forces = solver.wall().to_host(wall_force);
  double const h = solver.resolution().smoothing_length, V = sq(spacing);
  KernelFunction<WendlandC2, 2, double> const W(h);
  double error = 0, largest = 0;
  for (std::size_t w = 0; w < y.size(); ++w) {
    Vec<2, double> expected = Vec<2, double>::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) {
      Vec<2, double> const r = x[i] - y[w];
      if (r.norm() >= W.radius()) continue;
      Vec<2, double> const gradient = W.slope_over_distance(r.norm()) * r;
      Vec<2, double> const traction = product(Vec<4, double>(sigma[i] + tau[w]), gradient);
      double const approach = std::min(0.0, (u[i] - seen[w]).dot(r));
      double const Pi = 2 * h / density * approach / (r.squaredNorm() + 0.01 * h * h);
      // (3.9) and (3.10) times m_i = rho V.
      expected -= V * V * (traction + sq(density) * Pi * gradient);
    }
    error = std::max(error, (forces[w] - expected).norm());
    largest = std::max(largest, expected.norm());
  }
  CHECK(largest > 10);
  CHECK(error < 1e-13 * largest);
}

TEMPLATE_LIST_TEST_CASE("a floor carries the weight of a bed at rest", "", Schemes) {
  using Q = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto solver = solver_of<Box<Q, TestType>>(layer({1, 0.6}, spacing), spacing, mechanics<TestType>(), {}, {{0, 0, 1}});
  solver.set(stress, [](auto const& x) {
    double const p = density * 9.81 * (0.6 - x[1]);
    return Vec<4, double>(-p / 2, -p, -p / 2, 0);
  });
  solver.update_diagnostics();
  Vec<2, double> sum = Vec<2, double>::Zero();
  for (auto const& each : solver.wall().to_host(wall_force)) sum += each;
  double const weight = density * 9.81 * 0.6;
  INFO("force " << sum.transpose() << " N, weight " << weight << " N");
  CHECK(std::abs(sum[0]) < 1e-12 * weight);
  // Sums for integrals at six rows.
  CHECK(std::abs(sum[1] / -weight - 1) < 0.02);
}

TEST_CASE("forces on walls are those of the mechanics where grains segregate, and leave the run as it is") {
  using Q = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  using Physics = SegregatingGranular<Mechanics<AdamiWalls>, ConservativeSegregation<ConstantClosure>>;
  auto const make = [] {
    auto solver = solver_of<Formulated<Q, Physics, Rotation, WallForces>>(
        open_bed<2>({0.6, 0.6}, spacing), spacing, {mechanics<AdamiWalls>(), {}}, Rotation{.rate = 0.7});
    solver.set(stress, [](auto const& x) { return Vec<4, double>(Vec<4, double>(-1e4, -1e4, -1e4, 0) * (1 - x[1])); });
    return solver;
  };
  auto watched = make(), alone = make();
  for (int k = 0; k < 20; ++k) {
    watched.update_diagnostics();
    watched.step(1);
    alone.step(1);
  }
  CHECK(watched.material().to_host(position) == alone.material().to_host(position));
  CHECK(watched.material().to_host(stress) == alone.material().to_host(stress));
  CHECK(watched.wall().to_host(wall_force).front().size() == 2);
}

}  // namespace scree::test::wall_force_tests
