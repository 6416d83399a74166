// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "pendulum.hpp"

#include <scree/granular/granular.hpp>
#include <scree/laws/elastic.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// A free elastic block that oscillates along its length, without filter and without viscosity. The operators of strain
// and of force are adjoint, so that the sums over particles conserve the energy and only the integration in time can
// change it.
namespace scree::test::elastic_block_tests {
using namespace fields;
namespace {

struct Models : GranularModels {
  using law = Elastic;
  using filter = NoFilter;
};
using Block = Granular<Models>;
template <class Integrator>
using BlockWith = Integrated<Formulated<PendulumPolicy, Block>, Integrator>;

constexpr double rho = 1000;
Elastic const law{.young = 1e5, .poisson = 0.3, .rest_density = rho};

/// Kinetic and elastic energy, J/m: rho u^2/2 + p^2/(2 K) + s:s/(4 G), over all particles.
template <class S>
double energy_of(S const& solver) {
  auto const u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  auto const V = solver.material().to_host(volume);
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    StressTensor<double> const full = unpacked(sigma[i]);
    sum += V[i] * (rho * u[i].squaredNorm() / 2 + sq(pressure_of(full)) / (2 * law.bulk_modulus()) +
                   deviator_of(full).squaredNorm() / (4 * law.shear_modulus()));
  }
  return sum;
}

template <class Integrator>
auto block() {
  double const spacing = 0.1;
  auto solver = solver_of<BlockWith<Integrator>>({lattice<2>(spacing), {}}, spacing,
                                                 {.law = law, .gravity = {.magnitude = 0}, .viscosity_speed = 0});
  solver.set(velocity,
             [](auto const& x) { return Vec<2, double>(1e-3 * std::sin(std::numbers::pi * (x[0] - 0.5)), 0); });
  return solver;
}

/// Energy relative to the start, at its lowest and highest over the last fifth of 40 periods.
template <class Integrator>
std::pair<double, double> energy_at_last(double& strain_share) {
  auto solver = block<Integrator>();
  double const start = energy_of(solver), period = 2 / law.sound_speed();
  double low = 1e300, high = 0;
  strain_share = 0;
  while (solver.time() < 40 * period) {
    solver.step(1);
    double kinetic = 0;
    for (auto const& u : solver.material().to_host(velocity)) kinetic += 0.01 * rho * u.squaredNorm() / 2;
    strain_share = std::max(strain_share, 1 - kinetic / start);
    if (solver.time() < 32 * period) continue;
    low = std::min(low, energy_of(solver) / start), high = std::max(high, energy_of(solver) / start);
  }
  return {low, high};
}

template <class Integrator>
std::pair<double, double> checked_energy() {
  double share = 0;
  auto const found = energy_at_last<Integrator>(share);
  WARN("energy after 32 to 40 periods: " << found.first << " to " << found.second);
  CHECK(share > 0.8);  // it has been elastic energy in between
  return found;
}

}  // namespace

TEST_CASE("staggered schemes keep the energy of an elastic block over many periods") {
  // Symplectic Euler has the stress half a step ahead of the velocity: the sum oscillates by omega dt/2 = 0.047 about
  // 1.
  auto const [low, high] = checked_energy<SymplecticEuler>();
  CHECK(std::abs((low + high) / 2 - 1) < 0.005);
  CHECK(high - low < 0.1);
  auto const [lowest, highest] = checked_energy<VelocityVerlet>();
  CHECK(lowest > 0.998);
  CHECK(highest < 1.003);
}

TEST_CASE("the midpoint scheme feeds an oscillation at a known rate") {
  // By (omega dt)^4/4 in a step, omega dt = pi 0.2 h/L: 5.6 % in 2667 steps.
  auto const [low, high] = checked_energy<Midpoint>();
  CHECK(low > 1.03);
  CHECK(high < 1.07);
}

TEMPLATE_TEST_CASE("a stress that is set between steps acts from the next step on", "", Midpoint, SymplecticEuler,
                   VelocityVerlet) {
  auto solver = block<TestType>();
  solver.set(stress, [](auto const& x) { return Vec<4, double>(-1000 * x[0], -1000, -1000, 0); });
  solver.step(1);
  solver.set(stress, [](auto const&) { return zero<Vec<4, double>>(); });
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0, 0); });
  solver.step(1);
  for (auto const& u : solver.material().to_host(velocity)) CHECK(u.norm() < 1e-12);
}

// The middle of the block is turned by a rigid rotation, and drifts apart alike in both directions. The shear stress
// would grow by theta^2/2 in a step under a scheme of first order, with twice the angle theta of the step.
TEMPLATE_TEST_CASE("a block that turns keeps the shear stress in its plane to fourth order of the step", "", Midpoint,
                   SymplecticEuler, VelocityVerlet) {
  auto solver = block<TestType>();
  double const rate = 8;  // rad/s; the corners move at half the speed of sound
  Vec<2, double> const middle(0.5, 0.5);
  solver.set(velocity,
             [&](auto const& x) { return Vec<2, double>(-rate * (x[1] - middle[1]), rate * (x[0] - middle[0])); });
  solver.set(stress, [](auto const&) { return Vec<4, double>(-150, -100, -125, 20); });
  auto const shear = [&] {
    auto const x = solver.material().to_host(position);
    auto const inmost = std::min_element(
        x.begin(), x.end(), [&](auto const& a, auto const& b) { return (a - middle).norm() < (b - middle).norm(); });
    Vec<4, double> const sigma = solver.material().to_host(stress)[std::size_t(inmost - x.begin())];
    return std::hypot((sigma[0] - sigma[1]) / 2, sigma[3]);
  };
  double const before = shear(), theta = 2 * rate * solver.step(1), growth = shear() / before - 1;
  CAPTURE(theta, growth);
  CHECK(theta > 0.03);
  CHECK(std::abs(growth) < 0.01 * theta * theta / 2);
}

}  // namespace scree::test::elastic_block_tests
