// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/system/sort.hpp>

#include <support/bodies.hpp>
#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace scree::test::sort_tests {
using namespace fields;
namespace {

/// Mean distance in memory of particles within a radius.
template <class Body>
double distance_in_memory(Body const& body, double radius) {
  auto const x = body.to_host(position);
  double sum = 0, pairs = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!((x[i] - x[j]).norm() < radius)) continue;
      sum += double(i - j);
      ++pairs;
    }
  return sum / pairs;
}

/// A block with fast shear between its periodic ends, over a floor.
struct Sheared : Formulation<2> {
  using physics = Granular<>;
};
Solver<Sheared> sheared(int sort_period) {
  SolverSettings<Sheared> settings{.spacing = 0.1, .periods = {{0, 0, 1}}, .sort_period = sort_period};
  settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
  settings.physics.filter.period = 7;
  auto const bed = layer({1, 0.6}, 0.1);
  Solver<Sheared> solver(settings, bed.material, bed.wall);
  solver.set(stress, [](auto const& x) { return (1500 * 9.81 * (x[1] - 0.6) * Vec<4, double>(1, 1, 1, 0)).eval(); });
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(3 * x[1], 0.1 * std::sin(6 * x[0])); });
  return solver;
}
Solver<Sheared> stepped(Solver<Sheared> solver, long until) {
  while (solver.steps() < until) solver.step(1);
  return solver;
}
template <Field F>
auto by_identity(Solver<Sheared> const& solver, F field) {
  auto const values = solver.material().to_host(field);
  auto sorted = values;
  auto const names = solver.material().to_host(identity);
  for (std::size_t k = 0; k < names.size(); ++k) sorted[std::size_t(names[k])] = values[k];
  return sorted;
}
template <Field F>
double difference(Solver<Sheared> const& a, Solver<Sheared> const& b, F field) {
  auto const of_a = by_identity(a, field), of_b = by_identity(b, field);
  double largest = 0, scale = 0;
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    largest = std::max(largest, (of_a[k] - of_b[k]).norm());
    scale = std::max(scale, of_a[k].norm());
  }
  return largest / scale;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("sorted particles lie beside their neighbours, each with all its values", "", Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(600, 0, 1, 1);
  Particles<P, Fields<Position, Identity, Velocity>> body(600);
  std::vector<int> names(600);
  for (int k = 0; k < 600; ++k) names[std::size_t(k)] = k;
  body.from_host(position, cast<typename P::real>(points));
  body.from_host(velocity, cast<typename P::real>(points));
  body.from_host(identity, names);
  double const radius = 0.15, before = distance_in_memory(body, radius);
  body.resize(600, 50);  // ghosts, to be created again
  sort_along_cells(body, radius);
  CHECK(body.ghosts() == 0);
  CHECK(distance_in_memory(body, radius) < 0.5 * before);
  auto const x = body.to_host(position), u = body.to_host(velocity);
  auto const who = body.to_host(identity);
  CHECK(std::set<int>(who.begin(), who.end()).size() == 600);
  for (std::size_t k = 0; k < 600; ++k) {
    REQUIRE(x[k] == cast<typename P::real>(points)[std::size_t(who[k])]);
    REQUIRE(u[k] == x[k]);
  }
  sort_along_cells(body, radius);
  CHECK(body.to_host(identity) == who);
}

TEMPLATE_LIST_TEST_CASE("no particles can be sorted", "", Policies) {
  Particles<TestType, Fields<Position, Identity>> body;
  sort_along_cells(body, 0.1);
  CHECK(body.size() == 0);
}

TEST_CASE("a run with sorting is the same but for rounding") {
  auto const plain = stepped(sheared(0), 60), sorted = stepped(sheared(10), 60);
  CHECK(difference(plain, sorted, position) < 1e-12);
  CHECK(difference(plain, sorted, velocity) < 1e-9);
  CHECK(difference(plain, sorted, stress) < 1e-9);
  auto const names = sorted.material().to_host(identity);
  CHECK_FALSE(std::is_sorted(names.begin(), names.end()));
  CHECK(sorted.snapshot() == stepped(sheared(10), 60).snapshot());  // bit by bit
}

TEST_CASE("a run with sorting goes on from a snapshot bit by bit") {
  auto const whole = stepped(sheared(10), 47).snapshot();
  for (long const at : {9, 10, 11, 25, 30})
    for (bool const checked : {false, true}) {
      auto second = sheared(10);
      second.restore(stepped(sheared(10), at).snapshot());
      if (checked) second.check_start();
      INFO("continued after step " << at << (checked ? ", which was checked" : ""));
      CHECK(stepped(std::move(second), 47).snapshot() == whole);
    }
}

TEST_CASE("a check of the start changes no bit of a run") {
  for (int const period : {0, 10}) {
    auto const end = [&](bool checked) {
      auto solver = sheared(period);
      if (checked) solver.check_start(), solver.check_start();
      solver.run(0.05, {every<Solver<Sheared>>(0.02, [](auto&) {})});
      return solver.snapshot();
    };
    auto const unchecked = end(false);
    CHECK(unchecked.steps > 3);
    CHECK(end(true) == unchecked);
  }
}

TEST_CASE("a negative period of sorting stops with a message") {
  CHECK_THROWS_WITH(sheared(-1), Catch::Matchers::StartsWith("scree: sort_period (steps) must be 0 or more"));
}

}  // namespace scree::test::sort_tests
