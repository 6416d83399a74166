// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "random_stresses.hpp"

#include <scree/laws/return_mapping.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

namespace scree::test::return_mapping_tests {
namespace {

template <class Real>
Real tau_of(StressTensor<Real> const& sigma) {
  return equivalent_shear_stress(deviator_of(sigma));
}
// sqrt(J2) - k p - k_c, relative to its terms.
template <class Real>
Real yield_of(StressTensor<Real> const& sigma, Cone<Real> const& cone) {
  Real const p = pressure_of(sigma), tau = tau_of(sigma);
  return (tau - cone.friction * p - cone.cohesion) / (tau + std::abs(cone.friction * p) + cone.cohesion);
}
template <int Dim, class Real>
StressTensor<Real> stored(StressTensor<Real> const& sigma) {
  return unpacked(packed<Dim>(sigma));
}

template <int Dim, class Real>
void check_cohesionless() {
  Real const eps = std::numeric_limits<Real>::epsilon(), k = Real(0.35);
  RandomStresses<Dim, Real> random;
  int untouched = 0, sheared = 0, lost = 0;
  for (int n = 0; n < 3000; ++n) {
    auto const trial = random.next();
    auto const once = stored<Dim>(return_to_cone(trial, k)), twice = stored<Dim>(return_to_cone(once, k));
    Real const p = pressure_of(trial);
    REQUIRE((twice - once).norm() <= 8 * eps * once.norm());
    if (once == trial) {
      ++untouched;
      REQUIRE(yield_of(trial, {k, 0, 0}) <= 4 * eps);
    } else if (!(p > 0)) {
      ++lost;
      REQUIRE(once.isZero(0));
    } else {
      ++sheared;
      REQUIRE(yield_of(trial, {k, 0, 0}) > 0);
      REQUIRE(std::abs(yield_of(once, {k, 0, 0})) < 8 * eps);
      REQUIRE(std::abs(pressure_of(once) - p) < 8 * eps * p);
      StressTensor<Real> const s = deviator_of(trial), kept = deviator_of(once);
      REQUIRE((s / tau_of(trial) - kept / tau_of(once)).norm() < 16 * eps / k);
    }
  }
  CHECK(untouched > 300);
  CHECK(sheared > 300);
  CHECK(lost > 900);
}

// One of three regions: admissible; on the cone, along the flow; at the tip, because no flow from the cone leads there.
template <int Dim, class Real>
void check_cone(Cone<Real> const& cone, Real shear_to_bulk) {
  Real const eps = std::numeric_limits<Real>::epsilon(), tip = -cone.cohesion / cone.friction;
  RandomStresses<Dim, Real> random;
  int on_cone = 0, at_tip = 0;
  for (int n = 0; n < 3000; ++n) {
    auto const trial = random.next();
    auto const once = stored<Dim>(return_to_cone(trial, cone, shear_to_bulk));
    auto const twice = return_to_cone(once, cone, shear_to_bulk);
    Real const tau = tau_of(trial), p = pressure_of(trial), size = tau + std::abs(p) + cone.cohesion;
    REQUIRE((twice - once).norm() <= 16 * eps * (once.norm() + cone.cohesion));
    if (once == trial) {
      REQUIRE(yield_of(trial, cone) <= 4 * eps);
      continue;
    }
    Real const raised = pressure_of(once) - p, flowed = (tau - tau_of(once)) / shear_to_bulk;
    if (tau_of(once) > 0) {
      ++on_cone;
      REQUIRE(std::abs(yield_of(once, cone)) < 16 * eps);
      REQUIRE(std::abs(raised - cone.dilatancy * flowed) < 16 * eps * size);
    } else {
      ++at_tip;
      REQUIRE(std::abs(pressure_of(once) - tip) <= 4 * eps * std::abs(tip));
      REQUIRE(raised >= cone.dilatancy * flowed - 16 * eps * size);
    }
  }
  CHECK(on_cone > 300);
  CHECK(at_tip > 100);
}

}  // namespace

TEMPLATE_TEST_CASE("return mapping: cohesionless stresses land on the cone, at once and for good", "", float, double) {
  check_cohesionless<2, TestType>();
  check_cohesionless<3, TestType>();
}

TEMPLATE_TEST_CASE("return mapping: with cohesion and dilatancy stresses land on the cone or at its tip", "", float,
                   double) {
  using C = Cone<TestType>;
  check_cone<2, TestType>(C{TestType(0.4), 5, TestType(0.4)}, TestType(0.46));
  check_cone<3, TestType>(C{TestType(0.6), TestType(0.01), TestType(0.1)}, TestType(1.5));
  check_cone<3, TestType>(C{TestType(0.5), 3, 0}, TestType(0.46));
}

TEMPLATE_TEST_CASE("return mapping: pure tension about and beyond the tip ends there", "", float, double) {
  using Tensor = StressTensor<TestType>;
  TestType const eps = std::numeric_limits<TestType>::epsilon();
  for (int n = 0; n < 2000; ++n) {
    // No deviator; by rounding, zero or a small strength.
    TestType const k = TestType(0.1 + 0.001 * (n / 10)), tip = 7 / k;
    Tensor const trial = Tensor::Identity() * (tip * (1 + TestType(n % 10 - 3) * eps));
    Tensor const near = return_to_cone(trial, Cone<TestType>{k, 7, k}, TestType(0.1));
    Tensor const far = return_to_cone(Tensor(1000 * trial), Cone<TestType>{k, 7, k}, TestType(0.1));
    REQUIRE((near - tip * Tensor::Identity()).norm() <= 50 * eps * tip);
    REQUIRE(far == Tensor(tip * Tensor::Identity()));
  }
}

TEMPLATE_TEST_CASE("return mapping: a cone without friction keeps the pressure of any sign", "", float, double) {
  StressTensor<TestType> trial = StressTensor<TestType>::Identity() * 7;
  trial(0, 1) = trial(1, 0) = 4;
  auto const ideal = return_to_cone(trial, Cone<TestType>{}, TestType(1));
  auto const cohesive = return_to_cone(trial, Cone<TestType>{0, 2, 0}, TestType(1));
  CHECK(ideal == StressTensor<TestType>(StressTensor<TestType>::Identity() * 7));
  CHECK(cohesive(0, 1) == 2);
  CHECK(pressure_of(cohesive) == -7);
}

TEMPLATE_TEST_CASE("return mapping: what is not finite bears nothing", "", float, double) {
  using L = std::numeric_limits<TestType>;
  for (TestType const bad : {L::quiet_NaN(), L::infinity(), -L::infinity()})
    for (int a = 0; a < 3; ++a)
      for (int b = a; b < 3; ++b)
        for (TestType const dilatancy : {TestType(0), TestType(0.3)}) {
          StressTensor<TestType> trial = -StressTensor<TestType>::Identity();
          trial(a, b) = trial(b, a) = bad;
          Cone<TestType> const cone{TestType(0.5), 1, dilatancy};
          CAPTURE(bad, a, b, dilatancy);
          CHECK(return_to_cone(trial, TestType(0.5)).isZero(0));
          CHECK(return_to_cone(trial, cone, TestType(1)).isZero(0));
        }
  StressTensor<TestType> sheared = -StressTensor<TestType>::Identity();
  sheared(0, 1) = sheared(1, 0) = 1;
  CHECK(return_to_cone(sheared, L::quiet_NaN()).isZero(0));
}

}  // namespace scree::test::return_mapping_tests
