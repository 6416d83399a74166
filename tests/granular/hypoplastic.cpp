// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <laws/hochstetten.hpp>
#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

// A law whose stiffness depends on the state and whose internal variable has a rate, in the solver: a closed box of
// sand whose walls deform it homogeneously. All particles must follow the path of one point of the law.
namespace scree::test::hypoplastic_tests {
using namespace fields;
namespace {

/// Homogeneous compression and shear without acceleration: x = X + shear_rate t Z, z = Z (1 - squeeze_rate t).
struct Deforming {
  double squeeze_rate = 0, shear_rate = 0;  // 1/s

  template <class X>
  SCREE_FN X displaced(X x, double from, double to) const {
    double const Z = x[1] / height(from);
    x[0] += shear_rate * (to - from) * Z;
    x[1] = Z * height(to);
    return x;
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double time) const {
    double const Z = x[1] / height(time);
    return {shear_rate * Z, -squeeze_rate * Z};
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return zero<X>();
  }
  double time_step() const { return Kokkos::Experimental::infinity_v<double>; }
  SCREE_FN double height(double time) const { return 1 - squeeze_rate * time; }
};

template <class Law>
struct Models : GranularModels {
  using law = Law;
  using filter = NoFilter;
  using strain = CorrectedStrain;
};
template <class Law>
using Physics = Granular<Models<Law>>;

template <class Integrator, class Law = Hypoplastic>
struct Box : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Physics<Law>;
  using motion = Deforming;
  using integrator = Integrator;
};

double const spacing = 0.1, lateral = 1e4, axial = 2e4;  // m, Pa

template <class P>
Solver<P> box(typename P::physics const& physics, Deforming const& motion, double e) {
  scree::Box<2> const inner{{0, 0}, {0.8, 0.8}}, outer{{-0.4, -0.4}, {1.2, 1.2}};
  auto solver =
      solver_of<P>({fill_lattice(inner, spacing), fill_between(inner, outer, spacing)}, spacing, physics, motion);
  solver.set(stress, [](auto const&) { return Vec<4, double>(-lateral, -axial, -lateral, 0); });
  solver.set(velocity, [&](auto const& x) { return motion.velocity(x, 0); });
  solver.set(void_ratio, [&](auto const&) { return e; });
  return solver;
}
/// The path of one point of the law.
Sand<> element(Deforming const& motion, double e, double duration) {
  Mat<3, double> const sigma = Vec<3, double>(-lateral, -axial, -lateral).asDiagonal();
  Sand<> point{hochstetten(), sigma, e};
  int const steps = 4000;
  for (int n = 0; n < steps; ++n) {
    double const middle = motion.height((n + 0.5) * duration / steps);
    Mat<3, double> L = Mat<3, double>::Zero();
    L(0, 1) = motion.shear_rate / middle;
    L(1, 1) = -motion.squeeze_rate / middle;
    point.follow([&](auto const&) { return L; }, duration / steps, 1);
  }
  return point;
}
template <class S>
double largest_error(S const& solver, Sand<> const& expected) {
  double error = 0;
  for (auto const& sigma : solver.material().to_host(stress))
    error = std::max(error, (unpacked(sigma) - expected.sigma).norm() / expected.sigma.norm());
  for (double const e : solver.material().to_host(void_ratio)) error = std::max(error, std::abs(e / expected.e - 1));
  return error;
}
template <class Law = Hypoplastic>
Physics<Law> sand_in(Law const& law, double cfl = 0.2) {
  return {.law = law, .gravity = {.magnitude = 0}, .cfl = cfl};
}
template <class Integrator, class Law = Hypoplastic>
double error_in_box(Deforming const& motion, double e, double cfl = 0.2, Law const& law = {hochstetten()}) {
  double const duration = 0.06;
  auto solver = box<Box<Integrator, Law>>(sand_in(law, cfl), motion, e);
  solver.run(duration);
  auto const expected = element(motion, e, duration);
  CAPTURE(e, expected.sigma(1, 1), expected.sigma(0, 1));
  CHECK(std::abs(expected.sigma(1, 1) / axial - 1) > 0.1);  // the path is a long one
  return largest_error(solver, expected);
}
template <class S, class Action>
std::string complaint_of(S& solver, Action const& action) {
  try {
    action(solver);
  } catch (std::exception const& error) {
    return error.what();
  }
  return "";
}

Deforming const oedometer_test{.squeeze_rate = 0.5}, shear_test{.shear_rate = 0.5};

}  // namespace

TEST_CASE("particles of a hypoplastic sand in oedometer and simple shear follow the path of one point") {
  for (double const e : {0.65, 0.85}) {
    CHECK(error_in_box<Midpoint>(oedometer_test, e) < 1e-4);
    CHECK(error_in_box<Midpoint>(shear_test, e) < 3e-4);
  }
}

TEMPLATE_TEST_CASE("with staggered integrators the path of a hypoplastic sand is of first order of the step", "",
                   SymplecticEuler, VelocityVerlet) {
  for (auto const& motion : {oedometer_test, shear_test}) {
    double const error = error_in_box<TestType>(motion, 0.65), with_half = error_in_box<TestType>(motion, 0.65, 0.1);
    CAPTURE(error, with_half);
    CHECK(error < 0.01);
    CHECK(std::abs(with_half / error - 0.5) < 0.05);
  }
}

TEST_CASE("a law around a hypoplastic one forwards stiffness and rates") {
  using Remembering = VolumeMemory<Hypoplastic>;
  STATIC_CHECK(StiffnessOfState<Remembering>);
  STATIC_CHECK(EvolvesHistory<Remembering>);
  CHECK(error_in_box<Midpoint, Remembering>(oedometer_test, 0.65, 0.2, {hochstetten()}) < 1e-4);
}

TEST_CASE("the step of a law whose stiffness depends on the state follows from the stiffest particle") {
  auto const law = hochstetten();
  auto const physics = sand_in(law);
  auto solver = box<Box<Midpoint>>(physics, {}, 0.7);
  solver.set(stress, [](auto const& x) { return Vec<4, double>(x[1] > 0.7 ? -3e5 : -1e3, -2e3, -1e3, 0); });
  Mat<3, double> const stiff = Vec<3, double>(-3e5, -2e3, -1e3).asDiagonal();
  double const fastest = law.sound_speed(stiff, OfVoids{0.7});
  CHECK(relative(solver.step(std::numeric_limits<double>::infinity()),
                 physics.cfl * solver.resolution().smoothing_length / fastest) < 1e-12);
  CHECK(solver.limits().at("acoustic") == 1);
}

TEST_CASE("a particle may be as fast as the speed of sound at it") {
  auto const u = [](double speed) { return [=](auto const& x) { return Vec<2, double>(x[1] > 0.7 ? speed : 0, 0); }; };
  auto const law = hochstetten();
  double const soft = law.sound_speed(Mat<3, double>(-1e3 * Mat<3, double>::Identity()), OfVoids{0.7});
  auto solver = box<Box<Midpoint>>(sand_in(law), {}, 0.7);
  solver.set(stress, [](auto const& x) {
    return Vec<4, double>(x[1] > 0.7 ? Vec<4, double>(-1e3, -1e3, -1e3, 0) : Vec<4, double>(-1e5, -1e5, -1e5, 0));
  });
  auto const check = [](auto& each) { each.check_validity(); };
  solver.set(velocity, u(0.99 * soft));
  CHECK(complaint_of(solver, check) == "");
  solver.set(velocity, u(1.01 * soft));
  CHECK_THAT(complaint_of(solver, check), Catch::Matchers::ContainsSubstring("the Mach number must be at most 1"));
}

TEST_CASE("a void ratio that nobody set is refused") {
  Box<Midpoint>::physics const physics = sand_in(hochstetten());
  auto solver = solver_of<Box<Midpoint>>(layer({1, 0.5}, spacing), spacing, physics);
  CHECK_THAT(complaint_of(solver, [](auto& each) { each.step(1); }),
             Catch::Matchers::ContainsSubstring("void ratio (1) of the material"));
}

TEST_CASE("a bed of hypoplastic sand under gravity keeps its stress and hardly settles") {
  double const depth = 0.8, rho = hochstetten().rest_density;
  auto physics = sand_in(hochstetten());
  physics.gravity.magnitude = 9.81;
  auto solver = solver_of<Box<SymplecticEuler>>(open_bed<2>({1, depth}, 0.05), 0.05, physics);
  solver.set(stress, [&](auto const& x) {
    double const p = rho * 9.81 * (depth - x[1]);
    return Vec<4, double>(-0.45 * p, -p, -0.45 * p, 0);
  });
  solver.set(void_ratio, [&](auto const&) { return 0.7; });
  solver.run(0.5);
  double top = 0, load = 0;
  for (auto const& x : solver.material().to_host(position)) top = std::max(top, x[1]);
  for (auto const& sigma : solver.material().to_host(stress)) load = std::max(load, -sigma[1]);
  CHECK(std::abs(top - (depth - 0.025)) < 1e-3);
  CHECK(std::abs(load / (rho * 9.81 * (depth - 0.025)) - 1) < 0.05);
  for (double const e : solver.material().to_host(void_ratio)) CHECK(std::abs(e - 0.7) < 0.02);
}

}  // namespace scree::test::hypoplastic_tests
