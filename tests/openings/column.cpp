// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/openings/inlet.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>

namespace scree::test::column_tests {
namespace {
using Catch::Matchers::ContainsSubstring;
using X = Vec<2, double>;
constexpr double dr = 0.1;

std::vector<X> row(int count) {
  std::vector<X> points;
  for (int k = 0; k < count; ++k) points.push_back(X(-dr / 2, (k + 0.5) * dr));
  return points;
}
Inlet<2> shower(int points, double share) {
  Inlet<2> inlet{.layer = row(points), .velocity = X(0.7, 0), .pushes = false};
  inlet.rate = share * points * dr * 0.7;
  return inlet;
}
}  // namespace

TEST_CASE("the number of particles that enter is the rate times the time, to one particle, after 10000 layers") {
  for (double const share : {1.0, 0.5, 0.3, 1 / 7.0, 0.01}) {
    InletColumn<2> const column(shower(11, share), dr, 3 * dr);
    long layers = 0, particles = 0;
    double since = 0;
    // Steps that have no common measure with the time from layer to layer.
    for (long step = 0; layers < 10000; since = 0.0371234 * double(++step)) {
      for (; layers < column.layers_at(since); ++layers) particles += long(column.points(layers, since).size());
      double const exact = 11 * share * double(1 + long(since / column.period()));
      if (std::abs(double(particles) - exact) > 1) FAIL(share << ": " << particles << " instead of " << exact);
      if (particles != column.particles_in(layers)) FAIL("particles_in");
    }
    CHECK(std::abs(double(particles) - 11 * share * double(layers)) <= 1);
  }
}

TEST_CASE("a small rate uses all points of the layer alike") {
  InletColumn<2> const column(shower(10, 0.1), dr, 3 * dr);
  std::vector<int> counts(10, 0);
  for (long k = 0; k < 1000; ++k)
    for (X const& x : column.points(k, double(k) * column.period())) ++counts[std::size_t(std::floor(x[1] / dr))];
  CHECK(*std::min_element(counts.begin(), counts.end()) >= 99);
  CHECK(*std::max_element(counts.begin(), counts.end()) == 100);
}

TEST_CASE("a shower that ends has made the layers of its duration, however late one looks") {
  auto inlet = shower(11, 0.5);
  InletColumn<2> const endless(inlet, dr, 3 * dr);
  inlet.duration = 9.5 * endless.period();
  InletColumn<2> const column(inlet, dr, 3 * dr);
  CHECK(column.layers_at(9.4 * column.period()) == endless.layers_at(9.4 * column.period()));
  CHECK(column.layers_at(9.5 * column.period()) == 10);
  CHECK(column.layers_at(1000 * column.period()) == 10);
  CHECK(column.points(9, 12 * column.period()) == endless.points(9, 12 * column.period()));
}

TEST_CASE("a shower of a whole number of layers has made as many when it ends, and the volume of its rate") {
  for (double const share : {1.0, 0.5, 1.0 / 3, 0.1, 0.7})
    for (int const layers : {1, 2, 10, 30}) {
      auto inlet = shower(12, share);
      InletColumn<2> const endless(inlet, dr, 3 * dr);
      inlet.duration = layers * endless.period();
      InletColumn<2> const column(inlet, dr, 3 * dr);
      CAPTURE(share, layers);
      CHECK(column.layers_at(0) == 1);
      CHECK(column.layers_at(inlet.duration) == layers);
      CHECK(column.layers_at(2 * inlet.duration) == layers);
      CHECK(column.particles_in(layers) == std::lround(std::floor(12 * layers * share + 1e-6)));
    }
}

TEST_CASE("layers of a column are one spacing apart at any time") {
  InletColumn<2> const column({.layer = row(4), .velocity = X(0.7, 0)}, dr, 3 * dr);
  CHECK(column.layers_at(0) == 3);
  for (double const since : {0.0, 0.01, 12.345, 9999.9}) {
    long const last = column.layers_at(since) - 1;
    auto const behind = column.points(last, since), ahead = column.points(last - 1, since);
    CHECK(std::abs(ahead[0][0] - behind[0][0] - dr) < 1e-9);
    // The column begins up to one spacing ahead of its last layer, three spacings behind the plane.
    CHECK(behind[0][0] > -2.5 * dr - 1e-9);
    CHECK(behind[0][0] < -1.5 * dr + 1e-9);
    CHECK(std::abs(column.held_up_to(since) - (column.points(last - 2, since)[0][0] + dr / 2)) < 1e-9);
  }
}

TEST_CASE("inlets that cannot work are refused with the reason") {
  auto const make = [](auto const& change) {
    Inlet<2> inlet{.layer = row(4), .velocity = X(0.7, 0)};
    change(inlet);
    return InletColumn<2>(inlet, dr, 3 * dr);
  };
  CHECK_THROWS_WITH(make([](auto& inlet) { inlet.velocity = X(0, 0); }), ContainsSubstring("speed (m/s) of inlet"));
  CHECK_THROWS_WITH(make([](auto& inlet) { inlet.layer.clear(); }), ContainsSubstring("number of points"));
  CHECK_THROWS_WITH(make([](auto& inlet) { inlet.velocity = X(0.7, 0.7); }), ContainsSubstring("at most half a spac"));
  CHECK_THROWS_WITH(make([](auto& inlet) { inlet.rate = 0.01; }), ContainsSubstring("because the inlet pushes"));
  CHECK_THROWS_WITH(make([](auto& inlet) { inlet.duration = 1; }), ContainsSubstring("because the column"));
  CHECK_THROWS_WITH(make([](auto& inlet) { inlet.duration = 0; }), ContainsSubstring("above 0"));
  CHECK_THROWS_WITH(make([](auto& inlet) { inlet.pushes = false, inlet.rate = 1; }),
                    ContainsSubstring("at most that of full layers, 0.28"));
}

}  // namespace scree::test::column_tests
