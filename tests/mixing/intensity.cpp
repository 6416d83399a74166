// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "bed.hpp"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

namespace scree::test::intensity_tests {
using namespace fields;
using namespace mixing;
namespace {
bool near(double a, double b, double by) { return std::abs(a - b) <= by; }
struct Everyone {
  using reads = Fields<>;
  template <class I>
  SCREE_FN bool operator()(I const&) const {
    return true;
  }
};
}  // namespace

TEMPLATE_TEST_CASE("kinds that are apart have the intensity 1, mixed ones 0", "", float, double) {
  auto bed = unit_bed<2, TestType>(10);
  for (double const share : {0.5, 0.1, 0.8}) {
    bed.set(concentration, [&](auto const& x) { return TestType(double(x[1]) < share ? 1 : 0); });
    auto const apart = segregation_intensity(bed);
    CHECK(near(apart.value, 1, 1e-12));
    CHECK(near(apart.mean[0], share, 1e-6));
    CHECK(near(apart.mean[0] + apart.mean[1], 1, 1e-12));
    CHECK(near(apart.volume, 1, 1e-6));
    bed.set(concentration, [&](auto const&) { return TestType(share); });
    CHECK(segregation_intensity(bed).value < 1e-24);
  }
}

TEST_CASE("a linear profile has the intensity 1/3 less that of a row") {
  // C = z/H: mean 1/2, variance 1/12 (1 - 1/n^2) for the middles of n rows, over 1/4.
  for (int const rows : {5, 10, 20}) {
    auto plane = unit_bed<2>(rows);
    plane.set(concentration, [](auto const& x) { return x[1]; });
    CHECK(near(segregation_intensity(plane).value, (1 - 1.0 / sq(rows)) / 3, 1e-12));
    CHECK(near(segregation_intensity(plane).mean[0], 0.5, 1e-12));
  }
  auto space = unit_bed<3>(8);
  space.set(concentration, [](auto const& x) { return x[2]; });
  CHECK(near(segregation_intensity(space).value, (1 - 1.0 / 64) / 3, 1e-12));
}

TEST_CASE("the intensity weights by volume") {
  auto bed = unit_bed<2>(10);
  bed.set(volume, [](auto const& x) { return x[1] < 0.5 ? 0.03 : 0.01; });
  bed.set(concentration, [](auto const& x) { return x[1] < 0.5 ? 0.6 : 0.2; });
  auto const found = segregation_intensity(bed);
  CHECK(near(found.mean[0], 0.5, 1e-12));  // 3/4 of the volume
  CHECK(near(found.variance[0], 0.75 * 0.01 + 0.25 * 0.09, 1e-12));
  CHECK(near(found.variance[1], found.variance[0], 1e-12));
  CHECK(near(found.value, 4 * found.variance[0], 1e-12));
  CHECK(near(found.volume, 2, 1e-12));
}

TEST_CASE("N species have the intensity of two where two of them are alike") {
  auto two = unit_bed<2>(10);
  two.set(concentration, [](auto const& x) { return 0.2 + 0.5 * x[0] * x[1]; });
  auto pair = unit_bed<2, double, Fields<Concentrations<2>>>(10);
  pair.set(concentrations<2>, [](auto const& x) {
    double const C = 0.2 + 0.5 * x[0] * x[1];
    return Vec<2, double>(C, 1 - C);
  });
  CHECK(segregation_intensity(pair).value == segregation_intensity(two).value);

  auto three = unit_bed<3, float, Fields<Concentrations<3>>>(9);
  three.set(concentrations<3>, [](auto const& x) {
    return x[2] < 1.0f / 3 ? Vec<3, float>(1, 0, 0) : x[2] < 2.0f / 3 ? Vec<3, float>(0, 1, 0) : Vec<3, float>(0, 0, 1);
  });
  CHECK(near(segregation_intensity(three).value, 1, 1e-12));
  three.set(concentrations<3>, [](auto const&) { return Vec<3, float>(0.25f, 0.25f, 0.5f); });
  CHECK(segregation_intensity(three).value < 1e-12);
  CHECK(near(segregation_intensity(three).mean[2], 0.5, 1e-7));
}

TEST_CASE("marked particles mix without a concentration") {
  auto bed = unit_bed<2, double, Fields<Group>>(10);
  bed.set(group, [](auto const& x) { return x[0] < 0.3 ? 2 : 0; });
  auto const found = segregation_intensity(bed, MarkedGroup{2});
  CHECK(near(found.mean[0], 0.3, 1e-12));
  CHECK(near(found.value, 1, 1e-12));
}

TEST_CASE("one kind alone has no intensity, and values that are not finite are refused") {
  auto bed = unit_bed<2>(10);
  CHECK(std::isnan(segregation_intensity(bed).value));
  bed.set(concentration, [](auto const&) { return 1.0; });
  CHECK(std::isnan(segregation_intensity(bed).value));
  for (double const bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    bed.set(concentration, [&](auto const& x) { return x[0] < 0.1 && x[1] < 0.1 ? bad : 0.5; });
    CHECK_THROWS_AS(segregation_intensity(bed), std::runtime_error);
  }
}

TEST_CASE("a material that has left has no measures of mixing") {
  auto bed = unit_bed<2, double, Fields<Concentration, StartPosition>>(4);
  bed.set(concentration, [](auto const& x) { return x[0]; });
  mark_start(bed);
  CHECK(segregation_intensity(bed).value > 0);
  bed.remove(Everyone{}, Fields<Volume>{});
  CHECK(std::isnan(segregation_intensity(bed).value));
  CHECK(segregation_intensity(bed).volume == 0);
  CHECK(std::isnan(lacey_index(bed).index));
  CHECK(lacey_index(bed).samples == 0);
  CHECK(std::isnan(doucet_index(bed).index));
}

}  // namespace scree::test::intensity_tests
