// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/any_motion.hpp>
#include <scree/motion/oscillating_shear.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/tabulated.hpp>

#include "kinematics.hpp"

#include <cmath>

namespace scree::test::any_motion_tests {
namespace {

/// u = (y^2, 0), with its gradient.
struct Bent {
  template <class X>
  SCREE_FN X displaced(X x, double from, double to) const {
    x[0] += x[1] * x[1] * typename X::Scalar(to - from);
    return x;
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double) const {
    X u = zero<X>();
    u[0] = x[1] * x[1];
    return u;
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return zero<X>();
  }
  template <class X>
  SCREE_FN auto velocity_gradient(X const& x, double) const {
    auto L = zero<Mat<X::RowsAtCompileTime, typename X::Scalar>>();
    L(0, 1) = 2 * x[1];
    return L;
  }
  double time_step() const { return 1; }
};

using V = Vec<2, double>;
using Some = AnyMotion<Rotation, Tabulated<2>, Bent>;

template <class Motion>
void check_same(Some const& any, Motion const& motion) {
  V const x(0.3, 0.7);
  for (double const t : {0.0, 0.2, 1.5}) {
    CHECK(any.displaced(x, 0.1, t) == motion.displaced(x, 0.1, t));
    CHECK(any.velocity(x, t) == motion.velocity(x, t));
    CHECK(any.acceleration(x, t) == motion.acceleration(x, t));
    CHECK(any.velocity_gradient(x, t) == velocity_gradient_at(motion, x, t));
  }
  CHECK(any.time_step() == motion.time_step());
}

}  // namespace

TEST_CASE("a motion chosen at run time is that motion, whichever it is") {
  STATIC_CHECK(PrescribedMotion<Some, 2, float>);
  STATIC_CHECK_FALSE(MotionByGroup<Some>);
  Rotation const rotation{.rate = 2, .centre_x = 0.1};
  Tabulated<2> const table({0.1, 2}, {{0, 0}, {3, 1}});
  check_same(rotation, rotation);
  check_same(table, table);
  check_same(Bent{}, Bent{});
  check_same(AtRest{}, AtRest{});
  Some changed = rotation;
  changed = table;
  check_same(changed, table);
}

TEST_CASE("a motion that nobody has chosen is rest") {
  check_same({}, AtRest{});
  CHECK(std::isinf(AnyMotion<>{}.time_step()));
}

TEST_CASE("a motion chosen at run time has its own gradient if the chosen one has") {
  CHECK_FALSE(Some(Rotation{}).gives_gradient<2, double>());
  CHECK(Some(Bent{}).gives_gradient<2, double>());
  CHECK(Some().gives_gradient<2, double>());
}

}  // namespace scree::test::any_motion_tests
