// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/laws/by_group.hpp>

#include <scree/granular/granular.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::by_group_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

/// A particle of a group.
struct Point {
  int number;
  int operator[](Group) const { return number; }
  double operator[](ShearRate) const { return 0.5; }
};
MuOfI<> sand(double density, double mu_s) { return {.elastic = {1e6, 0.3, density}, .grains = {1e-3}, .mu_s = mu_s}; }
Groups<2> two_layers(double spacing = 0.1) {
  Groups<2> groups;
  groups.add("below", fill_lattice(Box<2>{{0, 0}, {1, 0.5}}, spacing))
      .add("above", fill_lattice(Box<2>{{0, 0.5}, {1, 1}}, spacing));
  return groups;
}
struct Models : GranularModels {
  using law = ByGroup<MuOfI<>>;
};
struct Layers : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models>;
};

}  // namespace

static_assert(ConstitutiveLaw<ByGroup<MuOfI<>>>);
static_assert(ConstitutiveLaw<ByGroup<Hypoplastic>>);

TEST_CASE("each group has its own parameters") {
  auto const groups = two_layers();
  ByGroup<MuOfI<>> law(groups);
  law.set(groups.number("above"), sand(1000, 0.2)).set(groups.number("below"), sand(2000, 0.6));
  CHECK(law.density(Point{0}) == 2000);
  CHECK(law.density(Point{1}) == 1000);
  StressTensor<double> const p = -100 * identity_matrix<StressTensor<double>>();
  CHECK(law.sound_speed(p, Point{0}) == sand(2000, 0.6).sound_speed());
  CHECK(law.bulk_modulus(p, Point{1}) == sand(1000, 0.2).bulk_modulus());
  for (int const number : {0, 1}) {
    auto const expected = number == 0 ? sand(2000, 0.6) : sand(1000, 0.2);
    CHECK(law.shear_strength(100.0, Point{number}) == expected.shear_strength(100.0, Point{number}));
    StressTensor<double> trial = p;
    trial(0, 1) = trial(1, 0) = 90;
    Results<scree::detail::AnyPoint, Fields<>> none;
    CHECK(law.admissible(trial, Point{number}, none) == expected.admissible(trial, Point{number}, none));
    Mat<3, double> const L = Vec<3, double>(-1, 2, 0.5).asDiagonal();
    CHECK(law.stress_rate(p, L, Point{number}) == expected.stress_rate(p, L, Point{number}));
  }
}

TEST_CASE("groups without parameters and groups that do not exist are errors") {
  auto const groups = two_layers();
  ByGroup<MuOfI<>> law(groups);
  law.set(0, sand(2000, 0.6));
  CHECK_THROWS_WITH(law.check(), ContainsSubstring("group 1 of ByGroup has no law"));
  CHECK_THROWS_WITH(ByGroup<MuOfI<>>{}.check(), ContainsSubstring("ByGroup has no groups"));
  CHECK_THROWS_WITH(law.set(2, sand(1000, 0.2)), ContainsSubstring("no group 2"));
  law.set(1, sand(-1, 0.2));
  CHECK_THROWS_WITH(law.check(), ContainsSubstring("density"));
  CHECK_THROWS_WITH((ByGroup<MuOfI<>, 1>(groups)), ContainsSubstring("at most 1 groups, not 2"));
}

TEST_CASE("a solver with a law by group needs groups, and the law those of the solver") {
  auto const groups = two_layers();
  Granular<Models> physics{.law = ByGroup<MuOfI<>>(groups)};
  physics.law.set(0, sand(2000, 0.6)).set(1, sand(1000, 0.2));
  SolverSettings<Layers> const settings{.spacing = 0.1, .physics = physics};
  Solver<Layers> from_points(settings, groups.points());
  CHECK_THROWS_WITH(from_points.step(1e-5), ContainsSubstring("group"));
  auto three = groups;
  three.add("beside", fill_lattice(Box<2>{{1, 0}, {1.5, 0.5}}, 0.1));
  Solver<Layers> with_three(settings, three);
  CHECK_THROWS_WITH(with_three.step(1e-5), ContainsSubstring("number of a group beyond those of the law"));
  Solver<Layers> solver(settings, groups);
  CHECK_NOTHROW(solver.step(1e-5));
  auto const rho = solver.material().to_host(density);
  CHECK(rho.front() == 2000);
  CHECK(rho.back() == 1000);
}

}  // namespace scree::test::by_group_tests
