// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "bed.hpp"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <limits>

namespace scree::test::doucet_tests {
using namespace fields;
using namespace mixing;
namespace {
bool near(double a, double b, double by) { return std::abs(a - b) <= by; }
template <int Dim, class Real = double>
auto marked_bed(int rows) {
  auto bed = unit_bed<Dim, Real, Fields<StartPosition>>(rows);
  mark_start(bed);
  return bed;
}
}  // namespace

TEMPLATE_TEST_CASE("particles that did not mix have the index 1, wherever they are", "", float, double) {
  using X = Vec<2, TestType>;
  double const by = std::is_same_v<TestType, double> ? 1e-12 : 1e-6;
  auto bed = marked_bed<2, TestType>(12);
  CHECK(near(doucet_index(bed).index, 1, by));
  bed.set(position, [](auto const& x) { return X(5 - x[0], x[1] / 3); });  // a mirror, farther on and lower
  CHECK(near(doucet_index(bed).index, 1, by));
  CHECK(near(doucet_index(bed).correlations(0, 0), -1, by));
  bed.set(position, [](auto const& x) { return X(x[1], -x[0]); });  // a rotation of a layer by a right angle
  CHECK(near(doucet_index(bed).index, 1, by));
  CHECK(near(doucet_index(bed).published, 1, by));
  CHECK(near(doucet_index(bed).correlations(0, 0), 0, by));
}

TEST_CASE("a bed that turns or is sheared has the index 1, and not the published one") {
  auto bed = marked_bed<2>(20);
  bed.set(position, [](auto const& x) { return Vec<2, double>(4 * x[0], x[1]); });
  mark_start(bed);
  double const c = std::cos(0.5), s = std::sin(0.5);
  bed.set(position, [&](auto const& x) { return Vec<2, double>(c * x[0] - s * x[1], s * x[0] + c * x[1]); });
  // Rows of C are of unit length; their product is s c (16 - 1)/((16 c^2 + s^2)(16 s^2 + c^2))^(1/2).
  double const product = s * c * 15 / std::sqrt((16 * c * c + s * s) * (16 * s * s + c * c));
  CHECK(near(doucet_index(bed).published, 1 + product, 1e-12));
  CHECK(near(doucet_index(bed).index, 1, 1e-12));
  bed.set(position, [](auto const& x) { return Vec<2, double>(x[0] + 3 * x[1], x[1]); });
  CHECK(near(doucet_index(bed).index, 1, 1e-12));
}

TEST_CASE("a bed that is no rectangle has the index 1 at the start") {
  auto bed = marked_bed<3>(8);
  bed.set(position, [](auto const& x) { return Vec<3, double>(x[0] + 0.5 * x[1], x[1] - 0.2 * x[2], x[2]); });
  mark_start(bed);
  auto const found = doucet_index(bed);
  CHECK(found.correlations(0, 1) > 0.4);  // coordinates depend on each other
  CHECK(near(found.published, 1, 1e-12));
  CHECK(near(found.index, 1, 1e-12));
}

TEST_CASE("halves that change places along all axes have a quarter") {
  // Uniform on [0, 1], shifted by a half and wrapped: the correlation is -1/2, on n points -1/2 (1 + 2/n^2)/(1 -
  // 1/n^2).
  int const n = 16;
  double const expected = -0.5 * (1 + 2.0 / sq(n)) / (1 - 1.0 / sq(n));
  auto const swapped = [](double x) { return x < 0.5 ? x + 0.5 : x - 0.5; };
  auto bed = marked_bed<3>(n);
  bed.set(position, [&](auto const& x) { return Vec<3, double>(swapped(x[0]), swapped(x[1]), x[2]); });
  auto one = doucet_index(bed);
  CHECK(near(one.index, 1, 1e-12));  // nothing has mixed along z
  CHECK(near(std::abs(one.direction[2]), 1, 1e-12));
  CHECK(near(one.correlations(0, 0), expected, 1e-12));
  bed.set(position, [&](auto const& x) { return Vec<3, double>(x[0], x[1], swapped(x[2])); });
  CHECK(near(doucet_index(bed).index, sq(expected), 1e-12));
}

TEST_CASE("particles at random places have forgotten where they were") {
  auto bed = marked_bed<2>(40);
  std::uint64_t k = 0;
  bed.set(position, [&](auto const&) {
    k += 2;
    return Vec<2, double>(chance(k), chance(k + 1));
  });
  // Correlations of N pairs scatter by N^-1/2; the largest eigenvalue of four of them by a few 1/N.
  CHECK(doucet_index(bed).index < 10.0 / 1600);
  CHECK(doucet_index(bed).index > 0);
}

TEST_CASE("the index of Doucet weights by volume, and takes a row that lies in a line") {
  auto bed = marked_bed<2>(10);
  bed.set(position, [](auto const& x) { return Vec<2, double>(x[0] < 0.5 ? x[0] : 1.5 - x[0], 0.3); });
  bed.set(volume, [](auto const& x) { return x[0] < 0.5 ? 0.01 : 1e-13; });
  auto const found = doucet_index(bed);
  CHECK(near(found.correlations(0, 0), 1, 1e-9));  // those of the mirrored half weigh nothing
  CHECK(found.correlations(1, 1) == 0);
  CHECK(near(found.index, 1, 1e-9));
}

TEST_CASE("a bed that was poured after the start has the index of its particles at the mark, one at the origin too") {
  using X = Vec<2, double>;
  double const dr = 0.1;
  auto const points_of = [&](double from, int columns) {
    std::vector<X> points;
    for (int a = 0; a < columns; ++a)
      for (int b = 0; b < 10; ++b) points.push_back({from + a * dr, b * dr});
    return points;
  };
  using S = Solver<MixedBed<2, double, Fields<StartPosition>>>;
  auto const swapped = [](X const& x) {
    return X(x[0] < 0.45 ? x[0] + 0.5 : x[0] < 0.95 ? x[0] - 0.5 : x[0], x[1] < 0.45 ? x[1] + 0.5 : x[1] - 0.5);
  };
  S whole({.spacing = dr, .physics = {}, .start_checks = false}, points_of(0, 10));
  CHECK_THROWS_WITH(doucet_index(whole), Catch::Matchers::ContainsSubstring("mark_start(solver)"));
  S poured({.spacing = dr, .physics = {}, .start_checks = false}, points_of(0, 4));
  poured.add(points_of(4 * dr, 6));
  mark_start(whole), mark_start(poured);
  CHECK(near(doucet_index(poured).index, 1, 1e-12));
  CHECK(doucet_index(poured).share == 1);
  whole.set(position, swapped), poured.set(position, swapped);
  auto const expected = doucet_index(whole);
  CHECK(expected.index < 0.3);
  CHECK(near(doucet_index(poured).index, expected.index, 1e-12));
  CHECK(near(doucet_index(poured).correlations(0, 0), expected.correlations(0, 0), 1e-12));

  poured.add(points_of(1, 10));  // after the mark: they do not count
  CHECK(near(doucet_index(poured).index, expected.index, 1e-12));
  CHECK(near(doucet_index(poured).share, 0.5, 1e-12));
  poured.remove(Within<2>{{-1, -1}, {0.95, 2}}, Fields<Volume>{});
  CHECK(std::isnan(doucet_index(poured).index));  // those that count have left
  CHECK(doucet_index(poured).share == 0);
  mark_start(poured);
  CHECK(near(doucet_index(poured).index, 1, 1e-12));
}

TEST_CASE("a place that is not finite is refused by the index of Doucet") {
  auto bed = marked_bed<2>(4);
  bed.set(start_position, [](auto const& x) {
    return Vec<2, double>(x[0] < 0.25 && x[1] < 0.25 ? std::numeric_limits<double>::quiet_NaN() : x[0], x[1]);
  });
  CHECK_THROWS_AS(doucet_index(bed), std::runtime_error);
}

}  // namespace scree::test::doucet_tests
