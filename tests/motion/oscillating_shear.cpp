// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/oscillating_shear.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::oscillating_shear_tests {
namespace {

OscillatingShear const swing{.amplitude = 0.5, .period = 4, .floor = 0.1};

template <class Vector>
Vector point() {
  Vector x = Vector::Constant(0.3);
  x[0] = 1.2;
  x[x.size() - 1] = 0.8;
  return x;
}
using Vectors = std::tuple<Vec<2, double>, Vec<3, double>>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("an oscillating shear displaces along the first axis by height and shear", "", Vectors) {
  STATIC_CHECK(PrescribedMotion<OscillatingShear, TestType::RowsAtCompileTime, double>);
  auto const x = point<TestType>();
  // A quarter of a period after rest the shear is the amplitude.
  TestType const moved = swing.displaced(x, 0.0, 1.0);
  CHECK(std::abs(moved[0] - (1.2 + 0.7 * 0.5)) < 1e-15);
  CHECK(moved.tail(moved.size() - 1) == x.tail(x.size() - 1));
  CHECK((swing.displaced(x, 0.0, 4.0) - x).norm() < 1e-15);
  TestType at_floor = x;
  at_floor[x.size() - 1] = 0.1;
  CHECK(swing.displaced(at_floor, 0.0, 1.0) == at_floor);
}

TEMPLATE_LIST_TEST_CASE("displacements of an oscillating shear follow each other", "", Vectors) {
  auto const x = point<TestType>();
  TestType const in_two = swing.displaced(swing.displaced(x, 0.3, 1.9), 1.9, 2.6);
  CHECK((in_two - swing.displaced(x, 0.3, 2.6)).norm() < 1e-15);
  CHECK((swing.displaced(swing.displaced(x, 0.3, 1.9), 1.9, 0.3) - x).norm() < 1e-15);
}

TEMPLATE_LIST_TEST_CASE("the velocity of an oscillating shear is the rate of its displacement", "", Vectors) {
  auto const x = point<TestType>();
  double const step = 1e-4;
  for (double const time : {0.0, 0.7, 1.0, 3.1}) {
    TestType const ahead = swing.displaced(x, time, time + step), behind = swing.displaced(x, time, time - step);
    // Error: step^2/6 of the third derivative, 0.35 (2 pi/4)^3.
    CHECK(((ahead - behind) / (2 * step) - swing.velocity(x, time)).norm() < 1e-8);
  }
}

TEST_CASE("a step of an oscillating shear strains by no more than asked for") {
  double const dt = swing.time_step();
  double largest = 0;
  for (double time = 0; time < swing.period; time += 0.01)
    largest = std::max(largest, std::abs(swing.shear(time + dt) - swing.shear(time)));
  CHECK(largest <= swing.strain_per_step);
  CHECK(largest > 0.98 * swing.strain_per_step);
  CHECK(std::isinf(OscillatingShear{}.time_step()));  // no amplitude, no limit
}

}  // namespace scree::test::oscillating_shear_tests
