// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/gravity.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test {

TEST_CASE("gravity acts against the last coordinate, on a slope also along the first") {
  using Plane = Vec<2, double>;
  using Space = Vec<3, double>;
  CHECK(Gravity{}.vector<Plane>() == Plane(0, -9.81));
  CHECK(Gravity{2}.vector<Space>() == Space(0, 0, -2));
  double const angle = 0.5235987755982989;  // 30 degrees
  CHECK((Gravity{2, angle}.vector<Plane>() - Plane(1, -1.7320508075688772)).norm() < 1e-15);
  CHECK((Gravity{2, angle}.vector<Space>() - Space(1, 0, -1.7320508075688772)).norm() < 1e-15);
}

}  // namespace scree::test
