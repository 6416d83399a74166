// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/motion.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::motion_tests {
namespace {
struct NoVelocity {
  template <class X>
  X displaced(X const& x, double, double) const {
    return x;
  }
  double time_step() const { return 1; }
};
}  // namespace

TEST_CASE("what rests neither moves nor limits the step") {
  STATIC_CHECK(PrescribedMotion<AtRest, 2, float>);
  STATIC_CHECK(PrescribedMotion<AtRest, 3, double>);
  Vec<3, double> const x(1, 2, 3);
  CHECK(AtRest{}.displaced(x, 0, 9) == x);
  CHECK(AtRest{}.velocity(x, 4) == Vec<3, double>(0, 0, 0));
  CHECK(std::isinf(AtRest{}.time_step()));
}

TEST_CASE("a motion without a velocity is none") { STATIC_CHECK_FALSE(PrescribedMotion<NoVelocity, 2, double>); }

}  // namespace scree::test::motion_tests
