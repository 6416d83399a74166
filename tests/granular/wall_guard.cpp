// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/wall_guard.hpp>

#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/motion/translation.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

namespace scree::test::wall_guard_tests {
using namespace fields;
namespace {

struct Unguarded : GranularModels {};
struct Guarded : GranularModels {
  using forces = std::tuple<WallGuard>;
};
template <class Q, class Models>
struct OneGrain : Formulated<Q, Granular<Models>> {
  using integrator = SymplecticEuler;
};
template <class Q>
struct OnLift : OneGrain<Q, Guarded> {
  using motion = Translation<Q::dim>;
};
double const spacing = 0.1;

/// A grain at a height over a wall of three rows, or within it (spacings), with a velocity upwards (m/s) and gravity
/// (m/s^2).
template <class F>
Solver<F> grain(double height, double upwards, double gravity = 0) {
  constexpr int dim = F::dim;
  using real = typename F::real;
  using X = Vec<dim, double>;
  X low = X::Constant(-6 * spacing), high = X::Constant(6 * spacing), place = X::Constant(0.23 * spacing);
  low[dim - 1] = -3 * spacing, high[dim - 1] = 0, place[dim - 1] = height * spacing;
  typename F::physics physics;
  physics.law.elastic = {1e6, 0.3, 1500};
  physics.law.grains = {0.001};
  physics.gravity.magnitude = gravity;
  if constexpr (!std::is_same_v<decltype(physics.forces), std::tuple<>>)
    std::get<0>(physics.forces).speed = physics.law.sound_speed();
  typename F::motion motion;
  if constexpr (requires { motion.speed[dim - 1] = 0; }) motion.speed[dim - 1] = upwards;
  Solver<F> solver({.spacing = spacing, .physics = physics, .motion = motion, .lost_share = 1, .start_checks = false},
                   cast<real>(std::vector<X>{place}), cast<real>(fill_lattice(Box<dim>{low, high}, spacing)));
  solver.set(velocity, [&](auto const&) {
    Vec<dim, real> u = Vec<dim, real>::Zero();
    u[dim - 1] = real(upwards);
    return u;
  });
  return solver;
}
template <class S>
double height(S const& solver) {
  return double(solver.material().to_host(position)[0][S::policy::dim - 1]) / spacing;
}
/// The share of the wall in the support of the grain, by a sum over all wall particles.
template <class S>
double share(S const& solver) {
  constexpr int dim = S::policy::dim;
  KernelFunction<typename S::policy::kernel, dim, double> const W(1.5 * spacing);
  Vec<dim, double> const x = solver.material().to_host(position)[0].template cast<double>();
  double sum = 0;
  for (auto const& w : solver.wall().to_host(position)) {
    double const r = (w.template cast<double>() - x).norm();
    if (r < W.radius()) sum += std::pow(spacing, dim) * W.value(r);
  }
  return sum;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the guard does not act on a grain that rests on a wall, and pushes one out that is in it", "",
                        Policies) {
  using F = OneGrain<TestType, Guarded>;
  constexpr int dim = F::dim;
  for (double const at : {0.5, 0.1, -0.6, -1.0}) {
    auto solver = grain<F>(at, 0);
    solver.update_rates();
    double const c = solver.settings().physics.law.sound_speed();
    double const expected = std::max(0.0, sq(c) / spacing * (share(solver) - 0.7));
    auto const a = solver.material().to_host(guard_acceleration)[0].template cast<double>().eval();
    INFO("height " << at << ", share " << share(solver) << ", acceleration " << a[dim - 1] << " of " << expected);
    CHECK(std::abs(a.norm() - expected) < 1e-4 * sq(c) / spacing);
    CHECK((at > 0 ? a.norm() == 0 : a[dim - 1] > 0.98 * a.norm()));
  }
}

TEMPLATE_LIST_TEST_CASE("a grain that has sunk into a wall comes back under gravity, and one that hits it fast", "",
                        Policies) {
  using F = OneGrain<TestType, Guarded>;
  double const c = grain<F>(1, 0).settings().physics.law.sound_speed();
  for (auto const& [from, upwards] : {std::pair(-0.6, 0.0), {-1.0, 0.0}, {1.0, -0.5 * c}}) {
    auto solver = grain<F>(from, upwards, 9.81);
    double lowest = 1;
    while (solver.time() < 20 * spacing / c) {
      solver.step(1);
      lowest = std::min(lowest, height(solver));
    }
    INFO("from " << from << ": lowest " << lowest << ", at the end " << height(solver));
    CHECK(lowest > -1.2);
    CHECK(height(solver) > -0.45);
  }
}

TEMPLATE_LIST_TEST_CASE("a grain that moves with the wall feels no approach", "", Policies) {
  auto still = grain<OneGrain<TestType, Guarded>>(-0.6, 0);
  auto moving = grain<OnLift<TestType>>(-0.6, -5);
  still.update_rates(), moving.update_rates();
  constexpr int up = TestType::dim - 1;
  double const a = still.material().to_host(guard_acceleration)[0][up];
  double const b = moving.material().to_host(guard_acceleration)[0][up];
  CHECK(a > 0);
  CHECK(std::abs(a - b) < 1e-4 * a);
}

TEST_CASE("without the guard a grain that has sunk into a wall stays there") {
  auto solver = grain<OneGrain<Policy<3, double, Kokkos::DefaultHostExecutionSpace>, Unguarded>>(-1, 0, 9.81);
  solver.run(1);
  INFO(height(solver));
  CHECK(height(solver) < -0.9);
}

TEST_CASE("settings of the guard that are out of range are refused") {
  CHECK_THROWS_WITH(WallGuard{}.check(), Catch::Matchers::ContainsSubstring("speed"));
  CHECK_THROWS_WITH(WallGuard{.speed = -1}.with_sound_speed(30).check(), Catch::Matchers::ContainsSubstring("speed"));
  CHECK_THROWS_WITH((WallGuard{.speed = 1, .from = 0.3}.check()), Catch::Matchers::ContainsSubstring("from"));
}

TEST_CASE("a guard without a speed has that of sound") {
  using F = OneGrain<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Guarded>;
  auto const pushed = [](double share_of_sound) {
    auto solver = grain<F>(-1, 0, 9.81);
    auto physics = solver.settings().physics;
    double const c = physics.law.sound_speed();
    std::get<0>(physics.forces).speed = share_of_sound * c;
    Solver<F> other({.spacing = spacing, .physics = physics, .lost_share = 1, .start_checks = false},
                    solver.material().to_host(position), solver.wall().to_host(position));
    other.update_rates();
    return other.material().to_host(guard_acceleration)[0][1];
  };
  CHECK(pushed(0) > 0);
  CHECK(pushed(0) == pushed(1));
  CHECK(pushed(0) > pushed(0.5));
  Granular<Guarded> physics;
  physics.law.elastic = {1e6, 0.3, 1500};
  physics.law.grains = {0.001};
  CHECK_NOTHROW(physics.check());
}

}  // namespace scree::test::wall_guard_tests
