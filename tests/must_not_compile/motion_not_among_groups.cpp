// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this motion is not among those that AnyMotion or MotionOfGroups names: add its type to the list
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>

void open_gate() {
#ifdef FIXED
  scree::MotionOfGroups<2, scree::Rotation, scree::Translation<2>> motion(2);
#else
  scree::MotionOfGroups<2, scree::Rotation> motion(2);
#endif
  motion.set(1, scree::Translation<2>{.speed = {0, 1}});
}
