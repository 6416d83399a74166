// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/terms/xsph.hpp>

#include <support/formulations.hpp>

#include "mechanics.hpp"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::xsph_tests {
using namespace fields;
namespace {

/// Free particles that move with the mixed velocity.
struct Mixing {
  static auto mix() {
    return std::tuple(
        pair_pass_then<Material>("mix", MixVelocity{0.5}, over<Material>(MeanVelocityDifference<>{{1000}})));
  }
  using moves = Fields<Evolves<Position, TransportVelocity>>;
  using evolves = Merge<moves, Fields<Velocity>>;
  auto passes(Resolution const&) const { return mix(); }
  auto stages(Resolution const&) const {
    return std::tuple(stage<Fields<Velocity>>(std::tuple<>()), stage<moves>(mix()));
  }
  auto limits(Resolution const&) const { return std::tuple(limit("step", 1e-3)); }
};
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using MixingByMidpoint = Formulated<OnHost, Mixing>;
struct MixingByEuler : MixingByMidpoint {
  using integrator = SymplecticEuler;
};
using Formulations = std::tuple<MixingByMidpoint, MixingByEuler>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("mixing velocities keeps momentum on disordered particles", "", Policies) {
  using P = TestType;
  auto body = disordered<P, TransportVelocity>();
  sum_over_itself_then(body, 0.2, MixVelocity{0.5}, MeanVelocityDifference<DensityOfParticle>{});
  auto const V = body.to_host(volume), rho = body.to_host(density);
  auto const u = body.to_host(velocity), mixed = body.to_host(transport_velocity);
  Vec<P::dim, double> difference = Vec<P::dim, double>::Zero();
  double sum = 0, squares = 0, mixed_squares = 0;
  for (std::size_t i = 0; i < V.size(); ++i) {
    double const m = double(V[i]) * double(rho[i]);
    difference += m * (mixed[i] - u[i]).template cast<double>();
    sum += m * double((mixed[i] - u[i]).norm());
    squares += m * double(u[i].squaredNorm()), mixed_squares += m * double(mixed[i].squaredNorm());
  }
  CHECK(difference.norm() < ulps<P>(10) * sum);
  CHECK(mixed_squares < 0.6 * squares);  // it is smoother
}

TEMPLATE_LIST_TEST_CASE("mixing leaves a uniform velocity as it is, to the last bit", "", DoublePolicies) {
  using P = TestType;
  auto body = disordered<P, TransportVelocity>();
  Vec<P::dim, double> const u = Vec<P::dim, double>::Constant(0.3);
  body.fill(velocity, u);
  sum_over_itself_then(body, 0.2, MixVelocity{1}, MeanVelocityDifference<DensityOfParticle>{});
  CHECK(largest_error(body, transport_velocity, 1, [&](auto const&) { return u; }) == 0);
}

TEMPLATE_LIST_TEST_CASE("positions move with the rate that a physics gives them", "", Formulations) {
  double const spacing = 0.125;
  auto const points = lattice<2>(spacing, 0.2);
  auto solver = solver_of<TestType>({points, {}}, spacing);
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(std::sin(40 * x[0]), std::cos(30 * x[1])); });
  auto const u = solver.material().to_host(velocity);
  solver.update_rates();
  auto const mixed = solver.material().to_host(transport_velocity);
  solver.step(1);
  auto const x = solver.material().to_host(position);
  double worst = 0, own = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst = std::max(worst, (x[i] - points[i] - 1e-3 * mixed[i]).norm());
    own = std::max(own, (x[i] - points[i] - 1e-3 * u[i]).norm());
  }
  CHECK(worst < 2e-5);  // the mixture itself changes over the step: dt^2
  CHECK(own > 2e-4);
  CHECK(solver.material().to_host(velocity) == u);
}

}  // namespace scree::test::xsph_tests
