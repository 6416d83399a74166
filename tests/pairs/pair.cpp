// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/pairs/pair.hpp>

#include <support/policies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::pair_tests {

TEMPLATE_LIST_TEST_CASE("a pair knows the kernel and its gradient, which points to the neighbour", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  using vector = Vec<P::dim, real>;
  kernel_of<P> const kernel(0.2);
  vector x = vector::Constant(real(0.05));
  x[0] = real(-0.1);
  real const r = x.norm();
  Pair<P> const ij(x, r, kernel);
  CHECK(ij.h() == kernel.h());
  CHECK(ij.W() == kernel.value(r));
  CHECK(ij.slope() == kernel.slope_over_distance(r));
  CHECK(ij.slope() < 0);
  CHECK(ij.gradW().dot(x) < 0);
  // Along each axis the difference of W between the two ends of a step; it is of second order in the step.
  real const step = std::is_same_v<real, float> ? real(1e-3) : real(1e-5);
  for (int axis = 0; axis < P::dim; ++axis) {
    vector const dx = step * vector::Unit(axis);
    double const slope = double(kernel.value((x + dx).norm()) - kernel.value((x - dx).norm())) / double(2 * step);
    CHECK(std::abs(double(ij.gradW()[axis]) - slope) < ulps<P>(1e-1) / double(sq(step)) * double(ij.W()));
  }
  Pair<P> const itself(vector::Zero(), 0, kernel);
  CHECK(itself.W() == kernel.value(0));
  CHECK(itself.gradW() == vector(vector::Zero()));
}

}  // namespace scree::test::pair_tests
