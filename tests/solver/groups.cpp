// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/delayed.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/solver/set_group.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <numbers>

namespace scree::test::groups_tests {
using namespace fields;

/// Adds fields to a body that a motion can give, and changes nothing.
template <class... Fs>
struct Carries {
  using reads = Fields<Fs...>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[concentration_rate] = 0;
  }
};
/// The concentration is the number of the group.
struct MarkGroups {
  using reads = Fields<Group>;
  using writes = Fields<Concentration>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[concentration] = i[group];
  }
};

namespace {
using Catch::Matchers::ContainsSubstring;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using V = Vec<2, double>;

/// Walls with all fields that a motion gives; material that follows the motion, too.
struct Followed {
  using evolves = Fields<Concentration>;
  auto passes(Resolution const&) const {
    return std::tuple(point_pass<Wall>("wall", Carries<Velocity, Acceleration, VelocityGradient>{}),
                      point_pass<Material>("material", Carries<Velocity>{}));
  }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
/// Material that moves on its own.
struct Own {
  using evolves = Fields<Velocity, Position>;
  auto passes(Resolution const&) const {
    return std::tuple(point_pass<Wall>("wall", Carries<Velocity, Acceleration, VelocityGradient>{}),
                      point_pass<Material>("material", Fall{}));
  }
  auto limits(Resolution const&) const { return std::tuple(limit("step", 1e-3)); }
  struct Fall {
    using reads = Fields<>;
    using writes = Fields<Acceleration>;
    template <class I, class O>
    SCREE_FN void operator()(I const&, O& out) const {
      for (int axis = 0; axis < out[acceleration].size(); ++axis) out[acceleration][axis] = -1;
    }
  };
};

/// Two plates, and a bar between them.
template <int Dim>
Groups<Dim> plates() {
  auto const at = [](double low, double high) {
    Box<Dim> box{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(1)};
    box.low[Dim - 1] = low, box.high[Dim - 1] = high;
    return fill_lattice(box, 0.25);
  };
  return Groups<Dim>().add("floor", at(-1, -0.5)).add("bar", at(0.5, 1)).add("lid", at(2, 2.5));
}

template <int Dim>
using Motions = MotionOfGroups<3, Rotation, Delayed<Oscillation<Dim>>>;
template <int Dim>
Motions<Dim> motion_of_plates() {
  Vec<Dim, double> swing = Vec<Dim, double>::Constant(0.1);
  Motions<Dim> motion(plates<Dim>());
  motion.set(0, Rotation{.rate = 0.5, .centre_x = 0.5});
  motion.set(2, Delayed<Oscillation<Dim>>{.motion = {.amplitude = swing, .period = 2}, .start = 0.3});
  return motion;
}
template <class P>
Solver<P> solver_with(Groups<P::dim> const& walls, typename P::motion const& motion) {
  return Solver<P>({.spacing = 0.25, .motion = motion, .lost_share = 1, .start_checks = false}, {}, walls);
}

template <class P>
using ByGroup = Formulated<P, Own, Motions<P::dim>>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("each group of a wall follows its own motion", "", Policies) {
  using P = ByGroup<TestType>;
  constexpr int dim = P::dim;
  using Real = typename P::real;
  auto const walls = plates<dim>();
  auto const motion = motion_of_plates<dim>();
  Solver<P> solver({.spacing = 0.25, .motion = motion, .lost_share = 1, .start_checks = false},
                   cast<Real>(lattice<dim>(0.25)), walls);
  for (double const until : {0.0, 0.2, 0.9}) {
    solver.run(until);
    auto const x = solver.wall().to_host(position), rest = solver.wall().to_host(rest_position);
    auto const u = solver.wall().to_host(velocity), a = solver.wall().to_host(acceleration);
    auto const L = solver.wall().to_host(velocity_gradient);
    auto const numbers = solver.wall().to_host(group);
    REQUIRE(numbers == walls.numbers());
    double worst = 0;
    for (std::size_t w = 0; w < x.size(); ++w) {
      using X = Vec<dim, double>;
      auto const& own = motion.of(numbers[w]);
      X const expected = own.displaced(X(rest[w].template cast<double>()), 0.0, until);
      X const there = x[w].template cast<double>();
      worst = std::max({worst, (there - expected).norm(),
                        (u[w].template cast<double>() - own.velocity(there, until)).norm(),
                        (a[w].template cast<double>() - own.acceleration(there, until)).norm(),
                        (L[w].template cast<double>() - own.velocity_gradient(there, until)).norm()});
    }
    CHECK(worst < ulps<TestType>(8));
  }
  // At 0.9 s the floor has turned by 0.45 rad, the lid is at sin(0.6 pi) of its swing, the bar has not moved.
  auto const moved = [&](std::string const& name) {
    auto const range = walls.range(name);
    auto const at = static_cast<std::size_t>(range.first);
    return double((solver.wall().to_host(position)[at] - solver.wall().to_host(rest_position)[at]).norm());
  };
  CHECK(moved("bar") == 0);
  CHECK(moved("floor") > 0.3);
  CHECK(std::abs(moved("lid") - 0.1 * std::sqrt(dim) * std::sin(0.6 * std::numbers::pi)) < 1e-6);
}

TEST_CASE("material that follows the motion follows that of its group") {
  using P = Formulated<OnHost, Followed, Motions<2>>;
  auto const all = plates<2>();
  auto const motion = motion_of_plates<2>();
  Solver<P> solver({.spacing = 0.25, .motion = motion, .start_checks = false}, all, all);
  solver.run(0.7);
  auto const x = solver.material().to_host(position), y = solver.wall().to_host(position);
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k) worst = std::max(worst, (x[k] - y[k]).norm());
  CHECK(worst < 1e-13);  // the sum of 60 displacements against a single one
  CHECK(solver.material().to_host(velocity) != std::vector<V>(x.size(), V(0, 0)));
  CHECK_THROWS_WITH((Solver<P>({.spacing = 0.25, .motion = motion}, all.points(), all)),
                    ContainsSubstring("the material has none: make the solver from Groups"));
}

TEST_CASE("groups that the motion does not know are refused at the start, and so are walls without groups") {
  using P = ByGroup<OnHost>;
  auto const walls = plates<2>();
  CHECK_THROWS_WITH(solver_with<P>(walls, Motions<2>(2)),
                    ContainsSubstring("group 2 of the wall, 'lid', has no motion: the motion is that of 2 groups"));
  CHECK_THROWS_WITH(solver_with<P>(walls, {}), ContainsSubstring("group 0 of the wall, 'floor'"));
  CHECK_THROWS_WITH((Solver<P>({.spacing = 0.25, .motion = Motions<2>(3)}, {}, walls.points())),
                    ContainsSubstring("the motion is by group, and the wall has none"));
  CHECK_NOTHROW(Solver<P>({.spacing = 0.25}, lattice<2>(0.25)));  // no walls
  CHECK_NOTHROW(solver_with<P>(walls, Motions<2>(3)));
}

TEST_CASE("the velocity must be affine in each group, not over all of them") {
  struct Bent {
    V displaced(V const& x, double, double) const { return x; }
    V velocity(V const& x, double) const { return {x[1] * x[1], 0}; }
    V acceleration(V const&, double) const { return {0, 0}; }
    double time_step() const { return 1; }
  };
  using P = Formulated<OnHost, Own, MotionOfGroups<3, Rotation, Bent>>;
  MotionOfGroups<3, Rotation, Bent> motion(3);
  motion.set(0, Rotation{.rate = 2}).set(1, Rotation{.rate = -3, .centre_x = 0.7});
  CHECK_NOTHROW(solver_with<P>(plates<2>(), motion));
  motion.set(1, Bent{});
  CHECK_THROWS_WITH(solver_with<P>(plates<2>(), motion), ContainsSubstring("or over one of its groups"));
}

TEST_CASE("particles are lost beyond the walls where each group is") {
  // The lid moves up by 3 m and leaves the floor where it is: the box around the walls grows with it.
  using Up = MotionOfGroups<3, Tabulated<2>>;
  using P = Formulated<OnHost, Own, Up>;
  Groups<2> walls;
  walls.add("left", {V(0, 0), V(0, 1)}).add("floor", {V(0, 0), V(1, 0)}).add("right", {V(1, 0), V(1, 1)});
  for (bool const opens : {false, true}) {
    Up motion(walls);
    if (opens) motion.set(walls.number("right"), Tabulated<2>({0, 0.5}, {V(0, 0), V(3, 0)}));
    Solver<P> solver({.spacing = 0.1, .motion = motion, .lost_share = 1, .start_checks = false},
                     {V(0.5, 0.5), V(0.2, 0.2)}, walls);
    solver.set(velocity, [](V const& x) { return V(x[0] > 0.4 ? 4 : 0, 0); });
    solver.run(0.5);
    CHECK(solver.material().to_host(position)[0][0] > 2);
    CHECK(solver.lost() == (opens ? 0 : 1));
  }
}

TEST_CASE("plain motions store no groups, and a formulation stores them if it says so") {
  using Plain = Formulated<OnHost, Own, Rotation>;
  STATIC_CHECK_FALSE(OneOf<Group, wall_fields<Plain>>);
  STATIC_CHECK_FALSE(OneOf<Group, material_fields<Plain>>);
  STATIC_CHECK(OneOf<Group, wall_fields<ByGroup<OnHost>>>);
  STATIC_CHECK_FALSE(OneOf<Group, material_fields<ByGroup<OnHost>>>);  // it does not follow the motion
  STATIC_CHECK(OneOf<Group, material_fields<Formulated<OnHost, Followed, Motions<2>>>>);
  struct Kept : Plain {
    using carries = Fields<Group>;
  };
  auto const walls = plates<2>();
  SolverSettings<Kept> const settings{.spacing = 0.25, .start_checks = false};
  Solver<Kept> solver(settings, walls, walls.points());
  CHECK(solver.material().to_host(group) == walls.numbers());
  CHECK(solver.wall().to_host(group) == std::vector<int>(walls.points().size(), 0));  // plain points are one group
  CHECK(Solver<Kept>(settings, {}, walls).wall().to_host(group) == walls.numbers());
  CHECK(Solver<Kept>(settings, walls).material().to_host(group) == walls.numbers());
  CHECK_NOTHROW(Solver<Plain>({.spacing = 0.25}, walls));  // groups that are not used
}

TEST_CASE("passes read the groups of the material, which must have been given") {
  struct Marks {
    using evolves = Fields<Concentration>;
    auto passes(Resolution const&) const { return std::tuple(point_pass<Material>("mark", MarkGroups{})); }
    auto limits(Resolution const&) const { return std::tuple(limit("step", 1e-3)); }
  };
  using P = Formulated<OnHost, Marks>;
  auto const bed = Groups<2>()
                       .add("sand", fill_lattice(Box<2>{{0, 0}, {1, 0.5}}, 0.1))
                       .add("gravel", fill_lattice(Box<2>{{0, 0.5}, {1, 1}}, 0.1));
  Solver<P> solver({.spacing = 0.1, .sort_period = 1}, bed);
  CHECK(solver.material().to_host(concentration).back() == 0);
  solver.step(1e-3);
  auto const C = solver.material().to_host(concentration);
  auto const x = solver.material().to_host(position);
  bool right = true;
  for (std::size_t k = 0; k < C.size(); ++k) right = right && C[k] == (x[k][1] > 0.5 ? 1 : 0);
  CHECK(right);
  Solver<P> without({.spacing = 0.1}, bed.points());
  CHECK_THROWS_WITH(without.step(1e-3), ContainsSubstring("group (1) of the material is read by passes"));
  without.set(group, [](V const&) { return 0; });
  CHECK_NOTHROW(without.step(1e-3));
}

TEST_CASE("a field is set for the particles of one group, wherever sorting has put them") {
  using P = Formulated<OnHost, Own>;
  auto const bed = Groups<2>()
                       .add("low", fill_lattice(Box<2>{{0, 0}, {1, 0.5}}, 0.1))
                       .add("high", fill_lattice(Box<2>{{0, 0.5}, {1, 1}}, 0.1));
  Solver<P> solver({.spacing = 0.1, .sort_period = 1}, bed);
  solver.step(1e-4);
  set_group(solver, velocity, bed, "high", [](V const& x) { return V(7, x[0]); });
  auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
  bool right = true;
  for (std::size_t k = 0; k < x.size(); ++k)
    right = right && (x[k][1] > 0.49 ? u[k] == V(7, x[k][0]) : u[k] == V(-1e-4, -1e-4));
  CHECK(right);
  CHECK_THROWS_WITH(set_group(solver, velocity, bed, "middle", [](V const&) { return V(0, 0); }),
                    ContainsSubstring("no group 'middle'"));
  CHECK_THROWS_WITH(set_group<Wall>(solver, volume, bed, "high", [](V const&) { return 1.0; }),
                    ContainsSubstring("100 particles, and the body has 0"));
}

TEST_CASE("a run by group continues from a snapshot, which must have the same groups") {
  using P = Formulated<OnHost, Followed, Motions<2>>;
  auto const walls = plates<2>();
  auto const make = [](Groups<2> const& all) {
    return Solver<P>({.spacing = 0.25, .motion = motion_of_plates<2>(), .sort_period = 3, .start_checks = false}, all,
                     all);
  };
  auto whole = make(walls), first = make(walls), second = make(walls);
  whole.run(0.4);
  first.run(0.4);
  auto const snapshot = first.snapshot();
  REQUIRE(snapshot.find("wall/group") != nullptr);
  second.restore(snapshot);
  whole.run(0.8), second.run(0.8);
  CHECK(second.material().to_host(position) == whole.material().to_host(position));
  CHECK(second.wall().to_host(position) == whole.wall().to_host(position));
  CHECK(second.material().to_host(group) == whole.material().to_host(group));
  Groups<2> swapped;
  auto const& x = walls.points();
  auto const lid = walls.range("lid");
  swapped.add("floor", {x.begin(), x.begin() + lid.first + 1})
      .add("bar", {})
      .add("lid", {x.begin() + lid.first + 1, x.end()});
  auto other = make(swapped);
  CHECK_THROWS_WITH(other.restore(snapshot), ContainsSubstring("the groups of the material differ"));
  CHECK(other.time() == 0);
}

}  // namespace scree::test::groups_tests
