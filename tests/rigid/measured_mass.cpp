// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/rigid/measured_mass.hpp>
#include <scree/setup/shapes.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <numbers>

namespace scree::test::measured_mass_tests {

TEST_CASE("mass properties of shapes are those of their exact integrals") {
  auto const plate = mass_properties(Box<2>{{0.1, 0}, {0.5, 0.2}}, 1000, 0.02);
  CHECK(std::abs(plate.mass - 80) < 1e-9);
  CHECK((plate.centre - Vec<2, double>(0.3, 0.1)).norm() < 1e-12);
  CHECK(std::abs(plate.inertia(0, 0) - 80 * (0.16 + 0.04) / 12) < 1e-9);

  auto const ball = mass_properties(Ball<3>{.centre = {1, 2, 3}, .radius = 0.1}, 2000, 0.01);
  double const m = 2000 * 4.0 / 3 * std::numbers::pi * 1e-3;
  CHECK(std::abs(ball.mass / m - 1) < 3e-3);
  CHECK((ball.inertia - 0.4 * m * 0.01 * Mat<3, double>::Identity()).norm() < 1e-2 * m * 0.01);
  ball.check();
}

TEST_CASE("mass properties of a mesh are exact") {
  Triangles tetrahedron;
  tetrahedron.vertices = {{1, 1, 1}, {2, 1, 1}, {1, 3, 1}, {1, 1, 4}};
  tetrahedron.corners = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  auto const found = mass_properties(Mesh(tetrahedron), 10);
  CHECK(std::abs(found.mass - 10) < 1e-12);
  CHECK((found.centre - Vec<3, double>(1.25, 1.5, 1.75)).norm() < 1e-12);
  // The tetrahedron at a corner with edges a, b, c, about the centre: I_xx = 3 m (b^2 + c^2)/80, I_xy = m a b/80.
  CHECK(std::abs(found.inertia(0, 0) - 10 * 3 * (4 + 9) / 80.0) < 1e-12);
  CHECK(std::abs(found.inertia(0, 1) - 10 * 2 / 80.0) < 1e-12);
  found.check();

  tetrahedron.corners.pop_back();
  CHECK_THROWS(mass_properties(Mesh(tetrahedron), 10));
}

}  // namespace scree::test::measured_mass_tests
