// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/brute_force.hpp>

#include <support/candidates.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numeric>

namespace scree::test::brute_force_tests {

TEMPLATE_LIST_TEST_CASE("brute force offers every source to every target, by ascending index", "", Policies) {
  using P = TestType;
  auto const targets = positions_of<P>(random_points<P::dim>(7, 0, 1, 1));
  auto const sources = positions_of<P>(random_points<P::dim>(12, 0, 100, 2));
  BruteForce<P> search(0.1);
  search.update(targets, sources);
  std::vector<int> all(12);
  std::iota(all.begin(), all.end(), 0);
  for (auto const& offered : candidates<P>(search, targets)) CHECK(offered == all);
  CHECK(search.builds() == 0);
}

}  // namespace scree::test::brute_force_tests
