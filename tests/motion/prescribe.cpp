// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/motion/prescribe.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/solver/solver.hpp>

#include <support/bodies.hpp>
#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::test::prescribe_tests {
using namespace fields;

/// x = x_0 + a t^2/2 along the first axis.
struct SpeedingUp {
  double a = 3;
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return x + X(X::Unit(0) * (a / 2 * (to * to - from * from)));
  }
  template <class X>
  SCREE_FN X velocity(X const&, double time) const {
    return X::Unit(0) * (a * time);
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return X::Unit(0) * a;
  }
  double time_step() const { return 0.1; }
};

/// The upper half of space slides over the lower one, from a time on.
struct Sliding {
  double speed = 2, from_time = 0;  // m/s, s
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return x + moving(x) * (speed * (Kokkos::max(to, from_time) - Kokkos::max(from, from_time)));
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double time) const {
    return moving(x) * (time < from_time ? 0 : speed);
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return X::Zero();
  }
  double time_step() const { return 1e-4; }

 private:
  template <class X>
  SCREE_FN static X moving(X const& x) {
    return X::Unit(0) * (x[X::RowsAtCompileTime - 1] > 0.5 ? 1.0 : 0.0);
  }
};
/// Sliding that gives the velocity gradient of either side, which is zero.
struct SlidingInTwo : Sliding {
  template <class X>
  SCREE_FN auto velocity_gradient(X const&, double) const {
    return Mat<X::RowsAtCompileTime, typename X::Scalar>::Zero();
  }
};
/// u = (sin(y), 0).
struct Wavy {
  template <class X>
  SCREE_FN X displaced(X x, double from, double to) const {
    x[0] += Kokkos::sin(x[1]) * (to - from);
    return x;
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double) const {
    return X::Unit(0) * Kokkos::sin(x[1]);
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return X::Zero();
  }
  template <class X>
  SCREE_FN auto velocity_gradient(X const& x, double) const {
    Mat<2, double> L = Mat<2, double>::Zero();
    L(0, 1) = Kokkos::cos(x[1]);
    return L;
  }
  double time_step() const { return 0.01; }
};

/// Adds the fields to a body that a motion can give. Nothing changes.
template <class... Fs>
struct Looks {
  using reads = Fields<Fs...>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[concentration_rate] = 0;
  }
};

namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using Solid = Policy<3, float, Kokkos::DefaultHostExecutionSpace>;
using Some = std::tuple<OnHost, Solid>;

/// Walls with all of these fields, material with the velocity alone; both follow the motion.
struct Watched {
  using evolves = Fields<Concentration>;
  auto passes(Resolution const&) const {
    return std::tuple(point_pass<Wall>("wall", Looks<Velocity, Acceleration, VelocityGradient>{}),
                      point_pass<Material>("material", Looks<Velocity>{}));
  }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
/// The unit box as material and as wall, at the same position: no pass contains pairs of them.
template <class P>
Solver<P> unit_boxes(typename P::motion const& motion = {}) {
  auto const points = cast<typename P::real>(lattice<P::dim>(0.25));
  return Solver<P>({.spacing = 0.25, .motion = motion, .start_checks = false}, points, points);
}
/// The unit boxes, rotated about a point other than their centre.
template <class P>
auto turned(double rate, double angle_per_step) {
  Rotation const motion{rate, angle_per_step, 0.25, -0.5};
  return unit_boxes<Formulated<P, Watched, Rotation>>(motion);
}
/// Largest distance between points and their earlier positions.
template <class X>
double distance(std::vector<X> const& now, std::vector<X> const& then) {
  double worst = 0;
  for (std::size_t i = 0; i < now.size(); ++i) worst = std::max(worst, double((now[i] - then[i]).norm()));
  return worst;
}

struct ElasticModels : GranularModels {
  using law = Elastic;
  using filter = NoFilter;
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("walls carry velocity, acceleration and velocity gradient of a rotation", "", Some) {
  using P = TestType;
  constexpr int dim = P::dim, up = dim - 1;
  using X = Vec<dim, double>;
  auto solver = turned<P>(2, 0.05);
  Mat<dim, double> spin = Mat<dim, double>::Zero();
  spin(0, up) = -2, spin(up, 0) = 2;
  X centre = X::Zero();
  centre[0] = 0.25, centre[up] = -0.5;
  for (double const until : {0.0, 0.7}) {
    solver.run(until);
    auto const& wall = solver.wall();
    auto const u = [&](X const& x) { return (spin * (x - centre)).eval(); };
    auto const a = [&](X const& x) { return (spin * spin * (x - centre)).eval(); };
    auto const gradient = [&](X const&) { return spin; };
    CHECK(largest_error(wall, velocity, 2, u) < ulps<P>(8));
    CHECK(largest_error(wall, acceleration, 4, a) < ulps<P>(8));
    CHECK(largest_error(wall, velocity_gradient, 2, gradient) < ulps<P>(8));
    CHECK(largest_error(solver.material(), velocity, 2, u) < ulps<P>(8));
  }
  CHECK(distance(solver.wall().to_host(position), cast<typename P::real>(lattice<dim>(0.25))) > 0.5);
  STATIC_CHECK_FALSE(OneOf<VelocityGradient, typename std::remove_cvref_t<decltype(solver.material())>::fields>);
}

TEMPLATE_LIST_TEST_CASE("walls and material are back after a full turn, however many steps it took", "", Some) {
  using P = TestType;
  auto solver = turned<P>(2 * std::numbers::pi, 2e-3);
  auto const start = solver.wall().to_host(position);
  solver.run(0.5);
  CHECK(distance(solver.wall().to_host(position), start) > 1);
  solver.run(1);
  CHECK(solver.steps() > 3000);
  CHECK(solver.wall().to_host(rest_position) == start);
  // cos and sin of 2 pi and the sum of the steps in double, the arms of up to 1.7 m in the precision of the positions.
  double const at_wall = distance(solver.wall().to_host(position), start);
  double const in_material = distance(solver.material().to_host(position), start);
  CHECK(at_wall < ulps<P>(2) + 1e-12);
  CHECK(in_material < ulps<P>(2) + 1e-12);  // which in float adds up with its remainders
}

TEST_CASE("the kinematics of a motion are those of the time and of the particle") {
  using List = Fields<Velocity, Acceleration, VelocityGradient>;
  Record<OnHost, Fields<Position>> const i{{Vec<2, double>(4, 5)}};
  Results<OnHost, List> out;
  scree::detail::Kinematics<SpeedingUp, List>{{}, 2}(i, out);
  CHECK(out[velocity] == Vec<2, double>(6, 0));
  CHECK(out[acceleration] == Vec<2, double>(3, 0));
  CHECK(out[velocity_gradient].norm() == 0);
  Results<OnHost, Fields<Position>> place;
  scree::detail::Displace<OnHost, SpeedingUp>{{}, 1, 2}(i, place);
  CHECK(place[position] == Vec<2, double>(4 + 4.5, 5));
  Record<OnHost, Fields<RestPosition>> const wall{{Vec<2, double>(4, 5)}};
  Results<OnHost, Fields<Position, Velocity>> of_wall;
  scree::detail::Place<SpeedingUp, Fields<Velocity>>{{}, 2}(wall, of_wall);
  CHECK(of_wall[position] == Vec<2, double>(4 + 6, 5));
  CHECK(of_wall[velocity] == Vec<2, double>(6, 0));
}

TEST_CASE("walls have the velocity of the end of a step") {
  auto solver = unit_boxes<Formulated<OnHost, Watched, SpeedingUp>>();
  solver.run(0.35);
  CHECK((solver.wall().to_host(velocity)[3] - Vec<2, double>(3 * 0.35, 0)).norm() < 1e-14);
  auto const x = solver.wall().to_host(position), rest = solver.wall().to_host(rest_position);
  CHECK((x[3] - rest[3] - Vec<2, double>(1.5 * sq(0.35), 0)).norm() < 1e-14);
}

TEST_CASE("walls whose velocity is not affine are refused, at the start or when they become so") {
  using Catch::Matchers::ContainsSubstring;
  using Cut = Formulated<OnHost, Watched, Sliding>;
  auto const make = [](Sliding const& motion) { return unit_boxes<Cut>(motion); };
  CHECK_THROWS_WITH(make({}), ContainsSubstring("velocity_gradient(x, time)"));
  auto later = make({.speed = 2, .from_time = 0.095});
  CHECK_NOTHROW(later.run(0.09));
  CHECK_THROWS_WITH(later.run(0.2), ContainsSubstring("not affine"));
  CHECK(later.steps() < 950 + 257);  // checked together with the limits of the step
  CHECK_NOTHROW(make({.speed = 0}));
  // Walls without a gradient field allow any motion.
  CHECK_NOTHROW(unit_boxes<Formulated<OnHost, NothingEvolves, Sliding>>());
}

TEST_CASE("affine motions are accepted, far from the origin, fast and in single precision too") {
  for (double const far : {0.0, 1e4})
    for (double const rate : {1e-6, 2.0, 1e6}) {
      Rotation const motion{.rate = rate, .centre_x = far};
      CHECK_NOTHROW((solver_of<Formulated<OnHost, Watched, Rotation>>({{}, lattice<2>(0.1)}, 0.1, {}, motion)));
      CHECK_NOTHROW((solver_of<Formulated<Solid, Watched, Rotation>>({{}, lattice<3>(0.25)}, 0.25, {}, motion)));
    }
}

TEST_CASE("a motion that gives its velocity gradient is taken at its word") {
  auto solver = unit_boxes<Formulated<OnHost, Watched, Wavy>>();
  solver.run(0.3);
  auto const x = solver.wall().to_host(position);
  auto const L = solver.wall().to_host(velocity_gradient);
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(std::abs(L[i](0, 1) - std::cos(x[i][1])) < 1e-15);
    CHECK(L[i](0, 0) == 0);
  }
}

TEST_CASE("walls that slide past each other show each material that sticks to them no motion of their own") {
  // Two blocks, each at rest with its wall: no particle of a wall shows the other wall's velocity.
  using P = Formulated<OnHost, Granular<ElasticModels>, SlidingInTwo>;
  Bed<2> bed;
  bed.material = fill_lattice(Box<2>{{0, 0}, {1, 0.2}}, 0.05);
  auto const above = fill_lattice(Box<2>{{0, 0.8}, {1, 1}}, 0.05),
             floor = fill_lattice(Box<2>{{0, -0.2}, {1, 0}}, 0.05), lid = fill_lattice(Box<2>{{0, 1}, {1, 1.2}}, 0.05);
  bed.material.insert(bed.material.end(), above.begin(), above.end());
  bed.wall = floor;
  bed.wall.insert(bed.wall.end(), lid.begin(), lid.end());
  Granular<ElasticModels> physics;
  physics.law = {1e5, 0.3, 1500};
  auto solver = solver_of<P>(bed, 0.05, physics, {}, {{0, 0, 1}});
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(x[1] > 0.5 ? 2 : 0, 0); });
  solver.update_rates();
  auto const u = solver.wall().to_host(dummy_velocity), of_wall = solver.wall().to_host(velocity);
  CHECK(distance(u, of_wall) < 1e-14);
  CHECK(of_wall.back()[0] == 2);
}

/// A user's motion: one speed (m/s) of positions, another one of velocities, and a jump of positions at a time.
struct Contradiction {
  double speed = 0, told = 0, jump = 0, jumps_at = 0;
  SCREE_FN double way(double t) const { return speed * t + (t > jumps_at ? jump : 0.0); }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return x + X(X::Unit(0) * typename X::Scalar(way(to) - way(from)));
  }
  template <class X>
  SCREE_FN X velocity(X const&, double) const {
    return X::Unit(0) * typename X::Scalar(told);
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return X::Zero();
  }
  double time_step() const { return 0.01; }
};

TEMPLATE_LIST_TEST_CASE("a motion that contradicts itself stops a run at the start, or when it begins to", "", Some) {
  using P = Formulated<TestType, Watched, Contradiction>;
  CHECK_NOTHROW(unit_boxes<P>({.speed = 0.5, .told = 0.5}).run(1));
  auto const contradicts =
      Catch::Matchers::ContainsSubstring("scree: the motion contradicts itself from 0 to 0.01 s: ");
  CHECK_THROWS_WITH(unit_boxes<P>({.speed = 0.5}).run(1), contradicts);
  CHECK_THROWS_WITH(unit_boxes<P>({.told = 0.5}).run(1), contradicts);
  auto jumping = unit_boxes<P>({.jump = 100, .jumps_at = 0.605});
  CHECK_THROWS_WITH(jumping.run(2), Catch::Matchers::ContainsSubstring("carries the point at"));
  CHECK(jumping.time() < 0.605 + 32 * 0.011);
}

}  // namespace scree::test::prescribe_tests
