// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/conserving.hpp>
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

// The effect of walls on the energy of an elastic block between a floor and two sides, without gravity and viscosity.
// The positions change by too little to matter, so that the equations are linear.
namespace scree::test::wall_energy_tests {
namespace {

using namespace fields;

template <class Scheme, class Strain>
struct Models : GranularModels {
  using law = Elastic;
  using filter = NoFilter;
  using walls = Scheme;
  using strain = Strain;
};
template <class Scheme, int Dim, class Real, class Motion, class Strain>
struct Block : Formulation<Dim, Real> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models<Scheme, Strain>>;
  using integrator = VelocityVerlet;
  using motion = Motion;
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
    Mat<3, double> const full = unpacked(sigma[i]).template cast<double>();
    double const p = pressure_of(full), tau = equivalent_shear_stress(deviator_of(full));
    sum +=
        V[i] * (law.density() * u[i].squaredNorm() + p * p / law.bulk_modulus() + tau * tau / law.shear_modulus()) / 2;
  }
  return sum;
}
/// A block between a floor and sides, 10 by 6 particles (10 by 4 by 6), all walls in a motion.
template <class Scheme, int Dim, class Real = double, class Motion = AtRest, class Strain = PlainStrain>
auto block(Motion const& motion = {}, Scheme const& walls = {}) {
  using B = Block<Scheme, Dim, Real, Motion, Strain>;
  using X = Vec<Dim, double>;
  double const dr = 0.01;
  X high = X::Constant(4 * dr);
  high[0] = 10 * dr, high[Dim - 1] = 6 * dr;
  Box<Dim> const inside{X::Zero(), high}, outside{X::Constant(-3 * dr), high + X::Constant(3 * dr)};
  Box<Dim> open = inside;
  open.high[Dim - 1] += 3 * dr;
  SolverSettings<B> settings{.spacing = dr};
  settings.physics.law = {1e6, 0.3, 1500};
  settings.physics.walls = walls;
  settings.physics.gravity.magnitude = 0;
  settings.physics.viscosity_speed = 0;
  settings.physics.cfl = 0.1;
  settings.motion = motion;
  return Solver<B>(settings, cast<Real>(fill_lattice(inside, dr)), cast<Real>(fill_between(open, outside, dr)));
}
/// The largest change of the energy in a time, over that at the start. It starts with random velocities. `smooth`: all
/// walls let slip.
template <class Scheme, int Dim, class Real = double, class Strain = PlainStrain>
double change_of_energy(double duration, bool smooth = false, Scheme const& walls = {}) {
  auto solver = block<Scheme, Dim, Real, AtRest, Strain>({}, walls);
  using X = Vec<Dim, Real>;
  std::mt19937 random(3);
  solver.set(velocity, [&](auto const&) {
    X u;
    for (int axis = 0; axis < Dim; ++axis) u[axis] = Real(1e-6 * (double(random()) / 4294967296.0 - 0.5));
    return u;
  });
  if (smooth)
    solver.template set<Wall>(slip_normal, [](auto const& x) {
      X n = X::Zero();
      n[x[Dim - 1] < 0 ? Dim - 1 : x[0] < 0 || x[0] > Real(0.1) ? 0 : 1] = 1;
      return n;
    });
  double const start = energy(solver);
  double most = 0;
  for (int k = 1; k <= 20; ++k) {
    solver.run(duration * k / 20);
    most = std::max(most, std::abs(energy(solver) / start - 1));
  }
  return most;
}

}  // namespace

TEMPLATE_TEST_CASE("walls whose strain is the adjoint of their stress keep the energy of an elastic block", "",
                   MirrorWalls, ConservingWalls) {
  CHECK(change_of_energy<TestType, 2>(0.5) < 1e-3);
  CHECK(change_of_energy<TestType, 3>(0.1) < 1e-3);
  CHECK(change_of_energy<TestType, 2, float>(0.1) < 1e-2);
  CHECK(change_of_energy<TestType, 2>(0.2, true) < 0.1);  // of smooth mirrors to a plane without corners only
}

// Their corners too: a grain that moves along one wall nears the other.
TEST_CASE("smooth walls that conserve keep the energy of an elastic block, with their corners") {
  CHECK(change_of_energy<ConservingWalls, 2>(1, true) < 1e-3);
  CHECK(change_of_energy<ConservingWalls, 3>(0.1, true) < 1e-3);
  CHECK(change_of_energy<ConservingWalls, 2, float>(0.1, true) < 1e-2);
}

// The block moves at 1e-6 m/s: it slides at the first limit, and is between both forms at the second.
TEST_CASE("smooth walls that conserve keep energy where material slides and where it begins to slide") {
  for (double const sliding_speed : {0.0, 1e-6}) {
    CAPTURE(sliding_speed);
    ConservingWalls const walls{.sliding_speed = sliding_speed};
    CHECK(change_of_energy<ConservingWalls, 2>(0.5, true, walls) < 1e-3);
    CHECK(change_of_energy<ConservingWalls, 3>(0.1, true, walls) < 1e-3);
  }
}

// Where material slides along smooth walls in space, the part of the antisymmetric stress stays that for rest.
TEST_CASE("walls keep the energy of an elastic block with the objective strain, too") {
  CHECK(change_of_energy<ConservingWalls, 2, double, ObjectiveStrain>(0.5, false, {}) < 1e-3);
  CHECK(change_of_energy<ConservingWalls, 3, double, ObjectiveStrain>(0.1, false, {}) < 1e-3);
  CHECK(change_of_energy<ConservingWalls, 3, float, ObjectiveStrain>(0.05, false, {}) < 1e-2);
  CHECK(change_of_energy<MirrorWalls, 2, double, ObjectiveStrain>(0.5, false, {}) < 1e-3);
  CHECK(change_of_energy<ConservingWalls, 2, double, ObjectiveStrain>(1, true, {}) < 1e-3);
  CHECK(change_of_energy<ConservingWalls, 3, double, ObjectiveStrain>(0.1, true, {}) < 1e-3);
  ConservingWalls const sliding{.sliding_speed = 0};
  CHECK(change_of_energy<ConservingWalls, 2, double, ObjectiveStrain>(0.5, true, sliding) < 1e-3);
  CHECK(change_of_energy<ConservingWalls, 3, double, ObjectiveStrain>(0.1, true, sliding) < 3e-3);
}

TEST_CASE("negative control: mirrored velocities alone do not keep energy in the corners of smooth walls") {
  CHECK(change_of_energy<MirrorWalls, 2>(1, true) > 0.1);
  CHECK(change_of_energy<AdamiWalls, 2>(1, true) > 10);
}

TEST_CASE("negative control: walls that mirror the mean of velocities feed oscillations of an elastic block") {
  CHECK(change_of_energy<AdamiWalls, 2>(0.5) > 1e4);
}

namespace {
/// The largest error of the stress rate of a linear velocity in particles that see the floor and neither sides nor
/// surface, over its norm.
template <class Real>
double error_of_rate(Mat<2, Real> const& gradient, bool smooth = false, ConservingWalls const& walls = {}) {
  auto solver = block<ConservingWalls, 2, Real>({}, walls);
  if (smooth) solver.template set<Wall>(slip_normal, [](auto const& x) { return Vec<2, Real>(0, x[1] < 0 ? 1 : 0); });
  solver.set(velocity, [&](auto const& x) { return Vec<2, Real>(gradient * x); });
  solver.update_rates();
  auto const x = solver.material().to_host(position);
  auto const rate = solver.material().to_host(stress_rate);
  Elastic const law{1e6, 0.3, 1500};
  Mat<3, double> const all = in_three_dimensions(Mat<2, double>(gradient.template cast<double>()));
  auto const exact = packed<2>(law.stress_rate(Mat<3, double>(Mat<3, double>::Zero()), all, NoHistory{}));
  double worst = 0;
  int seen = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i][0] > Real(0.03) && x[i][0] < Real(0.07) && x[i][1] < Real(0.03)) {
      worst = std::max(worst, (rate[i].template cast<double>() - exact).norm() / exact.norm());
      ++seen;
    }
  REQUIRE(seen >= 12);
  return worst;
}
}  // namespace

TEMPLATE_TEST_CASE("next to a wall that conserves, strain rates of a linear velocity are found to 2 %", "", float,
                   double) {
  using Real = TestType;
  CHECK(error_of_rate<Real>(Mat<2, Real>{{Real(0), Real(3)}, {Real(0), Real(-2)}}) < 0.02);  // none at the floor
}
TEMPLATE_TEST_CASE("next to a smooth wall that conserves, strain rates along it are found to 1 % in both forms", "",
                   float, double) {
  using Real = TestType;
  for (double const sliding_speed : {0.0, std::numeric_limits<double>::infinity()}) {
    CAPTURE(sliding_speed);
    double const along = error_of_rate<Real>(Mat<2, Real>{{Real(3), Real(0)}, {Real(0), Real(0)}}, true,
                                             ConservingWalls{.sliding_speed = sliding_speed});
    double const both = error_of_rate<Real>(Mat<2, Real>{{Real(3), Real(0)}, {Real(0), Real(-2)}}, true,
                                            ConservingWalls{.sliding_speed = sliding_speed});
    CAPTURE(along, both);
    CHECK(along < 0.01);
    CHECK(both < 0.025);
  }
}

TEST_CASE("material that turns with walls that conserve is not strained") {
  auto solver = block<ConservingWalls, 2, double, Rotation>({.rate = 3});
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(-3 * x[1], 3 * x[0]); });
  solver.update_rates();
  double most = 0;
  auto const x = solver.material().to_host(position);
  auto const rate = solver.material().to_host(stress_rate);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i][1] < 0.03) most = std::max(most, rate[i].norm());
  CHECK(most < 1e-9 * 3 * 1e6);
}

}  // namespace scree::test::wall_energy_tests
