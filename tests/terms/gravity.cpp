// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/gravity.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::gravity_tests {

TEST_CASE("gravity acts against the last coordinate, on a slope also along the first") {
  using Plane = Vec<2, double>;
  using Space = Vec<3, double>;
  CHECK(Gravity{}.vector<Plane>() == Plane(0, -9.81));
  CHECK(Gravity{2}.vector<Space>() == Space(0, 0, -2));
  double const angle = 0.5235987755982989;  // 30 degrees
  CHECK((Gravity{2, angle}.vector<Plane>() - Plane(1, -1.7320508075688772)).norm() < 1e-15);
  CHECK((Gravity{2, angle}.vector<Space>() - Space(1, 0, -1.7320508075688772)).norm() < 1e-15);
}

TEST_CASE("the direction of gravity is that of its vector, and none without gravity") {
  using Plane = Vec<2, double>;
  using Space = Vec<3, double>;
  Space const x(0.3, -0.7, 0.2);
  // Exact on level ground, so that results do not depend on how the direction is given.
  CHECK(Gravity{}.direction().component(Plane(0.3, 0.2)) == -0.2);
  CHECK(Gravity{}.direction().component(x) == -0.2);
  CHECK(Gravity{0, 0.5}.direction().component(x) == 0);
  for (double const angle : {0.0, 0.5, 1.5707963267948966, 2.5, -1.0}) {
    for (double const magnitude : {9.81, 1e-3, -2.0}) {
      Gravity const gravity{magnitude, angle};
      CHECK(std::abs(gravity.direction().component(x) - gravity.vector<Space>().normalized().dot(x)) < 1e-15);
      CHECK(std::abs(gravity.direction().component(gravity.vector<Plane>()) - std::abs(magnitude)) < 1e-14);
    }
  }
}

}  // namespace scree::test::gravity_tests
