// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/plates.hpp>
#include <scree/granular/granular.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/set_group.hpp>
#include <scree/solver/solver.hpp>

#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <stdexcept>
#include <string>
#include <type_traits>

// A solver looks for thin walls where its particles are, and has the host name one of them.
namespace scree::test::start_of_solver_tests {
namespace {

using Catch::Matchers::ContainsSubstring;

struct WithPlates : GranularModels {
  using walls = PlateWalls;
};
template <class P, class Models, class Motion>
struct Divided : Formulation<P::dim, typename P::real> {
  using space = typename P::space;
  using physics = Granular<Models>;
  using motion = Motion;
};

/// The refusal of a box of sand that has a floor of some rows and, unless it has none, a divider of some rows between
/// two beds; "" if it may start.
template <class P, class Models, class Motion = AtRest>
std::string refusal(int rows_of_floor, int rows_of_divider, Motion const& motion = {}, double smoothing = 1.5) {
  constexpr int dim = P::dim;
  using F = Divided<P, Models, Motion>;
  double const dr = 0.1;
  auto const box = [&](double x0, double y0, double x1, double y1) {
    Box<dim> all{Vec<dim, double>::Zero(), Vec<dim, double>::Constant(8 * dr)};
    all.low[0] = x0 * dr, all.high[0] = x1 * dr, all.low[dim - 1] = y0 * dr, all.high[dim - 1] = y1 * dr;
    return fill_lattice(all, dr);
  };
  double const side = 8, thick = rows_of_divider;
  Groups<dim> walls, sand;
  walls.add("floor", box(0, -rows_of_floor, 2 * side + thick, 0));
  if (thick > 0) walls.add("divider", box(side, 0, side + thick, 12));
  sand.add("left", box(0, 0, side, 10)), sand.add("right", box(side + thick, 0, 2 * side + thick, 10));
  SolverSettings<F> settings{.spacing = dr, .smoothing = smoothing, .warn = [](std::string const&) {}};
  settings.motion = motion;
  settings.physics.law = {.elastic = {.young = 1e6, .poisson = 0.3, .rest_density = 1500}, .grains = {1e-3}};
  Solver<F> solver(settings, sand, walls);
  if constexpr (std::is_same_v<Models, WithPlates>)
    if (thick > 0) set_group<Wall>(solver, fields::on_plate, walls, "divider", [](auto const&) { return 1; });
  try {
    solver.check_start();
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a solver with a thin wall does not start, wherever its particles are", "", Policies) {
  using P = TestType;
  CHECK(refusal<P, GranularModels>(3, 0) == "");
  CHECK(refusal<P, GranularModels>(2, 0) == "");
  CHECK_THAT((refusal<P, GranularModels>(1, 0)), ContainsSubstring("it has one row of particles"));
  CHECK_THAT((refusal<P, GranularModels>(3, 3)),
             ContainsSubstring("it has material on both sides, 3 spacings apart, and shows each the mean of both"));
  CHECK(refusal<P, GranularModels>(3, 4) == "");
  CHECK_THAT((refusal<P, WithPlates>(3, 1)), ContainsSubstring("material acts on material through a plate of 1 spac"));
  CHECK(refusal<P, WithPlates>(3, 2) == "");
  Rotation const turning{.rate = 1};
  CHECK_THAT((refusal<P, WithPlates>(3, 2, turning)), ContainsSubstring("a plate of 2 spacings turns"));
  CHECK(refusal<P, WithPlates>(3, 3, turning) == "");
}

TEMPLATE_LIST_TEST_CASE("the support that walls have to fill is that of the solver", "", Policies) {
  using P = TestType;
  auto const sees_through = [](double smoothing, int rows) {
    auto const text = refusal<P, GranularModels>(rows, 0, {}, smoothing);
    if (text != "") CHECK_THAT(text, ContainsSubstring("the material in front sees through the wall"));
    return text != "";
  };
  CHECK(sees_through(2.5, 3));
  CHECK(!sees_through(2.5, 4));
  CHECK(sees_through(3, 4));
  CHECK(!sees_through(3, 5));
  CHECK(!sees_through(1.1, 2));
}

}  // namespace scree::test::start_of_solver_tests
