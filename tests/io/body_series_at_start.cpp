// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/io/point_data_of.hpp>

#include <support/granular_box.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

namespace scree::test::body_series_at_start_tests {
using granular_box::stepped;

TEMPLATE_TEST_CASE("the first output has the rates of the initial state, and writing it does not change the run", "",
                   Midpoint, SymplecticEuler, VelocityVerlet) {
  auto plain = granular_box::turning<double, TestType>(), written = granular_box::turning<double, TestType>();
  auto const data = point_data_of(written, Fields<ShearRate, SegregationVelocity>{});
  auto const& shear_rates = std::get<std::vector<double>>(data.arrays[0].values);
  auto const& speeds = std::get<std::vector<double>>(data.arrays[1].values);
  double const largest = *std::max_element(shear_rates.begin(), shear_rates.end());
  CHECK(largest > 0.3);  // u = 0.3 z^2
  CHECK(*std::max_element(speeds.begin(), speeds.end()) > 5 * 0.01 * 0.3);
  auto const a = stepped(plain, 20).snapshot(), b = stepped(written, 20).snapshot();
  CHECK(a.time == b.time);
  CHECK(a.arrays == b.arrays);
}

}  // namespace scree::test::body_series_at_start_tests
