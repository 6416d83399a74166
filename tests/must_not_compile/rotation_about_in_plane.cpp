// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: RotationAbout turns points in space: in the plane use Rotation
#include <scree/motion/rotation.hpp>
#include <scree/motion/rotation_about.hpp>

scree::Vec<2, double> turned(scree::Vec<2, double> const& x) {
#ifdef FIXED
  scree::Rotation const turn{.rate = 1};
#else
  scree::RotationAbout const turn(1, {0, 0, 1});
#endif
  return turn.displaced(x, 0.0, 1.0);
}
