// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// R11: more particles in a cell, and more cells, than any capacity.
#include "tally.hpp"

#include <neighbours/all.hpp>
#include <support/candidates.hpp>

#include <catch2/catch_template_test_macros.hpp>

namespace scree::test::overflow_tests {
namespace {

constexpr double radius = 0.1;

/// The faults of the candidates of every search.
template <class P>
void attempt(Tally& tally, std::string const& name, Points<P::dim> const& points) {
  auto const x = positions_of<P>(points);
  for_each_search(static_cast<BuiltSearches<P>*>(nullptr), [&]<class Search>() {
    try {
      Search search(radius);
      search.update(x, x);
      auto const fault = fault_of_candidates<P>(candidates<P>(search, x), values_of(x), values_of(x), radius);
      tally.count(fault.empty() ? "" : name + ": " + fault);
    } catch (std::runtime_error const& refused) {
      bool const explained = std::string(refused.what()).starts_with("scree: ");
      tally.count(explained ? "" : name + ": " + refused.what());
    }
  });
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a thousand particles in one cell find each other", "[R11]", Policies) {
  using P = TestType;
  Tally tally("R11");
  tally.note("a thousand in a cell");
  for (int k = 0; k < attempts(1, 10); ++k) {
    auto const seed = static_cast<unsigned>(k);
    auto points = random_points<P::dim>(300, 0, 1, seed);
    auto const clump = random_points<P::dim>(1000, 0.31, 0.33, seed + 1);
    points.insert(points.end(), clump.begin(), clump.end());
    attempt<P>(tally, "a clump", points);
    attempt<P>(tally, "all at one place", Points<P::dim>(1000, clump.front()));
  }
}

TEMPLATE_LIST_TEST_CASE("domains of more cells than can be counted keep their pairs", "[R11]", Policies) {
  using P = TestType;
  Tally tally("R11");
  tally.note("far more cells than 2^31");
  double const largest = std::is_same_v<typename P::real, float> ? 1e37 : 1e300;
  for (int k = 0; k < attempts(1, 10); ++k)
    for (double far : {1e3, 1e6, 1e9, 1e12, 1e20, largest}) {
      auto points = random_points<P::dim>(400, 0, 1, static_cast<unsigned>(k));
      for (double const side : {-far, far}) {
        points.push_back(Vec<P::dim, double>::Constant(side));
        points.push_back(Vec<P::dim, double>::Zero());
        points.back()[k % P::dim] = side;
      }
      attempt<P>(tally, "up to " + std::to_string(far) + " m", points);
    }
}

}  // namespace scree::test::overflow_tests
