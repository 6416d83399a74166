// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"

#include <scree/laws/mu_of_i.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::volume_memory_tests {
namespace {

// Elastic moduli of the prototype: K = 83333 Pa.
MuOfI<> const plain{.elastic = {.young = 1e5, .poisson = 0.3, .rest_density = 1500}, .grains = {5e-4}};
using Remembering = VolumeMemory<MuOfI<>>;
static_assert(ConstitutiveLaw<Remembering>);
double const K = plain.bulk_modulus();
Mat<2, double> expansion(double rate) { return rate / 2 * Mat<2, double>::Identity(); }

}  // namespace

TEST_CASE("volume memory: the law alone recovers pressure after half of the way back") {
  // The negative control: the memory prevents this.
  Element<MuOfI<>> element{plain};
  element.shear_on(expansion(200), 2e-4, 20);
  CHECK(element.sigma.isZero(0));
  element.shear_on(expansion(-200), 1e-4, 10);
  CHECK(relative(element.p(), 1666.67) < 1e-5);
}

TEST_CASE("volume memory: what opened closes before pressure returns") {
  Element<Remembering> element{{plain}};
  element.shear_on(expansion(200), 2e-4, 20);
  CHECK(element.sigma.isZero(0));
  CHECK(relative(element.point.gap, 0.04) < 1e-12);
  element.shear_on(expansion(-200), 1e-4, 10);
  CHECK(element.sigma.isZero(0));
  CHECK(relative(element.point.gap, 0.02) < 1e-12);
  element.shear_on(expansion(-200), 0.99e-4, 99);
  CHECK(element.sigma.isZero(0));
  element.shear_on(expansion(-200), 0.02e-4, 2);
  CHECK(element.point.gap == 0);
  CHECK(relative(element.p(), K * 0.0002) < 1e-9);
}

TEST_CASE("volume memory: no more is remembered than a particle can lack that left its neighbours") {
  Element<Remembering> element{{plain}};
  element.shear_on(expansion(10), 1, 20);
  CHECK(element.point.gap == element.law.largest_opening);
  element.shear_on(expansion(-10), 0.9 * element.law.largest_opening / 10, 10);
  CHECK(element.sigma.isZero(0));
  element.shear_on(expansion(-10), 0.2 * element.law.largest_opening / 10, 100);
  CHECK(element.point.gap == 0);
  CHECK(element.p() > 0);
}

TEST_CASE("volume memory: a compressed element opens by what its pressure did not hold, in steps of any length") {
  double const p = 100, apart = 0.01;
  for (int const steps : {1, 3, 50}) {
    Element<Remembering> element{{plain}};
    element.set_pressure(p);
    // Shear is lost at the apex, the volume is not.
    element.shear_on(expansion(1) + simple_shear(3.0), apart, steps);
    CAPTURE(steps, element.point.gap);
    CHECK(element.sigma.isZero(0));
    CHECK(relative(element.point.gap, apart - p / K) < 1e-12);
    element.shear_on(expansion(-1) - simple_shear(3.0), apart, steps);
    CHECK(element.point.gap == 0);
    CHECK(relative(element.p(), p) < 1e-9);
  }
}

TEST_CASE("volume memory: while closed it is the law itself") {
  Element<Remembering> remembering{{plain}};
  Element<MuOfI<>> alone{plain};
  remembering.set_pressure(100);
  alone.set_pressure(100);
  remembering.shear_on(simple_shear(5.0) - expansion(1e-3), 0.01, 100);
  alone.shear_on(simple_shear(5.0) - expansion(1e-3), 0.01, 100);
  CHECK(remembering.sigma == alone.sigma);
  CHECK(remembering.point.gap == 0);
  CHECK(remembering.law.shear_strength(50.0, alone.point) == plain.shear_strength(50.0, alone.point));
}

TEST_CASE("volume memory: a pressure that is not a number bears nothing and shows in what is remembered") {
  Remembering const law{plain};
  Point<> memory;
  Mat<3, double> const bad = Mat<3, double>::Constant(std::numeric_limits<double>::quiet_NaN());
  CHECK(law.admissible(bad, Point<>{}, memory).isZero(0));
  CHECK(std::isnan(memory.gap));
}

TEST_CASE("volume memory: a law inside with a history writes it whether the point is open or not") {
  struct Counting : Elastic {
    using history = Fields<Concentration>;
    Mat<3, double> admissible(Mat<3, double> const& trial, Point<> const& point, Point<>& memory) const {
      memory.C = point.C + 1;
      return trial;
    }
  };
  VolumeMemory<Counting> const law{{soft()}};
  for (double const p : {-10.0, 10.0}) {
    Point<> memory;
    law.admissible(Mat<3, double>(-p * Mat<3, double>::Identity()), Point<>{0, 1, 0}, memory);
    CHECK(memory.C == 2);
  }
}

}  // namespace scree::test::volume_memory_tests
