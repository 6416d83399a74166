// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/motion/motion.hpp>

namespace scree::test::archetypes {

/// Everything is at rest.
struct Motion {
  template <class X>
  SCREE_FN X displaced(X const& x, double, double) const {
    return x;
  }
  template <class X>
  SCREE_FN X velocity(X const&, double) const {
    return zero<X>();
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return zero<X>();
  }
  double time_step() const { return 1; }
};
static_assert(PrescribedMotion<Motion, 2, double> && PrescribedMotion<Motion, 3, float>);

/// A motion by group: all points of both groups are at rest.
struct MotionsByGroup {
  SCREE_FN Motion of(int) const { return {}; }
  int groups() const { return 2; }
  double time_step() const { return 1; }
};
static_assert(PrescribedMotion<MotionsByGroup, 2, double>);

}  // namespace scree::test::archetypes
