// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Solvers are made of the choices of a formulation, whatever its name; scree::compiled has those of the default
// choices.
#include <scree/granular/granular.hpp>
#include <scree/motion/translation.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <string>
#include <type_traits>

namespace scree::test::choices_tests {
using namespace fields;
namespace {
template <class P>
using State = detail::SolverState<detail::choices_of<P>>;

struct Sand : Formulation<2> {
  using physics = Granular<>;
};
struct Gravel : Formulation<2, double> {
  using physics = Granular<GranularModels>;
  static constexpr char const* colour = "grey";  // no choice of a formulation
};
struct Slow : Sand {
  using motion = Translation<2>;
};
template <int Dim, class Real>
struct In {
  static constexpr int dim = Dim;
  using real = Real;
};
template <class Q>
struct InLibrary : Formulation<Q::dim, typename Q::real> {
  using physics = Granular<>;
};
struct Later : Slow {};
struct NoneAtAll {
  std::tuple<> passes(Resolution const&) const { return {}; }
};
/// The same solver with choices of its own, so that this file compiles it.
template <class Q>
struct CompiledHere : InLibrary<Q> {
  using diagnostics = NoneAtAll;
};

/// A block that falls on a floor, with a filter that runs often.
template <class P>
Solver<P> falling() {
  constexpr int dim = P::dim;
  using real = typename P::real;
  Vec<dim, double> low = Vec<dim, double>::Zero(), high = Vec<dim, double>::Constant(0.4);
  auto const block = fill_lattice(Box<dim>{low, high}, 0.1);
  low = Vec<dim, double>::Constant(-0.3), high = Vec<dim, double>::Constant(0.7);
  high[dim - 1] = 0;
  auto const floor = fill_lattice(Box<dim>{low, high}, 0.1);
  SolverSettings<P> settings{.spacing = 0.1, .warn = {}};
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}};
  settings.physics.filter.period = 7;
  Solver<P> solver(settings, cast<real>(block), cast<real>(floor));
  solver.set(velocity, [](auto const& x) {
    auto u = x;
    u *= 2;
    return u;
  });
  return solver;
}
template <class A, class B>
void require_same(A const& a, B const& b) {
  REQUIRE(a.time() == b.time());
  REQUIRE(a.limits() == b.limits());
  REQUIRE(a.material().to_host(position) == b.material().to_host(position));
  REQUIRE(a.material().to_host(velocity) == b.material().to_host(velocity));
  REQUIRE(a.material().to_host(stress) == b.material().to_host(stress));
}

TEST_CASE("choices: formulations that choose the same have one class of states") {
  STATIC_REQUIRE(std::is_same_v<State<Sand>, State<Gravel>>);
  STATIC_REQUIRE(!std::is_same_v<State<Sand>, State<Slow>>);
  STATIC_REQUIRE(!std::is_same_v<State<Sand>, State<InLibrary<In<3, double>>>>);
  STATIC_REQUIRE(std::is_same_v<detail::choices_of<Sand>, detail::choices_of<detail::choices_of<Sand>>>);
  STATIC_REQUIRE(!std::is_same_v<Solver<Sand>, Solver<Gravel>>);  // components and observers are of one or the other
}

TEST_CASE("choices: settings of one formulation are those of another that chooses the same") {
  SolverSettings<Slow> given{.spacing = 0.1, .smoothing = 1.7};
  given.physics.cfl = 0.125, given.motion.speed = {3, 0};
  given.periods = {{1, -2, 4}};
  given.sort_period = 11, given.lost_share = 0.25, given.start_checks = false;
  std::string text;
  given.warn = [&](std::string const& warning) { text = warning; };

  SolverSettings<Later> const taken = given;
  REQUIRE(taken.spacing == 0.1);
  REQUIRE(taken.smoothing == 1.7);
  REQUIRE(taken.physics.cfl == 0.125);
  REQUIRE(taken.motion.speed == Vec<2, double>(3, 0));
  REQUIRE(taken.periods.size() == 1);
  REQUIRE(taken.periods[0].axis == 1);
  REQUIRE(taken.sort_period == 11);
  REQUIRE(taken.lost_share == 0.25);
  REQUIRE(!taken.start_checks);
  taken.warn("heard");
  REQUIRE(text == "heard");
  STATIC_REQUIRE(!std::is_convertible_v<SolverSettings<Slow>, SolverSettings<Sand>>);
}

TEMPLATE_TEST_CASE("choices: a solver of the library and one that is compiled here give the same bits", "",
                   (In<2, double>), (In<3, double>), (In<2, float>), (In<3, float>)) {
  using Q = TestType;
  auto library = falling<InLibrary<Q>>();
  auto here = falling<CompiledHere<Q>>();
  library.run(0.1), here.run(0.1);
  require_same(library, here);
  REQUIRE(library.steps() > 20);

  auto again = falling<CompiledHere<Q>>();
  again.restore(library.snapshot());
  again.run(0.13), library.run(0.13);
  require_same(library, again);
}

}  // namespace
}  // namespace scree::test::choices_tests
