// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/forces.hpp>

#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>

namespace scree::test::forces_tests {
using namespace fields;
namespace {

/// -k u, a force of a user.
struct Drag {
  double rate = 0;  // 1/s
  using reads = Fields<Velocity>;
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    return std::remove_cvref_t<decltype(i[velocity])>(-rate * i[velocity]);
  }
};
struct Free : GranularModels {
  using law = Elastic;
  using filter = NoFilter;
};
struct Dragged : Free {
  using forces = std::tuple<Drag>;
};
struct Repelled : Free {
  using forces = std::tuple<TensileRepulsion>;
};
struct Mixed : Free {
  using advection = Xsph;
};

template <class Models, class Integrator = Midpoint>
struct Block : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models>;
  using integrator = Integrator;
};
double const spacing = 0.1;
template <class P>
Solver<P> block(typename P::physics physics) {
  physics.law = {1e5, 0.3, 1500};
  Solver<P> solver({.spacing = spacing, .physics = physics}, fill_lattice(Box<2>{{0, 0}, {1, 1}}, spacing));
  solver.set(stress, [](auto const&) { return Vec<4, double>(0, 0, 0, 0); });
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0, 0); });
  return solver;
}

}  // namespace

TEST_CASE("a block falls with drag as a point does") {
  double const rate = 5, end = 0.4;
  auto solver = block<Block<Dragged>>({.forces = {Drag{rate}}});
  solver.run(end);
  double const expected = -9.81 / rate * (1 - std::exp(-rate * end));
  for (auto const& u : solver.material().to_host(velocity)) {
    CHECK(std::abs(u[1] / expected - 1) < 1e-4);
    CHECK(std::abs(u[0]) < 1e-10);
  }
}

TEST_CASE("the repulsion of particles in tension is the sum of its terms") {
  auto with = block<Block<Repelled>>({.gravity = {0}, .forces = {TensileRepulsion{0.4}}}),
       without = block<Block<Repelled>>({.gravity = {0}, .forces = {TensileRepulsion{0}}});
  for (auto* solver : {&with, &without})
    solver->set(stress, [](auto const& x) { return Vec<4, double>(100 * x[0], -50 * x[1], 10, 20 * x[0]); });
  with.update_rates(), without.update_rates();
  auto const a = with.material().to_host(acceleration), b = without.material().to_host(acceleration);
  auto const x = with.material().to_host(position);
  // By hand, for the particle in the middle of a row.
  auto const R = [&](Vec<2, double> const& at) {
    StressTensor<double> sigma = unpacked(Vec<4, double>(100 * at[0], -50 * at[1], 0, 20 * at[0]));
    return Mat<3, double>(positive_part(sigma) * (-0.4 / sq(1500.0)));
  };
  KernelFunction<WendlandC2, 2, double> const W(1.5 * spacing);
  double worst = 0, size = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Vec<2, double> sum(0, 0);
    for (std::size_t j = 0; j < x.size(); ++j) {
      Vec<2, double> const r = x[i] - x[j];
      if (i == j || r.norm() >= W.radius()) continue;
      double const f = W.value(r.norm()) / W.value(spacing);
      Mat<3, double> const both = R(x[i]) + R(x[j]);
      sum += 1500 * sq(spacing) * std::pow(f, 4) * W.slope_over_distance(r.norm()) *
             Vec<2, double>(both.topLeftCorner<2, 2>() * r);
    }
    worst = std::max(worst, (a[i] - b[i] - sum).norm()), size = std::max(size, sum.norm());
  }
  CHECK(size > 0.01);
  CHECK(worst < 1e-12 * size);
}

TEMPLATE_TEST_CASE("with XSPH particles move with the mixed velocity and keep momentum", "", Midpoint,
                   SymplecticEuler) {
  auto const wavy = [](auto const& x) { return Vec<2, double>(std::sin(40 * x[0] * x[1]), std::cos(30 * x[0])); };
  auto solver = block<Block<Mixed, TestType>>({.gravity = {0}, .viscosity_speed = 0, .advection = {.epsilon = 0.5}});
  solver.set(velocity, wavy);
  auto const before = solver.material().to_host(position);
  double const dt = solver.step(1e-6);
  auto const after = solver.material().to_host(position);
  auto const u = solver.material().to_host(velocity), mixed = solver.material().to_host(transport_velocity);
  Vec<2, double> own(0, 0), moved(0, 0);
  double off = 0, apart = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    own += u[i], moved += (after[i] - before[i]) / dt;
    off = std::max(off, ((after[i] - before[i]) / dt - mixed[i]).norm());
    apart = std::max(apart, (u[i] - mixed[i]).norm());
  }
  CHECK(apart > 0.1);
  CHECK(off < 1e-6);
  CHECK((own - moved).norm() < 1e-6 * double(u.size()));
}

TEST_CASE("parameters of forces and of XSPH are checked") {
  using Catch::Matchers::ContainsSubstring;
  CHECK_THROWS_WITH((Granular<Repelled>{.law = {1e5, 0.3, 1500}, .forces = {TensileRepulsion{-1}}}.check()),
                    ContainsSubstring("epsilon (-) of TensileRepulsion"));
  CHECK_THROWS_WITH((Granular<Mixed>{.law = {1e5, 0.3, 1500}, .advection = {2}}.check()),
                    ContainsSubstring("epsilon (-) of Xsph"));
}

TEST_CASE("terms of forces are part of the one sweep for all rates") {
  auto const passes = rate_passes(Granular<Repelled>{.law = {1e5, 0.3, 1500}}, {});
  auto const labels = std::apply([](auto const&... each) { return std::array{std::string(each.label)...}; }, passes);
  CHECK(labels == std::array<std::string, 3>{"scree::wall_velocity+wall_stress", "scree::artificial_stress",
                                             "scree::strain_rates+acceleration"});
}

}  // namespace scree::test::forces_tests
