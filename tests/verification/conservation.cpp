// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

// Conservation laws: momentum, and energy except for the loss to viscosity. A disc without walls and gravity, with
// disordered particles, spins, pulsates and is sheared.
namespace scree::test::blob::conservation_tests {
namespace {

double const radius = 0.01, spacing = 1e-3, sound_speed = 10, spin = 20;  // m, m/s, 1/s

template <class Law>
Law law() {
  if constexpr (std::is_same_v<Law, Elastic>)
    return beads(sound_speed).elastic;
  else
    return beads(sound_speed);
}

template <class Law>
struct Unfiltered : GranularModels {
  using law = Law;
  using filter = NoFilter;
};

template <class Law, class Real = double>
Solver<GranularCase<2, Granular<Unfiltered<Law>>, Real>> spinning(double viscosity_speed, double cfl) {
  using namespace fields;
  using P = GranularCase<2, Granular<Unfiltered<Law>>, Real>;
  using vector = Vec<2, Real>;
  typename P::physics const physics{
      .law = law<Law>(), .gravity = {0, 0}, .viscosity_speed = viscosity_speed, .cfl = cfl};
  auto points =
      points_within(fill_lattice(Box<2>{{-radius, -radius}, {radius, radius}}, spacing), Ball<2>{{0, 0}, radius});
  jitter(points, 0.2 * spacing, 7);
  Solver<P> solver({.spacing = spacing, .physics = physics}, cast<Real>(points));
  solver.set(velocity, [](vector const& x) {
    return vector(Real(-spin) * x[1] - Real(5) * x[0] + Real(0.02), Real(spin + 8) * x[0] - Real(0.01));
  });
  double const p = 100;  // Pa; inwards, so that grains stay under pressure for a while
  solver.set(stress, [&](vector const& x) {
    Real const here = Real(p * (1 - double(x.squaredNorm()) / sq(1.2 * radius)));
    return Vec<4, Real>(-here, -here, -here, Real(0));
  });
  return solver;
}

/// Sums over the particles, each of mass rho V (kg per m of depth), in double.
struct Balance {
  Vec<2, double> momentum = Vec<2, double>::Zero();
  double magnitude = 0;  ///< sum of |m u|
  double angular = 0, kinetic = 0, elastic = 0;
  double energy() const { return kinetic + elastic; }
};
template <class S>
Balance balance_of(S const& solver) {
  using namespace fields;
  auto const x = solver.material().to_host(position);
  auto const u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  Elastic const elastic = law<Elastic>();
  double const V = sq(spacing), m = bed_density * V;
  Balance sum;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Vec<2, double> const at = x[i].template cast<double>(), v = u[i].template cast<double>();
    Mat<3, double> const s = unpacked(Vec<4, double>(sigma[i].template cast<double>()));
    sum.momentum += m * v;
    sum.magnitude += m * v.norm();
    sum.angular += m * (at[0] * v[1] - at[1] * v[0]);
    sum.kinetic += m / 2 * v.squaredNorm();
    // s:s/(4 G) + p^2/(2 K) per volume
    sum.elastic += V * (deviator_of(s).squaredNorm() / (4 * elastic.shear_modulus()) +
                        sq(pressure_of(s)) / (2 * elastic.bulk_modulus()));
  }
  return sum;
}

template <class S>
double energy_after(S solver, double time) {
  solver.run(time);
  show_packing(solver);
  return balance_of(solver).energy();
}

double const period = 4 * radius / sound_speed;  // there and back across the disc, s

}  // namespace

TEST_CASE("linear momentum is kept to round-off") {
  auto solver = spinning<MuOfI<>>(0.5, 0.2);
  Balance const before = balance_of(solver);
  solver.run(5 * period);
  Balance const after = balance_of(solver);
  // Some 40 pairs act on a particle twice a step, each rounded; the sum over the particles is a random walk at worst.
  double const rounding = 2.2e-16 * std::sqrt(80.0 * double(solver.steps()) * solver.material().size());
  INFO("change " << (after.momentum - before.momentum).norm() / before.magnitude << " of sum |m u|, " << solver.steps()
                 << " steps; angular momentum " << after.angular / before.angular - 1);
  show_packing(solver);
  CHECK((after.momentum - before.momentum).norm() < rounding * before.magnitude);
  // Stresses act along sigma x_ij, not along x_ij, so angular momentum is conserved only as well as sums approximate
  // integrals.
  CHECK(std::abs(after.angular / before.angular - 1) < 0.02);
}

TEST_CASE("a force of its own on each particle is noticed") {
  using namespace fields;
  auto solver = spinning<MuOfI<>>(0.5, 0.2);
  Balance const before = balance_of(solver);
  auto u = solver.material().to_host(velocity);
  u[0][0] *= 1 + 1e-9;
  std::size_t next = 0;
  solver.set(velocity, [&](auto const&) { return u[next++]; });
  double const rounding = 2.2e-16 * std::sqrt(80.0 * 1000 * solver.material().size());
  CHECK((balance_of(solver).momentum - before.momentum).norm() > rounding * before.magnitude);
}

TEST_CASE("elastic energy and kinetic energy turn into each other; only viscosity takes") {
  double const before = balance_of(spinning<Elastic>(0, 0.1)).energy();
  double const kept = energy_after(spinning<Elastic>(0, 0.1), period) / before - 1;
  double const halved = energy_after(spinning<Elastic>(0, 0.05), period) / before - 1;
  INFO("without viscosity " << kept << ", with half the step " << halved);
  // In space the rates of stress and velocity are adjoint, so only the error of the midpoint rule remains, which for an
  // oscillation changes the energy by (omega dt)^4/4 per step: an eighth in a given time for half the step.
  CHECK(std::abs(kept) < 1e-4);
  CHECK(std::abs(kept / halved - 8) < 2);

  auto damped = spinning<Elastic>(1, 0.1);
  double last = before;
  for (int tenth = 1; tenth <= 10; ++tenth) {
    damped.run(0.1 * tenth * period);
    double const now = balance_of(damped).energy();
    INFO("after " << 0.1 * tenth << " periods " << now / before);
    show_packing(damped);
    CHECK(now < last);
    last = now;
  }
  CHECK(1 - last / before > 100 * std::abs(kept));
}

}  // namespace scree::test::blob::conservation_tests
