// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/flow_consistency.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

namespace scree::test::flow_consistency_tests {
namespace {

double const K = 2e5, p = 800, root = std::sqrt(K / p);  // Pa, Pa, -

}  // namespace

TEMPLATE_TEST_CASE("loaded material at rest keeps its pressure, however loose or dense", "", double, float) {
  using Real = TestType;
  FlowConsistency const control;
  for (double const denser : {-0.5, -0.01, 0.01, 0.5})
    for (double const N : {0.0, 1e-4, 2.9e-3})
      CHECK(control.pressure_per_strain(Real(p), Real(K), Real(denser), Real(N / root)) == 0);
}

TEST_CASE("in flow, and without pressure at any speed, the control is that of VolumeConsistency") {
  FlowConsistency const control;
  VolumeConsistency const loaded{.per_strain = 1}, unloaded{.per_strain = 3};
  for (double const denser : {-0.5, -0.01, 0.0, 0.01, 0.5}) {
    INFO("denser by " << denser);
    for (double const N : {0.0301, 1.0, 1e3})
      CHECK(control.pressure_per_strain(p, K, denser, N / root) == loaded.pressure_per_strain(p, K, denser));
    for (double const sheared : {0.0, 1e-9, 1e-2})
      CHECK(control.pressure_per_strain(0.0, K, denser, sheared) == unloaded.pressure_per_strain(0.0, K, denser));
  }
}

TEST_CASE("between rest and flow the share of the control rises smoothly") {
  FlowConsistency const control{.rest = 0.01, .flow = 0.03};
  auto const at = [&](double N) { return control.share(p, K, N / root); };
  CHECK(std::abs(at(0.02) - 0.5) < 1e-12);
  CHECK(std::abs(at(0.015) - 5.0 / 32) < 1e-12);  // s^2 (3 - 2 s) at s = 1/4
  double const step = 1e-6;
  for (double const end : {0.01, 0.03}) CHECK(std::abs(at(end + step) - at(end - step)) < 1e-6);  // no jump
  double before = 0;
  for (double N = 0.009; N < 0.031; N += 1e-3) {
    CHECK(at(N) >= before);
    before = at(N);
  }
  CHECK(before == 1);
}

TEST_CASE("the same shear flows under a small pressure and rests under a large one") {
  FlowConsistency const control;
  double const sheared = 3e-4;
  CHECK(control.share(1.0, K, sheared) == 1);
  CHECK(control.share(1e4, K, sheared) == 0);
}

TEMPLATE_TEST_CASE("material without shear rests under the smallest pressure too", "", double, float) {
  using Real = TestType;
  FlowConsistency const control;
  Real const smallest = std::numeric_limits<Real>::denorm_min(), K = Real(1e6);
  CHECK(control.pressure_per_strain(smallest, K, Real(0.1), Real(0)) == 0);
  CHECK(control.share(smallest, K, Real(1e-3)) == 1);
}

TEST_CASE("flow that begins below rest is refused") {
  FlowConsistency const control{.rest = 0.1, .flow = 0.05};
  CHECK_THROWS_AS(control.check(), std::invalid_argument);
  CHECK_NOTHROW(FlowConsistency{}.check());
}

}  // namespace scree::test::flow_consistency_tests
