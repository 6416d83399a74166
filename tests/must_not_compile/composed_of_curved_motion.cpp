// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: Composed joins motions whose velocity is affine in x
#include <scree/motion/composed.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>

struct Swirl : scree::Translation<2> {
  template <class X>
  scree::Mat<2, typename X::Scalar> velocity_gradient(X const&, double) const {
    return {};
  }
};

scree::Vec<2, double> moved(scree::Vec<2, double> const& x) {
#ifdef FIXED
  scree::Composed<scree::Rotation, scree::Translation<2>> const motion;
#else
  scree::Composed<scree::Rotation, Swirl> const motion;
#endif
  return motion.displaced(x, 0.0, 1.0);
}
