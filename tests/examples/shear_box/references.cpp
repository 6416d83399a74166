// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <shear_box/references.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::shear_box_references_tests {
using namespace shear_box;

TEST_CASE("references exist for every allowed pair of V and D, none of them included") {
  Options o;
  o.geometry.upright = true;  // one-dimensional
  for (auto const& [V, D] : {std::pair{3e-2, 1e-3}, {0.0, 1e-3}, {3e-2, 0.0}, {0.0, 0.0}}) {
    INFO("V* " << V << ", D* " << D);
    o.model.V_star = V, o.model.D_star = D;
    auto const references = solve_references(o, {1, 2});
    REQUIRE(references.best.size() == 2);
    double mean = 0;
    for (int k = 0; k < 100; ++k) mean += references.best[1](0.1, (k + 0.5) / 100) / 100;
    CHECK(mean == Catch::Approx(0.5));  // the initial mean
  }
}

TEST_CASE("references that are not solved yet are NaN") {
  auto const references = unsolved_references({1, 2});
  CHECK(references.times == std::vector<double>{1, 2});
  for (auto const* solutions : {&references.best, &references.one_dimensional}) {
    REQUIRE(solutions->size() == 2);
    CHECK(std::isnan((*solutions)[1](0.1, 0.5)));
  }
}

}  // namespace scree::test::shear_box_references_tests
