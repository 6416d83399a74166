// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

// The effect of walls on the energy of an elastic block between a floor and two sides, without gravity and viscosity.
// The positions change by too little to matter, so that the equations are linear.
namespace scree::test::wall_energy_tests {
namespace {

using namespace fields;

template <class Scheme>
struct Models : GranularModels {
  using law = Elastic;
  using filter = NoFilter;
  using walls = Scheme;
};
template <class Scheme>
struct Block : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models<Scheme>>;
  using integrator = VelocityVerlet;
};

/// Kinetic and elastic energy, J/m.
template <class S>
double energy(S const& solver) {
  Elastic const& law = solver.settings().physics.law;
  auto const V = solver.material().to_host(volume);
  auto const u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  double sum = 0;
  for (std::size_t i = 0; i < V.size(); ++i) {
    Mat<3, double> const full = unpacked(sigma[i]);
    double const p = pressure_of(full), tau = equivalent_shear_stress(deviator_of(full));
    sum +=
        V[i] * (law.density() * u[i].squaredNorm() + p * p / law.bulk_modulus() + tau * tau / law.shear_modulus()) / 2;
  }
  return sum;
}
/// The energy after a time over that at the start, and the largest change on the way. It starts with random velocities.
template <class Scheme>
std::pair<double, double> change_of_energy(double duration) {
  double const dr = 0.01, W = 10 * dr, H = 6 * dr;
  SolverSettings<Block<Scheme>> settings{.spacing = dr};
  settings.physics.law = {1e6, 0.3, 1500};
  settings.physics.gravity.magnitude = 0;
  settings.physics.viscosity_speed = 0;
  settings.physics.cfl = 0.1;
  Solver<Block<Scheme>> solver(
      settings, fill_lattice(Box<2>{{0, 0}, {W, H}}, dr),
      fill_between(Box<2>{{0, 0}, {W, H + 3 * dr}}, Box<2>{{-3 * dr, -3 * dr}, {W + 3 * dr, H + 3 * dr}}, dr));
  std::mt19937 random(3);
  solver.set(velocity, [&](auto const&) {
    double const across = double(random()) / 4294967296.0 - 0.5, up = double(random()) / 4294967296.0 - 0.5;
    return Vec<2, double>(1e-6 * across, 1e-6 * up);
  });
  double const start = energy(solver);
  double most = 0;
  for (int k = 1; k <= 20; ++k) {
    solver.run(duration * k / 20);
    most = std::max(most, std::abs(energy(solver) / start - 1));
  }
  return {energy(solver) / start, most};
}

}  // namespace

TEST_CASE("walls that mirror each particle keep the energy of an elastic block") {
  auto const [last, most] = change_of_energy<MirrorWalls>(0.5);
  CAPTURE(last, most);
  CHECK(most < 0.01);
}

TEST_CASE("negative control: walls that show means of the material feed oscillations of an elastic block") {
  auto const [last, most] = change_of_energy<AdamiWalls>(0.5);
  CAPTURE(last, most);
  CHECK(last > 10);
}

}  // namespace scree::test::wall_energy_tests
