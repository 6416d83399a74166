// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>

#include <support/rigid_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

// Rigid bodies that integrators move which do not name them.
namespace scree::test::integrators_of_users_tests {
using namespace fields;
namespace {

using Q = Policy<3, double, Kokkos::DefaultHostExecutionSpace>;

/// Euler's method, velocities first.
struct Euler {
  template <class Evolved>
  using fields = Merge<evolved_fields<Evolved>, rates_of_evolved<Evolved>>;
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    stepper.update([dt](auto evolved) { return staggered_update<typename Stepper::Basis>(evolved, dt); }, 0, dt);
    return dt;
  }
};

/// Euler's method, after which all velocities are halved.
template <class P, class Evolved>
struct Halved : std::remove_cvref_t<decltype(staggered_update<P>(Evolved{}, 1.0))> {
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    std::remove_cvref_t<decltype(staggered_update<P>(Evolved{}, 1.0))>::operator()(i, out);
    if constexpr (OneOf<Velocity, evolved_fields<Evolved>>) out[velocity] *= 0.5;
    if constexpr (OneOf<RigidVelocity, evolved_fields<Evolved>>) out[rigid_velocity] *= 0.5;
  }
};
struct Damped : Euler {
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    using P = typename Stepper::Basis;
    stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    stepper.update(
        [dt]<class Evolved>(Evolved evolved) { return Halved<P, Evolved>{staggered_update<P>(evolved, dt)}; }, 0, dt);
    return dt;
  }
};

/// Half a drift, a kick, half a drift.
struct DriftKickDrift : Euler {
  static constexpr bool staggered = true;
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    double const dt = stepper.choose_step(longest);
    stepper.add_rates(Fields<Position>{}, dt / 2);
    stepper.move(0, dt / 2);
    stepper.update_rates();
    stepper.add_rates(Fields<Velocity>{}, dt);
    stepper.add_rates(Fields<Position>{}, dt / 2);
    stepper.move(dt / 2, dt);
    return dt;
  }
};

/// The value of a field at the start of a step.
template <Field F>
struct Start : F {};
/// The value at the start of the step + a share of it times the present rate.
template <class P, class Evolved>
struct FromStart;
template <class P, class... Fs>
struct FromStart<P, Fields<Fs...>> {
  using reads = Merge<evolved_fields<Fields<Fs...>>, rates_of_evolved<Fields<Fs...>>,
                      Fields<Start<detail::evolved_field<Fs>>...>>;
  using writes = Merge<evolved_fields<Fields<Fs...>>, Fields<Start<detail::evolved_field<Fs>>...>>;
  double step;
  bool begins;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    (add<Fs>(i, out), ...);
  }

 private:
  template <class Entry, class I, class O>
  SCREE_FN void add(I const& i, O& out) const {
    using F = detail::evolved_field<Entry>;
    auto const start = begins ? i[F{}] : i[Start<F>{}];
    out[Start<F>{}] = start;
    evolve<P, Entry>(start, detail::change<Entry>(step, i), i, out);
  }
};
/// Three steps from the same start, over a third, a half and all of the time: third order where rates are linear. It
/// stores what it needs in fields of its own.
struct ThirdOrder {
  template <class Evolved>
  struct with_start;
  template <class... Fs>
  struct with_start<Fields<Fs...>> {
    using type = Merge<evolved_fields<Fields<Fs...>>, rates_of_evolved<Fields<Fs...>>,
                       Fields<Start<detail::evolved_field<Fs>>...>>;
  };
  template <class Evolved>
  using fields = typename with_start<Evolved>::type;
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    using P = typename Stepper::Basis;
    stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    double before = 0;
    for (double const share : {1.0 / 3, 1.0 / 2, 1.0}) {
      if (before > 0) stepper.update_rates();
      double const step = share * dt;
      stepper.update([=]<class Evolved>(Evolved) { return FromStart<P, Evolved>{step, before == 0}; }, before, step);
      before = step;
    }
    return dt;
  }
};

/// Stores the value of each field that evolves.
template <class Evolved>
struct Save;
template <class... Fs>
struct Save<Fields<Fs...>> {
  using reads = Fields<detail::evolved_field<Fs>...>;
  using writes = Fields<Start<detail::evolved_field<Fs>>...>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    ((out[Start<detail::evolved_field<Fs>>{}] = i[detail::evolved_field<Fs>{}]), ...);
  }
};
/// Stores the start in an update of its own.
struct SaveThenMove : ThirdOrder {
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    using P = typename Stepper::Basis;
    stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    stepper.apply([]<class Evolved>(Evolved) { return Save<Evolved>{}; });
    stepper.update([=]<class Evolved>(Evolved) { return FromStart<P, Evolved>{dt, false}; }, 0, dt);
    return dt;
  }
};

/// Gravity acts on the material, too.
struct Pull {
  using reads = Fields<>;
  using writes = Fields<Acceleration>;
  double g;  // m/s^2
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[acceleration] = Vec<3, double>(0, 0, -g);
  }
};
struct Falling : Weight {
  auto stages(Resolution const&) const {
    return std::tuple(stage<evolves>(std::tuple(point_pass<Material>("pull", Pull{gravity.magnitude}))));
  }
};
template <class Integrator>
struct Fall : Formulated<Q, Falling> {
  using bodies = Bodies<Material, Wall, Block>;
  using integrator = Integrator;
};

Rigid<3> body_at(Vec<3, double> const& centre) {
  Rigid<3> body;
  body.properties.mass = 2;
  body.properties.centre = centre;
  body.properties.inertia = 0.7 * Inertia<3>::Identity();
  return body;
}

/// A solver of one rigid body of one particle, and one particle of the material, with a gravity (m/s^2).
template <class Integrator>
Solver<Fall<Integrator>> falling(RigidBodies<3> const& rigid, double gravity) {
  Groups<3> block;
  block.add("block", Points<3>{rigid.bodies[0].properties.centre});
  Falling physics;
  physics.gravity = {gravity};
  return Solver<Fall<Integrator>>({.spacing = 0.1, .physics = physics, .rigid = rigid, .start_checks = false},
                                  particles_of<Material>(Points<3>{{5, 0, 0}}), particles_of<Wall>(Points<3>{}),
                                  particles_of<Block>(block));
}

/// The error of a body on a spring and in torsion after one second with steps of dt (s): of its place (m), of its angle
/// (rad).
template <class Integrator>
std::array<double, 2> errors_on_springs(double dt) {
  RigidBodies<3> rigid{.bodies = {body_at({0.2, 0, 0})}};
  rigid.springs.push_back(
      {.body = 0, .point = {0.2, 0, 0}, .anchor = {0.2, 0, 0}, .stiffness = 30, .length = 0, .torsion = 10.5});
  rigid.bodies[0].velocity = {0.1, 0, 0};
  rigid.bodies[0].angular_velocity = {0, 0, 0.4};
  auto solver = falling<Integrator>(rigid, 0);
  for (int n = 0; n < std::lround(1 / dt); ++n) solver.step(dt);
  double const omega = std::sqrt(15.0);
  auto const now = state_of(solver);
  return {std::abs(now.x[0] - 0.2 - 0.1 / omega * std::sin(omega)),
          std::abs(2 * std::asin(now.q[3]) - 0.4 / omega * std::sin(omega))};
}

}  // namespace

TEMPLATE_TEST_CASE("a rigid body falls as a particle of the material does, with each integrator", "", Euler,
                   DriftKickDrift, ThirdOrder, SaveThenMove, Midpoint, SymplecticEuler, VelocityVerlet) {
  RigidBodies<3> const rigid{.bodies = {body_at({0.5, 0, 0})}, .spacings_per_step = 10};
  auto solver = falling<TestType>(rigid, 10);
  auto const fallen = [&] { return state_of(solver).x[2]; };
  for (int n = 0; n < 50; ++n) solver.step(0.004 + 0.0001 * n);
  CHECK(fallen() < -0.4);
  CHECK(solver.material().to_host(position)[0][2] == fallen());
  CHECK(solver.material().to_host(velocity)[0] == state_of(solver).u);
  CHECK(std::abs(solver.template body<Block>().to_host(position)[0][2] - fallen()) < 1e-15);
}

TEST_CASE("a rigid body without a bound on its way falls as with one") {
  double const none = std::numeric_limits<double>::infinity();
  auto const fallen = [](double angle, double way) {
    auto solver =
        falling<Midpoint>({.bodies = {body_at({0.5, 0, 0})}, .angle_per_step = angle, .spacings_per_step = way}, 10);
    for (int n = 0; n < 20; ++n) CHECK(solver.step(0.004) == 0.004);
    return state_of(solver).x[2];
  };
  double const expected = fallen(1, 10);
  CHECK(expected < -0.01);
  CHECK(fallen(none, 10) == expected);
  CHECK(fallen(1, none) == expected);
}

TEST_CASE("a given velocity of a rigid body is kept whatever an integrator stores") {
  RigidBodies<3> rigid{.bodies = {body_at({0.5, 0, 0})}, .spacings_per_step = 10};
  rigid.bodies[0].given_velocity[1] = 0.3;
  rigid.bodies[0].velocity = {0.8, 0, 0};
  auto solver = falling<Damped>(rigid, 0);
  for (int n = 0; n < 3; ++n) solver.step(0.01);
  auto const now = state_of(solver);
  CHECK(now.u[0] == 0.1);
  CHECK(now.u[1] == 0.3);
  CHECK(std::abs(now.x[1] - 0.009) < 1e-15);
  CHECK(solver.body<Block>().to_host(velocity)[0] == now.u);
}

TEST_CASE("a rigid body on springs has the order of an integrator of a user") {
  auto const order = [](auto const& coarse, auto const& fine, std::size_t k) { return std::log2(coarse[k] / fine[k]); };
  for (std::size_t const k : {0U, 1U}) {
    CHECK(std::abs(order(errors_on_springs<DriftKickDrift>(0.01), errors_on_springs<DriftKickDrift>(0.005), k) - 2) <
          0.1);
    CHECK(std::abs(order(errors_on_springs<ThirdOrder>(0.01), errors_on_springs<ThirdOrder>(0.005), k) - 3) < 0.1);
  }
}

}  // namespace scree::test::integrators_of_users_tests
