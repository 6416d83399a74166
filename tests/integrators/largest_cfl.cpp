// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>

namespace scree::test::largest_cfl_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

template <class Integrator, class Physics = Granular<>>
struct Bed : Formulation<2> {
  using physics = Physics;
  using integrator = Integrator;
};
double const dr = 0.05, depth = 0.5;  // m

MuOfI<> sand() { return {.elastic = {1e6, 0.3, 1500}, .grains = {5e-3}}; }
/// A bed at rest on a rough floor, with the exact stress.
template <class F>
Solver<F> bed(typename F::physics const& physics) {
  Solver<F> solver({.spacing = dr, .physics = physics, .periods = {{0, 0, 0.6}}},
                   fill_lattice(Box<2>{{0, 0}, {0.6, depth}}, dr), fill_lattice(Box<2>{{0, -4 * dr}, {0.6, 0}}, dr));
  Geostatic const exact{depth, 1500, 9.81, 0.6};
  solver.set(stress, [&](Vec<2, double> const& x) { return packed<2>(Mat<3, double>(exact(x))); });
  return solver;
}
template <class Integrator>
Solver<Bed<Integrator>> bed_at(double cfl) {
  return bed<Bed<Integrator>>({.law = sand(), .cfl = cfl});
}

/// A user's integrators, without and with a bound.
struct Own {
  template <class Evolved>
  using fields = Midpoint::fields<Evolved>;
  template <class Solver>
  static double advance(Solver& solver, double longest) {
    return Midpoint::advance(solver, longest);
  }
};
struct OwnStaggered {
  static constexpr bool staggered = true;
  template <class Evolved>
  using fields = SymplecticEuler::fields<Evolved>;
  template <class Solver>
  static double advance(Solver& solver, double longest) {
    return SymplecticEuler::advance(solver, longest);
  }
};
struct Careful : OwnStaggered {
  static constexpr double largest_cfl = 0.1;
  static constexpr char const* name = "Careful";
};

}  // namespace

TEMPLATE_TEST_CASE("a bed at rest neither swells nor boils at the largest cfl", "", Midpoint, SymplecticEuler,
                   VelocityVerlet) {
  auto solver = bed_at<TestType>(TestType::largest_cfl);
  solver.run(1);
  double top = 0, fastest = 0;
  for (auto const& x : solver.material().to_host(position)) top = std::max(top, x[1]);
  for (auto const& u : solver.material().to_host(velocity)) fastest = std::max(fastest, u.norm());
  CHECK(std::abs(top - (depth - dr / 2)) < 0.02 * dr);
  CHECK(fastest < 5e-3);  // a tenth of that at cfl 0.4 with the midpoint scheme
}

TEST_CASE("a cfl above that of the integrator is refused before the first step, by the name of the integrator") {
  CHECK_THROWS_WITH(
      bed_at<Midpoint>(0.31).run(1),
      StartsWith("scree: cfl (-) must be at most 0.3 with the integrator Midpoint") && ContainsSubstring("not 0.31"));
  CHECK_THROWS_WITH(bed_at<Midpoint>(1).step(1), ContainsSubstring("not 1"));
  CHECK_NOTHROW(bed_at<SymplecticEuler>(1).step(1));
  CHECK_NOTHROW(bed_at<VelocityVerlet>(1).step(1));
  CHECK_THROWS_WITH(bed_at<SymplecticEuler>(1.01).step(1), StartsWith("scree: cfl (-) must be above 0 and at most 1"));
}

TEST_CASE("an integrator of a user has the bound that it names, or that of its kind") {
  STATIC_CHECK(largest_cfl<Own>() == 0.3);
  STATIC_CHECK(largest_cfl<OwnStaggered>() == 1);
  STATIC_CHECK(largest_cfl<Careful>() == 0.1);
  CHECK_THROWS_WITH(bed_at<Own>(0.4).step(1), StartsWith("scree: cfl (-) must be at most 0.3 with the integrator,"));
  CHECK_NOTHROW(bed_at<OwnStaggered>(0.9).step(1));
  CHECK_THROWS_WITH(bed_at<Careful>(0.2).step(1), StartsWith("scree: cfl (-) must be at most 0.1 with the integrator "
                                                             "Careful"));
}

TEST_CASE("the cfl of mechanics that carry a transport has the same bound") {
  using Sorting = SegregatingGranular<Granular<>, ConservativeSegregation<ConstantClosure>>;
  Sorting physics;
  physics.mechanics.law = sand(), physics.transport.closure = {1e-3, 1e-6};
  auto solver = [&](double cfl) {
    physics.mechanics.cfl = cfl;
    auto made = bed<Bed<Midpoint, Sorting>>(physics);
    made.set(concentration, [](auto const&) { return 0.5; });
    return made;
  };
  CHECK_NOTHROW(solver(0.3).step(1));
  CHECK_THROWS_WITH(solver(0.4).step(1), ContainsSubstring("at most 0.3 with the integrator Midpoint"));
}

}  // namespace scree::test::largest_cfl_tests
