// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/summary.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::figures_tests {

TEST_CASE("a summary has the packing of grains under pressure, and no number where there are none") {
  app::Json::Object some, none;
  app::add_packing(some, {.particles = 40, .full = 20, .density = 1.0, .loose = 0.75, .dense = 1.25});
  app::add_packing(none, {.particles = 40, .full = 0});
  CHECK(app::to_json(some) == R"({
    "packing" : 1.0,
    "packing_densest" : 1.25,
    "packing_loosest" : 0.75
}
)");
  CHECK(app::to_json(none) == R"({
    "packing" : "NaN",
    "packing_densest" : "NaN",
    "packing_loosest" : "NaN"
}
)");
}

}  // namespace scree::test::figures_tests
