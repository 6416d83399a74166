// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/size_density_closure.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cmath>

// Species of different densities: the mass of a particle follows its composition, and momentum goes with mass.
namespace scree::test::species_densities_tests {
using namespace fields;
namespace {

using Mixture = Vec<3, double>;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
Mixture const densities(3000, 700, 1500);

struct OneDensity : GranularModels {
  using law = MuOfI<>;
};
struct ThreeDensities : GranularModels {
  using law = MixtureDensity<MuOfI<>, 3>;
};
template <class Models>
using Physics = Combined<Granular<Models>, SpeciesSegregation<ConstantSpecies<3>>>;
template <class Q, class Integrator, class Models = ThreeDensities>
struct Case : Formulated<Q, Physics<Models>> {
  using integrator = Integrator;
};

MuOfI<> sand(double density) { return {.elastic = {1e5, 0.3, density}, .grains = {0.01}}; }

/// A disordered block in flight whose grains segregate quickly, in a flow with shear.
template <class P>
Solver<P> block(typename P::physics::LawOfCase const&) = delete;
template <class P, class Law>
Solver<P> block(Law const& law, int period = 1, Points<P::dim> const& walls = {}) {
  constexpr int dim = P::dim;
  using real = typename P::real;
  typename P::physics physics;
  physics.mechanics.law = law;
  physics.mechanics.gravity = {9.81, 0.3};
  physics.transport.closure = {.velocities = {1, 0.4, 0}, .diffusivity = 0.02};
  physics.period = period;
  Bed<dim> bed{lattice<dim>(0.125), walls};
  jitter(bed.material, 0.01, 3);
  auto solver = solver_of<P>(bed, 0.125, physics);
  solver.set(concentrations<3>, [](auto const& x) {
    double const a = 0.3 + 0.18 * std::sin(7.0 * x[0]), b = 0.3 + 0.18 * std::cos(5.0 * x[dim - 1]);
    return Mixture(a, b, 1 - a - b).template cast<real>().eval();
  });
  solver.set(velocity, [](auto const& x) {
    Vec<dim, double> u = Vec<dim, double>::Constant(0.2 * std::sin(9.0 * x[1]));
    u[0] += 2.0 * x[dim - 1], u[dim - 1] -= std::cos(4.0 * x[0]);
    return u.template cast<real>().eval();
  });
  solver.set(stress, [](auto const& x) {
    Vec<symmetric3_size<dim>, double> sigma = Vec<symmetric3_size<dim>, double>::Zero();
    for (int a = 0; a < 3; ++a) sigma[a] = -500 - 300 * std::sin(6.0 * x[0]);
    return sigma.template cast<real>().eval();
  });
  return solver;
}
MixtureDensity<MuOfI<>, 3> mixed() { return {sand(1500), densities}; }

template <int Dim>
struct Totals {
  double mass = 0, speed = 0;  // kg, and the sum of m |u|, kg m/s
  Mixture of_species = Mixture::Zero();
  Vec<Dim, double> momentum = Vec<Dim, double>::Zero();
};
template <class S>
Totals<S::policy::dim> totals(S const& solver) {
  Totals<S::policy::dim> sum;
  auto const C = solver.material().to_host(concentrations<3>);
  auto const u = solver.material().to_host(velocity);
  auto const V = solver.material().to_host(volume);
  for (std::size_t i = 0; i < C.size(); ++i) {
    Mixture const c = C[i].template cast<double>();
    double const m = double(V[i]) * c.dot(densities);
    sum.mass += m, sum.of_species += double(V[i]) * c;
    sum.momentum += m * u[i].template cast<double>();
    sum.speed += m * double(u[i].norm());
  }
  return sum;
}
/// The momentum that gravity did not give, over the sum of m |u|.
template <class S, class T>
double momentum_made(S const& solver, T const& before) {
  auto const now = totals(solver);
  using X = Vec<S::policy::dim, double>;
  X const given = before.mass * solver.time() * solver.settings().physics.mechanics.gravity.template vector<X>();
  return (now.momentum - before.momentum - given).norm() / now.speed;
}
/// The largest change of a density of a particle over its start.
template <class S>
double masses_changed(S const& solver, std::vector<double> const& before) {
  auto const rho = solver.material().to_host(concentrations<3>);
  double most = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    most = std::max(most, std::abs(rho[i].template cast<double>().dot(densities) / before[i] - 1));
  return most;
}
template <class S>
std::vector<double> masses_of(S const& solver) {
  std::vector<double> found;
  for (auto const& C : solver.material().to_host(concentrations<3>))
    found.push_back(C.template cast<double>().dot(densities));
  return found;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("mass of each species and momentum stay to rounding while the masses of particles change", "",
                        Policies) {
  using P = Case<TestType, SymplecticEuler>;
  auto solver = block<P>(mixed());
  auto const before = totals(solver);
  auto const masses = masses_of(solver);
  int const steps = 60;
  for (int k = 0; k < steps; ++k) solver.step(1);
  auto const now = totals(solver);
  INFO("after " << solver.time() << " s: masses of particles changed by up to " << masses_changed(solver, masses)
                << " of themselves; momentum made " << momentum_made(solver, before) << ", mass "
                << now.mass / before.mass - 1 << ", of species "
                << (now.of_species - before.of_species).transpose() / before.of_species.sum());
  CHECK(masses_changed(solver, masses) > 0.1);
  CHECK(momentum_made(solver, before) < ulps<TestType>(steps));
  CHECK(std::abs(now.mass / before.mass - 1) < ulps<TestType>(steps));
  CHECK((now.of_species - before.of_species).cwiseAbs().maxCoeff() < ulps<TestType>(steps) * before.of_species.sum());
}

TEST_CASE("with the midpoint rule the momentum that is made is of third order in a step") {
  auto const made = [](double dt) {
    auto solver = block<Case<OnHost, Midpoint>>(mixed());
    auto const before = totals(solver);
    while (solver.time() < 0.0999) solver.step(dt);
    UNSCOPED_INFO(solver.steps() << " steps: made " << momentum_made(solver, before));
    return momentum_made(solver, before);
  };
  double const coarse = made(8e-4), fine = made(4e-4);
  CHECK(coarse > 1e-10);
  CHECK(coarse < 1e-5);
  CHECK(coarse / fine > 3);
}

TEST_CASE("a longer interval of the exchange makes momentum in proportion to the age of the velocities") {
  auto const made = [](int period) {
    auto solver = block<Case<OnHost, SymplecticEuler>>(mixed(), period);
    auto const before = totals(solver);
    while (solver.steps() < 240) solver.step(4e-4);
    UNSCOPED_INFO("every " << period << " steps: " << momentum_made(solver, before));
    return momentum_made(solver, before);
  };
  double const three = made(3), five = made(5);  // 1 and 2 steps old in the mean
  CHECK(three > 1e-9);
  CHECK(five < 1e-3);
  CHECK(std::abs(five / three - 2) < 0.2);
}

// Mass moves between two kicks, each with half of the momentum that it carries: a kick has that of the step before.
TEST_CASE("with velocity Verlet the momentum that is made is half a step of what species carry") {
  auto solver = block<Case<OnHost, VelocityVerlet>>(mixed());
  auto const carried_by = [&] {
    auto const X = solver.material().to_host(carried_momentum);
    auto const V = solver.material().to_host(volume);
    Vec<2, double> sum = Vec<2, double>::Zero();
    for (std::size_t i = 0; i < X.size(); ++i) sum += V[i] * X[i];
    return sum;
  };
  double const dt = 1e-3;
  solver.step(dt);
  auto const before = totals(solver);
  double const start = solver.time();
  Vec<2, double> const first = carried_by();
  for (int k = 1; k < 80; ++k) solver.step(dt);
  auto const now = totals(solver);
  Vec<2, double> const given =
      before.mass * (solver.time() - start) * solver.settings().physics.mechanics.gravity.vector<Vec<2, double>>();
  Vec<2, double> const made = now.momentum - before.momentum - given;
  INFO("made " << made.transpose() << " kg m/s, carried " << first.transpose() << " and " << carried_by().transpose()
               << " N");
  CHECK(made.norm() > 1e-7 * now.speed);
  CHECK((made - dt / 2 * (first - carried_by())).norm() < 1e-14 * now.speed);
}

TEMPLATE_LIST_TEST_CASE("what species carry gives neither momentum nor kinetic energy", "", Policies) {
  using P = Case<TestType, SymplecticEuler>;
  constexpr int dim = P::dim;
  auto solver = block<P>(mixed());
  solver.update_rates();
  auto const rates = solver.material().to_host(concentration_rates<3>);
  auto const carried = solver.material().to_host(carried_momentum);
  auto const u = solver.material().to_host(velocity);
  auto const V = solver.material().to_host(volume);
  Vec<dim, double> momentum = Vec<dim, double>::Zero();
  double energy = 0, mass = 0, of_momentum = 0, of_energy = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    Vec<dim, double> const v = u[i].template cast<double>(), X = carried[i].template cast<double>();
    double const rate = rates[i].template cast<double>().dot(densities);
    momentum += double(V[i]) * (X + rate * v), energy += double(V[i]) * (X.dot(v) + rate * v.squaredNorm() / 2);
    mass += double(V[i]) * rate;
    of_momentum += double(V[i]) * X.norm(), of_energy += double(V[i]) * std::abs(X.dot(v));
  }
  INFO("of " << of_momentum << " N and " << of_energy << " W: " << momentum.norm() << ", " << energy << ", mass "
             << mass);
  CHECK(of_momentum > 1);
  CHECK(momentum.norm() < ulps<TestType>(16) * of_momentum);
  CHECK(std::abs(energy) < ulps<TestType>(16) * of_energy);
}

TEST_CASE("of two particles one gains half of the mass times the velocity of the other") {
  using P = Case<OnHost, SymplecticEuler>;
  P::physics physics;
  physics.mechanics.law = mixed();
  physics.transport.closure = {.velocities = {1, 0.4, 0}, .diffusivity = 0.02};
  auto solver = solver_of<P>({{{0, 0}, {0.03, 0.1}}, {}}, 0.1, physics);
  Vec<2, double> const u1(0.3, -2), u2(1, 0.7);
  solver.set(velocity, [&](auto const& x) { return x[1] > 0.05 ? u2 : u1; });
  solver.set(concentrations<3>,
             [](auto const& x) { return x[1] > 0.05 ? Mixture(0.5, 0.3, 0.2) : Mixture(0.2, 0.2, 0.6); });
  solver.update_rates();
  auto const rates = solver.material().to_host(concentration_rates<3>);
  auto const X = solver.material().to_host(carried_momentum);
  double const gained = rates[0].dot(densities);  // kg/(m^3 s), by the lower one
  CHECK(gained > 1);                              // of heavy grains that sink
  CHECK((X[0] - gained / 2 * (u2 - u1)).norm() < 1e-12 * X[0].norm());
  CHECK((X[1] + gained / 2 * (u1 - u2)).norm() < 1e-12 * X[1].norm());
}

TEST_CASE("densities do not change the exchange of grains") {
  auto with = block<Case<OnHost, Midpoint>>(mixed());
  auto without = block<Case<OnHost, Midpoint, OneDensity>>(sand(1500));
  with.update_rates(), without.update_rates();
  CHECK(with.material().to_host(concentration_rates<3>) == without.material().to_host(concentration_rates<3>));
}

// 1024 is a power of 2, so that both forms of the divergence of the stress have the same bits.
TEMPLATE_TEST_CASE("species of equal densities have the bits of one density", "", Midpoint, SymplecticEuler,
                   VelocityVerlet) {
  Points<2> const floor = fill_lattice(Box<2>{{-0.5, -0.5}, {1.5, 0}}, 0.125);
  MixtureDensity<MuOfI<>, 3> const equal{sand(1024), Mixture::Constant(1024)};
  auto with = block<Case<OnHost, TestType>>(equal, 3, floor);
  with.set(velocity, [](auto const& x) { return Vec<2, double>(0.4 * x[1], -0.3); });
  auto without = block<Case<OnHost, TestType, OneDensity>>(sand(1024), 3, floor);
  without.set(velocity, [](auto const& x) { return Vec<2, double>(0.4 * x[1], -0.3); });
  for (int k = 0; k < 90; ++k) with.step(1), without.step(1);
  CHECK(with.time() == without.time());
  CHECK(with.material().to_host(position) == without.material().to_host(position));
  CHECK(with.material().to_host(velocity) == without.material().to_host(velocity));
  CHECK(with.material().to_host(stress) == without.material().to_host(stress));
  CHECK(with.material().to_host(concentrations<3>) == without.material().to_host(concentrations<3>));
}

}  // namespace scree::test::species_densities_tests
