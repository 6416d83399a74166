// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <scree/granular/granular.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/mixing/mixing_table.hpp>
#include <scree/probes/coarse_grained.hpp>
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <vector>

// Measures of mixing and coarse-grained fields of a case on ranks: the bits of one rank.
namespace scree::test::measures_tests {
using namespace fields;
namespace {

template <int Dim, class Real>
struct Heap : Formulation<Dim, Real> {
  using space = Space;
  using physics = SegregatingGranular<Granular<>, ConservativeSegregation<ShearRateClosure>>;
  using diagnostics = NeighbourMixing<>;
  using carries = Fields<StartPosition>;
};

/// All numbers that measures give for a state.
template <class S>
std::vector<double> numbers_of(S& solver, CoarseGrid<S::policy::dim> const& grid) {
  auto numbers = mixing_row(solver, {.grains = {1e-7, 8e-7}});
  auto const found = coarse_grained(solver, grid, Fields<Velocity, Stress, Concentration, Pressure>{});
  numbers.insert(numbers.end(), found.weight.begin(), found.weight.end());
  for (auto const& u : found[velocity]) numbers.insert(numbers.end(), u.data(), u.data() + u.size());
  for (auto const& s : found[stress]) numbers.insert(numbers.end(), s.data(), s.data() + s.size());
  numbers.insert(numbers.end(), found[concentration].begin(), found[concentration].end());
  numbers.insert(numbers.end(), found[pressure].begin(), found[pressure].end());
  return numbers;
}

/// The numbers at the start, as each rank has them, and after some steps of a column that falls to the right.
template <int Dim, class Real>
std::vector<std::vector<double>> numbers_on(int ranks, bool from_shares, int steps) {
  using F = Heap<Dim, Real>;
  std::vector<std::vector<double>> found;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    double const dr = 0.02;
    SolverSettings<OnRanks<F>> settings;
    settings.ranks.team = team;
    settings.spacing = dr;
    if (Dim == 3) settings.periods = {{1, 0, 0.12}};
    settings.physics.mechanics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
    settings.physics.transport.closure = ShearRateClosure{.d_small = 1e-3, .d_large = 2e-3};
    auto sand = Box<Dim>{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(0.2)};
    if (Dim == 3) sand.high[1] = 0.12;
    auto floor = sand;
    floor.low[0] = -0.1, floor.high[0] = 0.6, floor.low[Dim - 1] = -4 * dr, floor.high[Dim - 1] = 0;
    auto const make = [&] {
      if (!from_shares)
        return Solver<OnRanks<F>>(space, settings, cast<Real>(fill_lattice(sand, dr)),
                                  cast<Real>(fill_lattice(floor, dr)));
      Groups<Dim> bed, below;
      bed.add("sand", fill_lattice(sand, dr, team.share()));
      below.add("floor", fill_lattice(floor, dr, team.share()));
      return Solver<OnRanks<F>>(space, settings, bed, below);
    };
    auto solver = make();
    solver.set(concentration, [](auto const& x) { return Real(x[0] < 0.1 ? 1 : 0.2); });
    solver.set(velocity, [](auto const& x) {
      auto u = zero<Vec<Dim, Real>>();
      u[0] = 2 + 5 * x[Dim - 1];
      return u;
    });
    mark_start(solver);
    auto box = sand;
    box.high[0] = 0.4;
    CoarseGrid<Dim> const grid{.box = box, .cell = Vec<Dim, double>::Constant(0.04)};
    auto const first = numbers_of(solver, grid);
    for (int k = 0; k < steps; ++k) solver.step(1);
    auto const last = numbers_of(solver, grid);
    auto const same = [&](std::vector<double> const& mine) {
      auto const all = team.gather(mine);
      for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k] != mine[k % mine.size()] && !std::isnan(all[k])) return false;
      return true;
    };
    bool const alike = same(first) && same(last);
    if (team.rank() == 0) {
      CHECK(alike);
      CHECK(solver.ranks().counts().migrated >= (ranks == 1 ? 0 : 1));
      found = {first, last};
    }
  });
  return found;
}

/// The number of values that differ; NaN is NaN.
long differences(std::vector<double> const& a, std::vector<double> const& b) {
  if (a.size() != b.size()) return 1'000'000;
  long count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) count += a[k] != b[k] && !(std::isnan(a[k]) && std::isnan(b[k]));
  return count;
}

template <int Dim, class Real>
void check_ranks(std::vector<int> const& all, int steps) {
  auto const one = numbers_on<Dim, Real>(1, false, steps);
  REQUIRE(one.size() == 2);
  CHECK(differences(one[0], one[1]) > 10);
  for (int const ranks : all)
    for (bool const shares : {false, true}) {
      INFO(ranks << " ranks, " << (shares ? "from shares" : "whole"));
      auto const several = numbers_on<Dim, Real>(ranks, shares, steps);
      CHECK(differences(several[0], one[0]) == 0);
      CHECK(differences(several[1], one[1]) == 0);
    }
}

}  // namespace

TEST_CASE("measures of mixing and coarse-grained fields on ranks have the bits of one rank") {
  check_ranks<2, double>({2, 3}, 150);
  check_ranks<2, float>({2}, 100);
  check_ranks<3, double>({2}, 60);
}

}  // namespace scree::test::measures_tests
