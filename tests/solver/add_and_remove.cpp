// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/neighbours/verlet_list.hpp>

#include <support/formulations.hpp>
#include <support/weightless_sand.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <numeric>
#include <set>

namespace scree::test::add_and_remove_tests {
using namespace fields;

template <class P>
struct LeftOf {
  using reads = Fields<Position>;
  typename P::real x;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[position][0] < x;
  }
};

namespace {
using Catch::Matchers::ContainsSubstring;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
constexpr double dr = 0.1;

template <class Q, class Integrator = Midpoint>
struct Sand : Formulation<Q::dim, typename Q::real> {
  using space = typename Q::space;
  using physics = Granular<>;
  using integrator = Integrator;
};
/// Blocks of 6 spacings whose near corners are at multiples of 2 m along the first axis.
template <int Dim>
Points<Dim> block(int number) {
  Vec<Dim, double> low = Vec<Dim, double>::Zero();
  low[0] = 2 * number;
  return fill_lattice(Box<Dim>{low, (low.array() + 6 * dr).matrix()}, dr);
}
/// A block that contracts.
template <class F>
Solver<F> contracting(Points<F::dim> const& points) {
  using X = Vec<F::dim, typename F::real>;
  Solver<F> solver({.spacing = dr, .physics = weightless(), .lost_share = 1}, points_of<F>(points));
  solver.set(velocity, [](X const& x) { return X(typename F::real(-0.3) * x); });
  return solver;
}
/// A field of the particles with identities below a number, in the order of these.
template <class Body, Field F>
auto by_identity(Body const& body, F field, int below) {
  auto const numbers = body.to_host(identity);
  auto const values = body.to_host(field);
  std::vector<typename std::remove_cvref_t<decltype(values)>::value_type> sorted(static_cast<std::size_t>(below));
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (numbers[k] < below) sorted[std::size_t(numbers[k])] = values[k];
  return sorted;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("the number of particles is that at the start, plus those added, minus those removed", "",
                        Policies) {
  using F = Sand<TestType>;
  constexpr int dim = F::dim;
  auto solver = contracting<F>(block<dim>(0));
  int const each = solver.material().size();
  solver.run(0.005);
  for (int k = 1; k < 4; ++k) {
    solver.add(points_of<F>(block<dim>(2 * k)));
    solver.run(0.005 + 0.001 * k);
    auto const gone = solver.remove(LeftOf<F>{typename F::real(4 * k - 3)}, Fields<Identity, Volume>{});
    CHECK(int(gone.size()) == each);
    CHECK(gone.front()[identity] == (k - 1) * each);
    CHECK(solver.turnover().added == k * each);
    CHECK(solver.turnover().removed == k * each);
    CHECK(solver.material().size() == each);
  }
  auto const numbers = solver.material().to_host(identity);
  CHECK(std::set<int>(numbers.begin(), numbers.end()).size() == std::size_t(each));
  CHECK(*std::min_element(numbers.begin(), numbers.end()) == 3 * each);
  auto const V = solver.material().to_host(volume);
  CHECK(std::abs(std::accumulate(V.begin(), V.end(), 0.0) - each * std::pow(dr, dim)) < ulps<TestType>(1000));
  CHECK(solver.remove(LeftOf<F>{-100}).empty());
}

TEMPLATE_LIST_TEST_CASE("particles far away change nothing when they come and when they go", "", Policies) {
  using F = Sand<TestType>;
  constexpr int dim = F::dim;
  auto alone = contracting<F>(block<dim>(0)), joined = contracting<F>(block<dim>(0));
  int const each = alone.material().size();
  for (auto* solver : {&alone, &joined}) {
    solver->run(0.005);
    if (solver == &joined)
      solver->add(points_of<F>(block<dim>(-2)), given(velocity, zero<Vec<dim, typename F::real>>()));
    solver->run(0.010);
    if (solver == &joined) CHECK(solver->remove(LeftOf<F>{-2}).size() == std::size_t(each));
    solver->run(0.015);
  }
  CHECK(alone.steps() == joined.steps());
  CHECK(by_identity(alone.material(), velocity, each) == by_identity(joined.material(), velocity, each));
}

TEMPLATE_LIST_TEST_CASE("particles that replace as many others have neighbours at once", "", Policies) {
  using F = Sand<TestType>;
  constexpr int dim = F::dim;
  using X = Vec<dim, typename F::real>;
  auto const contract = [](X const& x) { return X(typename F::real(-0.3) * x); };
  auto there = contracting<F>(block<dim>(0)), replaced = contracting<F>(block<dim>(-3));
  replaced.step(1e-4);
  replaced.add(points_of<F>(block<dim>(0)), given(velocity, contract));
  replaced.remove(LeftOf<F>{-2});
  REQUIRE(there.material().size() == replaced.material().size());
  for (int k = 0; k < 20; ++k) {
    double const dt = there.step(1e-4);
    CHECK(replaced.step(1e-4) == dt);
  }
  CHECK(there.material().to_host(velocity) == replaced.material().to_host(velocity));
}

TEMPLATE_TEST_CASE("a run in which particles come and go continues from a snapshot bit for bit", "",
                   (Sand<OnHost, Midpoint>), (Sand<OnHost, VelocityVerlet>)) {
  using F = TestType;
  auto const go_on = [](Solver<F>& solver, int from, int to) {
    for (int k = from; k < to; ++k) {
      solver.step(2e-4);
      if (k % 10 == 3) {
        auto const above = fill_lattice(Box<2>{{0.1, 1.0 + 0.3 * k}, {0.5, 1.2 + 0.3 * k}}, dr);
        solver.add(above, given(velocity, Vec<2, double>(0, -1)));
      }
      if (k % 10 == 8) solver.remove(LeftOf<F>{0.005 * k});
    }
  };
  auto whole = contracting<F>(block<2>(0)), second = contracting<F>(block<2>(0));
  go_on(whole, 0, 37);
  auto const snapshot = whole.snapshot();
  go_on(whole, 37, 80);
  second.restore(snapshot);
  CHECK(second.turnover().added == 4 * 8);
  CHECK(second.turnover().removed > 0);
  go_on(second, 37, 80);
  CHECK(whole.material().size() == second.material().size());
  CHECK(whole.material().to_host(identity) == second.material().to_host(identity));
  CHECK(whole.material().to_host(position) == second.material().to_host(position));
  CHECK(whole.material().to_host(stress) == second.material().to_host(stress));
  CHECK(whole.lost() == second.lost());

  auto damaged = snapshot;
  ++damaged.counters["material particles/removed"];
  CHECK_THROWS_WITH(second.restore(damaged), ContainsSubstring("particles instead of"));
  damaged = snapshot;
  damaged.counters["material particles/removed"] = 1000000;
  CHECK_THROWS_WITH(second.restore(damaged), ContainsSubstring("1000000 were removed"));
  damaged = snapshot;
  for (auto& array : damaged.arrays)
    if (array.name == "material/identity") std::copy_n(array.bytes.begin(), 4, array.bytes.begin() + 4);
  CHECK_THROWS_WITH(second.restore(damaged), ContainsSubstring("'material/identity' has"));
}

TEST_CASE("particles are not added where others are") {
  auto solver = contracting<Sand<OnHost>>(block<2>(0));
  solver.step(1e-4);
  int const before = solver.material().size();
  CHECK_THROWS_WITH(solver.add(block<2>(0)), ContainsSubstring("among those to be added, particle 0") &&
                                                 ContainsSubstring("those that are there"));
  CHECK(solver.material().size() == before);
  CHECK(solver.turnover().added == 0);
  solver.add({});
  CHECK(solver.material().size() == before);
}

TEST_CASE("a particle that is in the way of new ones is named by its identity in the case") {
  auto const wall = block<2>(2);
  auto both = block<2>(0);
  auto const first = int(both.size());
  for (auto const& x : block<2>(1)) both.push_back(x);
  Solver<Sand<OnHost>> solver({.spacing = dr, .physics = weightless(), .lost_share = 1}, both, wall);
  solver.remove(LeftOf<basis_of<Sand<OnHost>>>{1});
  auto const beside = [](Vec<2, double> const& x) { return Points<2>{{9, 9}, x + Vec<2, double>(0.004, 0)}; };
  for (int const k : {0, 17, 35}) {
    CHECK_THROWS_WITH(solver.add(beside(both[std::size_t(first + k)])),
                      ContainsSubstring("particle 1 at ") &&
                          ContainsSubstring("is 0.004 m from particle " + std::to_string(first + k) + " of those"));
    CHECK_THROWS_WITH(solver.add(beside(wall[std::size_t(k)])),
                      ContainsSubstring("particle 1 at ") &&
                          ContainsSubstring("is 0.004 m from particle " + std::to_string(k) + " of the wall"));
  }
}

TEST_CASE("rates of new particles are those of the present state") {
  auto solver = contracting<Sand<OnHost>>(block<2>(0));
  solver.run(0.002);
  auto const points = block<2>(2);
  solver.add(points, given(velocity, [](auto const& x) { return Vec<2, double>(3 * x[1], 0); }));
  auto const rates = solver.material().to_host(shear_rate);
  CHECK(std::abs(rates.back()) > 0.1);
  CHECK(std::all_of(rates.end() - long(points.size()), rates.end(), [](double rate) { return rate > 0; }));
}

}  // namespace scree::test::add_and_remove_tests
