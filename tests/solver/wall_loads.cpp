// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/translation.hpp>
#include <scree/solver/wall_loads.hpp>

#include <support/formulations.hpp>

#include <Eigen/Geometry>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::wall_loads_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;
using V = Vec<2, double>;
using X = Vec<3, double>;

template <int Dim>
using Motion = MotionOfGroups<2, Translation<Dim>>;
template <class Q>
using Sand = Formulated<Q, Granular<>, Motion<Q::dim>, WallForces>;
double const spacing = 0.1;

template <int Dim>
Groups<Dim> walls() {
  auto const all = open_bed<Dim>(Vec<Dim, double>::Constant(0.6), spacing).wall;
  std::vector<Vec<Dim, double>> floor, sides;
  for (auto const& x : all) (x[Dim - 1] < 0 ? floor : sides).push_back(x);
  return Groups<Dim>().add("sides", sides).add("floor", floor);
}
/// A bed under stress between a floor at rest and sides that move.
template <class Q>
Solver<Sand<Q>> pressed(Groups<Q::dim> const& wall) {
  constexpr int dim = Q::dim;
  using Real = typename Q::real;
  Motion<dim> motion(wall);
  motion.set(wall.number("sides"), Translation<dim>{.speed = Vec<dim, double>::Constant(0.3)});
  Granular<> physics;
  physics.law.elastic = {1e5, 0.3, 1500};
  physics.law.grains = {0.01};
  Solver<Sand<Q>> solver({.spacing = spacing, .physics = physics, .motion = motion},
                         cast<Real>(open_bed<dim>(Vec<dim, double>::Constant(0.6), spacing).material), wall);
  solver.set(stress, [](auto const& x) {
    Vec<symmetric3_size<dim>, Real> sigma = Vec<symmetric3_size<dim>, Real>::Zero();
    for (int a = 0; a < 3; ++a) sigma[a] = Real(-1e4) * (1 - x[dim - 1] - Real(0.3) * x[0]);
    return sigma;
  });
  return solver;
}
using Some = std::tuple<Policy<2, double, Kokkos::DefaultHostExecutionSpace>,
                        Policy<3, float, Kokkos::DefaultHostExecutionSpace>>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("the loads of groups are the sums over their particles", "", Some) {
  constexpr int dim = TestType::dim;
  using Point = Vec<dim, double>;
  auto const wall = walls<dim>();
  auto solver = pressed<TestType>(wall);
  Point const about = Point::Constant(0.2);
  auto const loads = wall_loads(solver, wall, about);
  auto const y = solver.wall().to_host(position), F = solver.wall().to_host(wall_force);
  REQUIRE(loads.size() == 2);
  for (auto const& load : loads) {
    auto const range = wall.range(load.name);
    Point force = Point::Zero();
    X moment = X::Zero();
    for (int w = range.first; w < range.last; ++w) {
      auto const k = static_cast<std::size_t>(w);
      force += F[k].template cast<double>();
      X arm = X::Zero(), of_one = X::Zero();
      arm.template head<dim>() = y[k].template cast<double>() - about;
      of_one.template head<dim>() = F[k].template cast<double>();
      moment += arm.cross(of_one);
    }
    double const scale = force.norm();
    REQUIRE(scale > 100);
    CHECK((load.force - force).norm() < 1e-12 * scale);
    if constexpr (dim == 2)
      CHECK(std::abs(load.moment - moment[2]) < 1e-12 * scale);
    else
      CHECK((load.moment - moment).norm() < 1e-12 * scale);
    double const power = load.name == "sides" ? 0.3 * force.sum() : 0;
    CHECK(std::abs(load.power - power) < ulps<TestType>(4) * scale);
    auto const alone = wall_load(solver, wall, load.name, about);
    CHECK((alone.name == load.name && alone.force == load.force && alone.moment == load.moment));
  }
  CHECK(loads[0].name == "sides");
}

TEST_CASE("loads are those of other groups of the same particles, too") {
  using Q = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto const wall = walls<2>();
  auto solver = pressed<Q>(wall);
  auto const whole = wall_load(solver, Groups<2>().add("all", wall.points()), "all");
  auto const parts = wall_loads(solver, wall);
  CHECK((whole.force - parts[0].force - parts[1].force).norm() < 1e-11 * whole.force.norm());
  CHECK(std::abs(whole.moment - parts[0].moment - parts[1].moment) < 1e-11 * whole.force.norm());
  CHECK_THROWS_WITH(wall_load(solver, wall, "lid"), ContainsSubstring("no group 'lid'"));
  CHECK_THROWS_WITH(wall_loads(solver, Groups<2>()), ContainsSubstring("these groups have 0 particles"));
}

TEST_CASE("in the plane a moment is positive from the first towards the last axis") {
  WallLoad<2> load;
  load.add(V(0, 2), V(3, 0), V(0, 1));
  CHECK((load.moment == 6 && load.power == 2 && load.force == V(0, 2)));
  WallLoad<3> in_space;
  in_space.add(X(0, 0, 2), X(3, 0, 0), X(0, 0, -1));
  CHECK((in_space.moment == X(0, -6, 0) && in_space.power == -2));
}

}  // namespace scree::test::wall_loads_tests
