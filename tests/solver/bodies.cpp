// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/formulation/describe.hpp>
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/io/point_data_of.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>
#include <scree/solver/wall_loads.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

namespace scree::test::bodies_tests {
using namespace fields;

struct Soil : MaterialBody {
  static constexpr std::string_view name = "soil";
};
struct Vessel : WallBody {
  static constexpr std::string_view name = "vessel";
};
struct Blade : WallBody {
  static constexpr std::string_view name = "blade";
};
/// Colours the particles of a body.
struct Colour {
  using reads = Fields<>;
  using writes = Fields<Concentration>;
  float colour;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[concentration] = colour;
  }
};

namespace {
using Catch::Matchers::ContainsSubstring;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
constexpr double dr = 0.1;

template <class Q, class Motion = AtRest>
struct ThreeBodies : Formulated<Q, Granular<>, Motion, WallForces> {
  using bodies = Bodies<Soil, Vessel, Blade>;
};
template <class Q, class Motion = AtRest>
using TwoBodiesOnly = Formulated<Q, Granular<>, Motion, WallForces>;

template <int Dim>
struct Places3 {
  Points<Dim> soil, vessel, blade;
};
/// A bed in a box; the blade stands on the floor within the bed.
template <int Dim>
Places3<Dim> places() {
  auto const bed = open_bed<Dim>(Vec<Dim, double>::Constant(8 * dr), dr);
  Places3<Dim> all{{}, bed.wall, {}};
  for (auto const& x : bed.material)
    (x[0] > 2 * dr && x[0] < 6 * dr && x[Dim - 1] < 4 * dr ? all.blade : all.soil).push_back(x);
  return all;
}
Granular<> sand() {
  Granular<> physics;
  physics.law.elastic = {1e5, 0.3, 1500};
  physics.law.grains = {0.01};
  return physics;
}
template <class F, class Motion>
Solver<F> three(Places3<F::dim> const& at, Motion const& motion) {
  using Real = typename F::real;
  auto const soil = cast<Real>(at.soil), vessel = cast<Real>(at.vessel), blade = cast<Real>(at.blade);
  return Solver<F>({.spacing = dr, .physics = sand(), .motion = motion}, particles_of<Blade>(blade),
                   particles_of<Soil>(soil), particles_of<Vessel>(vessel));
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a wall in two bodies acts on the material as in one", "", Policies) {
  using Q = TestType;
  constexpr int dim = Q::dim;
  auto const at = places<dim>();
  auto one_wall = at.vessel;
  one_wall.insert(one_wall.end(), at.blade.begin(), at.blade.end());
  auto one = solver_of<TwoBodiesOnly<Q>>({at.soil, one_wall}, dr, sand());
  auto several = three<ThreeBodies<Q>>(at, AtRest{});
  for (int k = 0; k < 40; ++k) {
    double const dt = one.step(1), same = several.step(1);
    REQUIRE(std::abs(dt - same) <= ulps<Q>(10) * dt);
  }
  auto const x = one.material().to_host(velocity), y = several.template body<Soil>().to_host(velocity);
  double largest = 0, error = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    largest = std::max(largest, double(norm(x[k])));
    error = std::max(error, double(norm((x[k] - y[k]).eval())));
  }
  CHECK(largest > 1e-2);
  CHECK(error < ulps<Q>(2e4) * largest);  // the sums are in another order

  one.update_diagnostics();
  several.update_diagnostics();
  auto const together = one.wall().to_host(wall_force);
  auto apart = several.template body<Vessel>().to_host(wall_force);
  auto const of_blade = several.template body<Blade>().to_host(wall_force);
  apart.insert(apart.end(), of_blade.begin(), of_blade.end());
  double force = 0, difference = 0;
  for (std::size_t k = 0; k < apart.size(); ++k) {
    force = std::max(force, double(norm(together[k])));
    difference = std::max(difference, double(norm((together[k] - apart[k]).eval())));
  }
  CHECK(force > 0);
  CHECK(difference < ulps<Q>(1e5) * force);
}

TEMPLATE_LIST_TEST_CASE("each body follows its own motion, and one that is not listed is at rest", "", Policies) {
  using Q = TestType;
  constexpr int dim = Q::dim;
  using Motions = MotionOfBodies<MovedBy<Blade, Translation<dim>>>;
  auto const at = places<dim>();
  Vec<dim, double> const speed = 0.2 * Vec<dim, double>::Unit(0);
  auto solver = three<ThreeBodies<Q, Motions>>(at, Motions(Translation<dim>{.speed = speed}));
  solver.run(0.01);
  auto const blade = solver.template body<Blade>().to_host(position),
             vessel = solver.template body<Vessel>().to_host(position);
  double error = 0;
  for (std::size_t k = 0; k < blade.size(); ++k)
    error = std::max(error, (blade[k].template cast<double>() - at.blade[k] - 0.01 * speed).norm());
  for (std::size_t k = 0; k < vessel.size(); ++k)
    error = std::max(error, (vessel[k].template cast<double>() - at.vessel[k]).norm());
  CHECK(error < ulps<Q>(10));
  Vec<dim, double> const u = solver.template body<Blade>().to_host(velocity)[0].template cast<double>();
  CHECK((u - speed).norm() < 1e-6);
}

TEST_CASE("three bodies go on from a snapshot bit for bit") {
  using F = ThreeBodies<OnHost>;
  auto const at = places<2>();
  auto before = three<F>(at, AtRest{});
  for (int k = 0; k < 30; ++k) before.step(1);
  auto const snapshot = before.snapshot();
  CHECK_THAT(snapshot.signature, ContainsSubstring("soil particles: ") && ContainsSubstring("vessel particles: ") &&
                                     ContainsSubstring("blade particles: "));
  auto after = three<F>(at, AtRest{});
  after.restore(snapshot);
  for (int k = 0; k < 60; ++k) {
    before.step(1);
    after.step(1);
  }
  CHECK(before.material().to_host(position) == after.material().to_host(position));
  CHECK(before.material().to_host(stress) == after.material().to_host(stress));
}

TEST_CASE("a pass over a body leaves the others alone, and one over walls is over all of them") {
  struct Painted {
    using evolves = Fields<>;
    auto passes(Resolution const&) const {
      return std::tuple(point_pass<Wall>("walls", Colour{1}), point_pass<Blade>("blade", Colour{2}),
                        point_pass<Soil>("soil", Colour{3}));
    }
    std::tuple<> limits(Resolution const&) const { return {}; }
  };
  struct F : Formulated<OnHost, Painted> {
    using bodies = Bodies<Vessel, Soil, Blade>;  // in any order
  };
  auto const at = places<2>();
  Solver<F> solver({.spacing = dr}, particles_of<Soil>(at.soil), particles_of<Vessel>(at.vessel),
                   particles_of<Blade>(at.blade));
  solver.update_rates();
  auto const all = [](std::vector<float> const& values, float expected) {
    return !values.empty() && std::all_of(values.begin(), values.end(), [&](float x) { return x == expected; });
  };
  auto const colours = [&](auto const& body) {
    auto const values = body.to_host(concentration);
    return std::vector<float>(values.begin(), values.end());
  };
  CHECK(all(colours(solver.body<Vessel>()), 1));
  CHECK(all(colours(solver.body<Blade>()), 2));
  CHECK(all(colours(solver.material()), 3));
  CHECK_THAT(describe(solver), ContainsSubstring("writes blade: concentration"));
  auto const written = point_data_of(solver, Fields<Concentration>{}, Bodies<Soil, Blade>{});
  auto const& number = std::get<std::vector<std::int32_t>>(written.arrays[1].values);
  CHECK(number.front() == 1);
  CHECK(number.back() == 2);
}

TEST_CASE("a formulation may have no walls at all") {
  struct F : Formulated<OnHost, Granular<>> {
    using bodies = Bodies<Soil>;
  };
  auto physics = sand();
  physics.gravity = {};
  auto const at = places<2>();
  Solver<F> solver({.spacing = dr, .physics = physics, .lost_share = 1}, particles_of<Soil>(at.soil));
  solver.step(1);
  CHECK(solver.material().size() == int(at.soil.size()));
}

TEST_CASE("particles that no body can take are refused") {
  using F = ThreeBodies<OnHost>;
  auto const at = places<2>();
  CHECK_THROWS_WITH(Solver<F>({.spacing = dr, .physics = sand()}, at.soil, at.vessel),
                    ContainsSubstring("2 bodies that are a wall: name each with particles_of<Body>(points)"));
  auto const half = share_of(at.soil, ShareOfRank{0, 2}), whole = share_of(at.soil, ShareOfRank{0, 1});
  CHECK_THROWS_WITH(Solver<F>({.spacing = dr, .physics = sand()}, particles_of<Soil>(half)),
                    ContainsSubstring("points is given, and the solver has no ranks"));
  CHECK_NOTHROW(Solver<F>({.spacing = dr, .physics = sand(), .lost_share = 1}, particles_of<Soil>(whole)));
  CHECK_THROWS_WITH(
      Solver<F>({.spacing = dr, .physics = sand()}, particles_of<Soil>(at.soil), particles_of<Material>(at.soil)),
      ContainsSubstring("given twice"));
}

}  // namespace scree::test::bodies_tests
