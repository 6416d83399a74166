// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/rotation.hpp>
#include <scree/solver/prescribe.hpp>
#include <scree/solver/solver.hpp>

#include <support/bodies.hpp>
#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

namespace scree::test {

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

/// Makes a body carry what a motion can give. Nothing changes.
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

/// Walls that carry all of it, material that carries the velocity alone; both follow the motion.
struct Watched {
  using evolves = Fields<Concentration>;
  auto passes(Resolution const&) const {
    return std::tuple(point_pass<Wall>("wall", Looks<Velocity, Acceleration, VelocityGradient>{}),
                      point_pass<Material>("material", Looks<Velocity>{}));
  }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
/// The unit box as material and as wall, turned around a point beside it.
template <class P>
auto turned(double rate, double angle_per_step) {
  Rotation const motion{rate, angle_per_step, 0.25, -0.5};
  return solver_of<Formulated<P, Watched, Rotation>>({lattice<P::dim>(0.25), lattice<P::dim>(0.25)}, 0.25, {}, motion);
}
/// Largest distance between points and where they were.
template <class X>
double distance(std::vector<X> const& now, std::vector<X> const& then) {
  double worst = 0;
  for (std::size_t i = 0; i < now.size(); ++i) worst = std::max(worst, double((now[i] - then[i]).norm()));
  return worst;
}

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

TEMPLATE_LIST_TEST_CASE("walls are back after a full turn, however many steps it took", "", Some) {
  using P = TestType;
  auto solver = turned<P>(2 * pi, 2e-3);
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
  if (std::is_same_v<typename P::real, float>) CHECK(in_material > 10 * at_wall);  // what adding up would do
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
  scree::detail::Displace<SpeedingUp>{{}, 1, 2}(i, place);
  CHECK(place[position] == Vec<2, double>(4 + 4.5, 5));
  Record<OnHost, Fields<RestPosition>> const wall{{Vec<2, double>(4, 5)}};
  Results<OnHost, Fields<Position, Velocity>> of_wall;
  scree::detail::Place<SpeedingUp, Fields<Velocity>>{{}, 2}(wall, of_wall);
  CHECK(of_wall[position] == Vec<2, double>(4 + 6, 5));
  CHECK(of_wall[velocity] == Vec<2, double>(6, 0));
}

TEST_CASE("walls have the velocity of the end of a step") {
  auto solver = solver_of<Formulated<OnHost, Watched, SpeedingUp>>({lattice<2>(0.25), lattice<2>(0.25)}, 0.25);
  solver.run(0.35);
  CHECK((solver.wall().to_host(velocity)[3] - Vec<2, double>(3 * 0.35, 0)).norm() < 1e-14);
  auto const x = solver.wall().to_host(position), rest = solver.wall().to_host(rest_position);
  CHECK((x[3] - rest[3] - Vec<2, double>(1.5 * sq(0.35), 0)).norm() < 1e-14);
}

}  // namespace scree::test
