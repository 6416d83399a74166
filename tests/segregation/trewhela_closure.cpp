// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/trewhela_closure.hpp>

#include <support/bodies.hpp>
#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace scree::test::trewhela_closure_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

TrewhelaClosure const closure{.d_small = 0.1, .d_large = 0.25, .grain_density = 2000, .gravity = 10};

/// The packed stress of a pressure (Pa) and a shear stress, whose normal stresses differ.
template <int Dim>
auto stress_of(double p, double shear) {
  constexpr int count = Dim == 2 ? 4 : 6;
  Vec<count, double> s = Vec<count, double>::Constant(shear);
  s[0] = -p - 50, s[1] = -p + 20, s[2] = -p + 30;
  return s;
}
struct Closed {
  std::vector<double> V, D;
};
/// V and D of particles on a lattice of the unit box: C = x, shear rate 2 + y, p = 3000 y - 500.
template <class P>
Closed closed(TrewhelaClosure const& with) {
  auto body = body_of<P, Concentration, ShearRate, Stress, SegregationVelocity, Diffusivity>(lattice<P::dim>(0.25), 1);
  set(body, concentration, [](auto const& x) { return x[0]; });
  set(body, shear_rate, [](auto const& x) { return 2 + x[1]; });
  set(body, stress, [](auto const& x) { return stress_of<P::dim>(3000 * x[1] - 500, 70); });
  for_each_particle<P>("closure", body, with);
  Closed found;
  for (auto const V : body.to_host(segregation_velocity)) found.V.push_back(double(V));
  for (auto const D : body.to_host(diffusivity)) found.D.push_back(double(D));
  return found;
}

/// Particles at rest whose stress and shear rate are given: one inertial number of the mean grains everywhere.
struct GivenFlow {
  double inertial_number = 0.05, pressure = 1e3;
  TrewhelaClosure closure;
  using reads = Fields<Concentration>;
  using writes = Fields<ShearRate, Stress>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    double const C = i[concentration], d = closure.d_small * C + closure.d_large * (1 - C);
    out[shear_rate] = inertial_number * Kokkos::sqrt(pressure / closure.grain_density) / d;
    auto sigma = zero<std::remove_cvref_t<decltype(out[stress])>>();
    for (int k = 0; k < 3; ++k) sigma[k] = -pressure;
    out[stress] = sigma;
  }
};
struct InGivenFlow {
  GivenFlow flow;
  using Segregation = ConservativeSegregation<TrewhelaClosure>;
  using evolves = Segregation::evolves;
  Segregation segregation() const { return {.closure = flow.closure}; }
  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(std::tuple(point_pass<Material>("given flow", flow)),
                          segregation().transport(resolution, Gravity{}));
  }
  auto limits(Resolution const& resolution) const { return segregation().limits(resolution); }
  template <class Whole>
  std::string warning_of_state(Whole const& body) const {
    return segregation().warning_of_state(body);
  }
};
using InFlow = Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, InGivenFlow>;
/// A mixture in a flow of one inertial number.
Solver<InFlow> mixture_at(double inertial_number, std::function<void(std::string const&)> const& warn = {}) {
  SolverSettings<InFlow> settings{.spacing = 0.125,
                                  .physics = {{.inertial_number = inertial_number, .closure = closure}}};
  settings.warn = warn;
  Solver<InFlow> solver(settings, lattice<2>(0.125), {});
  set_field(solver, concentration, [](auto const& x) { return 0.3 + 0.4 * x[1]; });
  return solver;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("V of Trewhela falls with the pressure, D does not", "", Policies) {
  using P = TestType;
  STATIC_CHECK(SegregationClosure<TrewhelaClosure, P>);
  auto const found = closed<P>(closure);
  std::size_t n = 0;
  double of_V = 0, of_D = 0, largest = 0;
  bool pulled = false, pressed = false;
  for (auto const& x : lattice<P::dim>(0.25)) {
    // Written in other terms: the speed of single large and of single small grains and a straight line between them.
    double const d = 0.25 - 0.15 * x[0], R = 2.5, p = std::max(0.0, 3000 * x[1] - 500), depth = p / (2000 * 10);
    pulled = pulled || 3000 * x[1] < 500, pressed = pressed || p > 0;
    double const scale = 0.7125 * (2 + x[1]) * d * d / (0.2712 * d + depth);
    double const of_large = scale * (R - 1), of_small = of_large + scale * 2.0957 * (R - 1) * (R - 1);
    double const V = x[0] * of_large + (1 - x[0]) * of_small;
    largest = std::max(largest, V);
    of_V = std::max(of_V, std::abs(found.V[n] - V));
    of_D = std::max(of_D, std::abs(found.D[n] - 0.108 * (2 + x[1]) * d * d));
    ++n;
  }
  CHECK(pulled);
  CHECK(pressed);
  CHECK(of_V < ulps<P>(64) * largest);
  CHECK(of_D < ulps<P>(16));
}

TEST_CASE("beads in the liquid of the experiment segregate by its constant, grains of one size do not") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto in_liquid = closure;
  in_liquid.buoyancy = 0.5255;
  auto printed = closure;
  printed.B = 0.3744;
  auto const a = closed<P>(in_liquid), b = closed<P>(printed), dry = closed<P>(closure);
  for (std::size_t i = 0; i < a.V.size(); ++i) {
    CHECK(std::abs(a.V[i] - b.V[i]) < 1e-4 * b.V[i]);
    CHECK(dry.V[i] > 1.9 * a.V[i]);
    CHECK(a.D[i] == dry.D[i]);
  }
  auto one_size = closure;
  one_size.d_large = one_size.d_small;
  for (double const V : closed<P>(one_size).V) CHECK(V == 0);
}

TEST_CASE("the gravity of the mechanics is that of the closure, whichever way it points") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto on_moon = closure;
  on_moon.gravity = 1.6;
  auto const a = closed<P>(closure.under({.magnitude = -1.6})), b = closed<P>(on_moon), here = closed<P>(closure);
  for (std::size_t i = 0; i < a.V.size(); ++i) {
    CHECK(a.V[i] == b.V[i]);
    CHECK(a.V[i] < here.V[i] * (1 + 1e-14));
  }
  for (double const V : closed<P>(closure.under({.magnitude = 0})).V) CHECK(V == 0);
}

TEST_CASE("a closure finds the share of the segregation at inertial numbers beyond its own") {
  for (double const I : {0.0101, 0.05, 0.099}) {
    auto solver = mixture_at(I);
    solver.update_rates();
    CHECK(beyond_fit(closure, solver.whole()).share == 0);
    CHECK(solver.settings().physics.warning_of_state(WholeBody(solver.material(), 1e3)).empty());
  }
  for (double const I : {0.0099, 0.101, 0.5}) {
    auto solver = mixture_at(I);
    solver.update_rates();
    auto const said = [&](double time) {
      return solver.settings().physics.warning_of_state(WholeBody(solver.material(), time));
    };
    // Before grains have moved by a diameter there is nothing to warn of: a flow begins slowly.
    double const crossed = closure.d_large / beyond_fit(closure, solver.whole()).speed;
    CHECK(said(0.99 * crossed).empty());
    CHECK(!said(1.01 * crossed).empty());
    CHECK(beyond_fit(closure, solver.whole()).share == 1);
    // The load decides which particles are within.
    auto loads = solver.material().to_host(stress);
    auto const V = solver.material().to_host(segregation_velocity), C = solver.material().to_host(concentration);
    double all = 0, beyond = 0, mixed = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      bool const within = i % 3 == 0;
      loads[i] *= sq(I / (within ? 0.05 : 0.2));
      double const flux = V[i] * C[i] * (1 - C[i]);
      all += flux, beyond += within ? 0 : flux, mixed += C[i] * (1 - C[i]);
    }
    std::size_t next = 0;
    solver.set(stress, [&](auto const&) { return loads[next++]; });
    auto const [share, speed] = beyond_fit(closure, solver.whole());
    CHECK(std::abs(speed - all / mixed) < 1e-12 * speed);
    CHECK(std::abs(share - beyond / all) < 1e-12);
    CHECK(share > 0.5);
    CHECK(share < 0.8);
  }
}

TEST_CASE("a run warns once where a closure was not fitted at two looks in a row") {
  std::vector<std::string> found;
  auto solver = mixture_at(0.2, [&](std::string const& text) { found.push_back(text); });
  for (int k = 0; k < 2000; ++k) solver.step(1);
  CHECK(found.empty());
  for (int k = 0; k < 200; ++k) solver.step(1);
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], ContainsSubstring("warning: 100 % of the segregation takes place at inertial numbers") &&
                           ContainsSubstring("after step"));
}

TEST_CASE("ranges of Trewhela's closure") {
  CHECK_NOTHROW(closure.check());
  CHECK(closure.warning().empty());
  auto far = closure;
  far.d_large = 0.5;
  CHECK_THAT(far.warning(), ContainsSubstring("TrewhelaClosure was fitted to grains whose sizes differ"));
  auto const refused = [](auto change, char const* what) {
    auto changed = closure;
    change(changed);
    CHECK_THROWS_WITH(changed.check(), ContainsSubstring(what));
  };
  refused([](auto& c) { c.d_small = 0; }, "d_small");
  refused([](auto& c) { c.d_large = 0.05; }, "`d_small` or more");
  refused([](auto& c) { c.buoyancy = 1.1; }, "buoyancy");
  refused([](auto& c) { c.C = 0; }, "C (-) of TrewhelaClosure");
  refused([](auto& c) { c.grain_density = 0; }, "grain_density");
}

}  // namespace scree::test::trewhela_closure_tests
