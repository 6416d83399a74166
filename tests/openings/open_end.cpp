// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "support.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>

namespace scree::test::open_end_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;
using F = FedSand<Policy<2, double, Kokkos::DefaultExecutionSpace>>;
constexpr double length = 4, pressure = 1000, slow = 0.2;  // m, Pa, m/s

/// A column of any width under pressure that moves from an inlet to an open end with another pressure.
Solver<F> column(double pressure_out) {
  Solver<F> solver({.spacing = dr, .physics = weightless(), .periods = {{1, 0, 8 * dr}}},
                   fill_lattice(Box<2>{{0, 0}, {length, 8 * dr}}, dr));
  auto const isotropic = [](double p) { return Vec<4, double>(-p, -p, -p, 0); };
  solver.set(stress, [=](auto const&) { return isotropic(pressure); });
  solver.set(velocity, [](auto const&) { return Vec<2, double>(slow, 0); });
  solver.feed({.layer = fill_lattice(Box<2>{{-dr, 0}, {0, 8 * dr}}, dr), .velocity = {slow, 0}},
              given(stress, isotropic(pressure)));
  solver.open_end({.point = {length - 7 * dr, 0}, .normal = {1, 0}}, given(stress, isotropic(pressure_out)));
  return solver;
}
template <class Visit>
void for_each_between(Solver<F> const& solver, double from, double to, Visit const& visit) {
  auto const x = solver.material().to_host(position);
  auto const u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  for (std::size_t k = 0; k < x.size(); ++k)
    if (x[k][0] > from && x[k][0] < to) visit(u[k], sigma[k]);
}
}  // namespace

TEST_CASE("a column under pressure leaves through an end with the same pressure as if it went on") {
  auto solver = column(pressure);
  solver.run(30 * dr / slow);
  for_each_between(solver, 0, length - 4 * dr, [](auto const& u, auto const& sigma) {
    CHECK(std::abs(u[0] - slow) < 0.01 * slow);
    CHECK(std::abs(sigma[0] + pressure) < 0.01 * pressure);
  });
  auto const all = ledger(solver);
  CHECK(all.entered == (3 + 30) * 8);  // without the column behind the inlet
  CHECK(std::abs(all.left - 30 * 8) <= 5 * 8);
  check_ledger(solver);
}

TEST_CASE("an end with another pressure sends a wave of that pressure into the column") {
  double const higher = 1.2 * pressure, rho = 1500;
  auto solver = column(higher);
  double const modulus = 1e5 * 0.7 / (1.3 * 0.4), c = std::sqrt(modulus / rho);
  solver.run(2.4 / c);
  double count = 0, mean_stress = 0, mean_speed = 0;
  for_each_between(solver, 1.6, 3,
                   [&](auto const& u, auto const& sigma) { ++count, mean_stress += sigma[0], mean_speed += u[0]; });
  CHECK(std::abs(mean_stress / count + higher) < 0.2 * (higher - pressure));
  CHECK(std::abs(mean_speed / count - slow + (higher - pressure) / (rho * c)) < 0.2 * (higher - pressure) / (rho * c));
  for_each_between(solver, 0.1, 0.4,
                   [&](auto const&, auto const& sigma) { CHECK(std::abs(sigma[0] + pressure) < 0.01 * pressure); });
}

TEST_CASE("a run with an open end continues from a snapshot bit for bit, and not with another end") {
  auto whole = column(900), second = column(900);
  whole.run(0.7);
  auto const snapshot = whole.snapshot();
  second.restore(snapshot);
  whole.run(1.4), second.run(1.4);
  CHECK(whole.material().to_host(position) == second.material().to_host(position));
  CHECK(whole.material().to_host(stress) == second.material().to_host(stress));
  CHECK(whole.left()[0].particles == second.left()[0].particles);

  Solver<F> other({.spacing = dr, .physics = weightless(), .periods = {{1, 0, 8 * dr}}},
                  fill_lattice(Box<2>{{0, 0}, {length, 8 * dr}}, dr));
  CHECK_THROWS_WITH(other.open_end({.point = {1, 0}}), ContainsSubstring("length of the normal"));
  CHECK_THROWS_WITH(other.open_end({.point = {std::nan(""), 0}, .normal = {1, 0}}), ContainsSubstring("point (m)"));
  CHECK_THROWS_WITH(other.open_end({.point = {-1, 0}, .normal = {1, 0}}),
                    ContainsSubstring("all particles of the material are beyond the open end 'end'"));
  other.feed({.layer = fill_lattice(Box<2>{{-dr, 0}, {0, 8 * dr}}, dr), .velocity = {slow, 0}});
  other.open_end({.point = {1, 0}, .normal = {1, 0}});
  CHECK_THROWS_WITH(other.restore(snapshot), ContainsSubstring("'end end' is"));
}

}  // namespace scree::test::open_end_tests
