// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/principal.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <tuple>

namespace scree::test::principal_tests {
namespace {
template <class Real>
Mat<3, Real> random_symmetric(std::mt19937& random) {
  std::uniform_real_distribution<Real> uniform(-1, 1);
  Mat<3, Real> A;
  for (int k = 0; k < 9; ++k) A.data()[k] = uniform(random);
  return A + A.transpose();
}
using Reals = std::tuple<double, float>;
}  // namespace

TEMPLATE_LIST_TEST_CASE("principal values and axes put a tensor together again", "", Reals) {
  std::mt19937 random(3);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    auto const A = random_symmetric<TestType>(random);
    auto const p = principal(A);
    Mat<3, TestType> const again = p.axes * p.values.asDiagonal() * p.axes.transpose();
    worst = std::max({worst, double((again - A).norm()),
                      double((p.axes * p.axes.transpose() - Mat<3, TestType>::Identity()).norm())});
  }
  CHECK(worst < 100 * double(std::numeric_limits<TestType>::epsilon()));
}

TEMPLATE_LIST_TEST_CASE("a tensor is its positive part less that of its negative", "", Reals) {
  std::mt19937 random(4);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    auto const A = random_symmetric<TestType>(random);
    Mat<3, TestType> const minus = -A, parts = positive_part(A) - positive_part(minus);
    worst = std::max(worst, double((parts - A).norm()));
  }
  CHECK(worst < 100 * double(std::numeric_limits<TestType>::epsilon()));
  Mat<3, TestType> const tension = 2 * Mat<3, TestType>::Identity(), pressure = -tension;
  CHECK(positive_part(tension) == tension);
  CHECK(positive_part(pressure).norm() == 0);
}

}  // namespace scree::test::principal_tests
