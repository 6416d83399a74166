// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Several bodies that evolve, each with a physics model of its own.
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/io/point_data_of.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/solver/describe.hpp>
#include <scree/solver/physics_of_bodies.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace scree::test::two_bodies_tests {
using namespace fields;

struct Sand : MaterialBody {
  static constexpr std::string_view name = "sand";
};
struct Block : MaterialBody {
  static constexpr std::string_view name = "block";
};

namespace {
using Catch::Matchers::ContainsSubstring;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

/// Without a filter, and with walls that store nothing.
template <class Law>
struct Plain : GranularModels {
  using law = Law;
  using filter = NoFilter;
  using walls = MirrorWalls;
};
template <class Law>
using Model = Granular<Plain<Law>>;

template <class OfSand, class OfBlock = OfSand>
using Pair = PhysicsOfBodies<EvolvedBy<Sand, OfSand>, EvolvedBy<Block, OfBlock>>;

template <class Q, class Physics, class Integrator = Midpoint, class List = Bodies<Sand, Block, Wall>>
struct TwoBodies : Formulated<Q, Physics> {
  using bodies = List;
  using integrator = Integrator;
};
template <class Q, class Integrator>
struct TwoGroups : Formulated<Q, Model<ByGroup<MuOfI<>>>> {
  using integrator = Integrator;
};

MuOfI<> sand_of(double density, double young, double mu_s) {
  return {.elastic = {young, 0.3, density}, .grains = {0.01}, .mu_s = mu_s};
}
template <int Dim>
using Vector = Vec<Dim, double>;

/// The largest difference of a field of two lists of particles, over the largest value.
template <class Values>
double difference(Values const& a, Values const& b) {
  double largest = 0, error = 0;
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, double(norm(a[k])));
    error = std::max(error, double(norm((a[k] - b[k]).eval())));
  }
  REQUIRE(largest > 0);
  return error / largest;
}
template <class S, class F>
auto of_both(S const& solver, F field) {
  auto all = solver.template body<Sand>().to_host(field);
  auto const others = solver.template body<Block>().to_host(field);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

template <class Q, class Integrator>
struct Case {
  using basis = Q;
  using integrator = Integrator;
};
template <class Integrator>
using Cases = std::tuple<Case<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Integrator>,
                         Case<Policy<3, double, Kokkos::DefaultHostExecutionSpace>, Integrator>>;
using AllCases = policy_lists::joined<Cases<Midpoint>, Cases<SymplecticEuler>, Cases<VelocityVerlet>,
                                      std::tuple<Case<Policy<2, float, Kokkos::DefaultHostExecutionSpace>, Midpoint>>>;
}  // namespace

TEMPLATE_LIST_TEST_CASE("two sands as bodies move as two groups of one body", "", AllCases) {
  using Q = typename TestType::basis;
  using Real = typename Q::real;
  constexpr int dim = Q::dim;
  double const dr = 0.1;
  auto const bed = open_bed<dim>(Vector<dim>::Constant(0.6), dr);
  auto points = bed.material;
  jitter(points, 0.1 * dr, 1);
  Points<dim> below, above;
  for (auto const& x : points) (x[dim - 1] < 0.3 ? below : above).push_back(x);
  Groups<dim> groups;
  groups.add("below", below).add("above", above);
  MuOfI<> const heavy = sand_of(2500, 2e5, 0.6), light = sand_of(1200, 1e5, 0.2);

  ByGroup<MuOfI<>> law(groups);
  law.set(0, heavy).set(1, light);
  using OneBody = TwoGroups<Q, typename TestType::integrator>;
  Groups<dim> walls;
  walls.add("wall", bed.wall);
  Solver<OneBody> one({.spacing = dr, .physics = {.law = law}, .start_checks = false}, groups, walls);
  using F = TwoBodies<Q, Pair<Model<MuOfI<>>>, typename TestType::integrator>;
  auto const sand = cast<Real>(below), block = cast<Real>(above), wall = cast<Real>(bed.wall);
  Solver<F> two({.spacing = dr, .physics = typename F::physics({.law = heavy}, {.law = light}), .start_checks = false},
                particles_of<Sand>(sand), particles_of<Block>(block), particles_of<Wall>(wall));
  for (int k = 0; k < 40; ++k) {
    double const dt = one.step(1), same = two.step(1);
    REQUIRE(std::abs(dt - same) <= ulps<Q>(10) * dt);
  }
  double const of_velocity = difference(one.material().to_host(velocity), of_both(two, velocity)),
               of_stress = difference(one.material().to_host(stress), of_both(two, stress));
  INFO("velocity " << of_velocity << ", stress " << of_stress << ", in units of rounding " << of_velocity / ulps<Q>(1));
  CHECK(of_velocity < ulps<Q>(4500));  // 1e-12 in double
  CHECK(of_stress < ulps<Q>(4500));
}

}  // namespace scree::test::two_bodies_tests
