// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/transport.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::limits_tests {

TEST_CASE("steps of segregation and diffusion follow from their speeds over h") {
  TransportStep const step{.diffusion = 0.1, .segregation = 0.2};
  for (double const h : {0.15, 0.03}) {
    auto const [diffusion, segregation] =
        step.limits({.dimensions = 2, .smoothing_length = h}, {.amplitude = 1.6, .asymmetry = 0.89});
    CHECK(diffusion.name == "diffusion");
    CHECK(diffusion.step(0.01) == Catch::Approx(0.1 * h * h / 0.01).epsilon(1e-12));
    CHECK(segregation.name == "segregation");
    CHECK(segregation.step(0.02) == Catch::Approx(0.2 * h / (1.6 * 0.02)).epsilon(1e-12));
  }
}

}  // namespace scree::test::limits_tests
