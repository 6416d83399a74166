// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/motion/motion.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <vector>

// Consistency of the functions of every motion.
namespace scree::test {

/// A point off all axes.
template <int Dim>
Vec<Dim, double> some_point() {
  Vec<Dim, double> x = Vec<Dim, double>::Constant(0.3);
  x[0] = 1.2;
  x[Dim - 1] = 0.8;
  return x;
}

/// Velocity and acceleration against central differences along the path of a point, and displacements in sequence; for
/// motions with derivatives of order one.
template <int Dim, class Motion>
void check_kinematics(Motion const& motion, std::vector<double> const& times) {
  STATIC_CHECK(PrescribedMotion<Motion, Dim, double>);
  STATIC_CHECK(PrescribedMotion<Motion, Dim, float>);
  auto const x = some_point<Dim>();
  using X = std::remove_cvref_t<decltype(x)>;
  double const d = 1e-4;
  for (double const t : times) {
    INFO("time " << t);
    X const ahead = motion.displaced(x, t, t + d), behind = motion.displaced(x, t, t - d);
    CHECK(((ahead - behind) / (2 * d) - motion.velocity(x, t)).norm() < 1e-6);
    X const change = motion.velocity(ahead, t + d) - motion.velocity(behind, t - d);
    CHECK((change / (2 * d) - motion.acceleration(x, t)).norm() < 1e-6);
    X const in_two = motion.displaced(motion.displaced(x, t, 1.9), 1.9, 2.6);
    CHECK((in_two - motion.displaced(x, t, 2.6)).norm() < 1e-14);
    CHECK((motion.displaced(in_two, 2.6, t) - x).norm() < 1e-14);
  }
}

}  // namespace scree::test
