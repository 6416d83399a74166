// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/hexagonal.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/setup/volume.hpp>
#include <scree/setup/walls.hpp>

#include "distances.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>
#include <numbers>
#include <string>
#include <type_traits>

namespace scree::test::fill_tests {

TEST_CASE("a disc and a sphere are filled with as many particles as fit their area and volume") {
  for (double const radius : {10.0, 20.3, 40.7, 80.0}) {  // in spacings
    double const area = std::numbers::pi * radius * radius;
    auto const disc = fill_lattice(Ball<2>{.centre = {0.3, 0.2}, .radius = radius}, 1);
    CAPTURE(radius, disc.size(), area);
    CHECK(std::abs(double(disc.size()) - area) < 4 * std::sqrt(radius));  // Gauss' circle: of the order of sqrt(radius)
    for (auto const& x : disc) REQUIRE((x - Vec<2, double>(0.3, 0.2)).norm() < radius);
  }
  double const volume = 4 * std::numbers::pi / 3 * 20 * 20 * 20;
  CHECK(std::abs(double(fill_lattice(Ball<3>{.centre = {0, 0, 0}, .radius = 20}, 1).size()) / volume - 1) < 0.005);
}

TEST_CASE("more particles than can be counted are refused before they are made") {
  using Catch::Matchers::ContainsSubstring;
  auto const too_many = ContainsSubstring(" particles are more than the 2147483647 that can be counted");
  Box<2> const box{{0, 0}, {100, 0.001}};
  Ball<2> const disc{.centre = {0, 0}, .radius = 0.035};
  Cylinder const tube{.axis = 1, .centre = {0, 0, 0}, .radius = 0.035, .from = 0, .to = 1};
  CHECK_THROWS_WITH(fill_lattice(box, 1e-7), ContainsSubstring("scree: 1e+13") && too_many);
  CHECK_THROWS_WITH(fill_lattice(disc, 1e-9), too_many);
  CHECK_THROWS_WITH(fill_between(box, Box<2>{{-1, -1}, {101, 1}}, 1e-6), too_many);
  CHECK_THROWS_WITH(fill_hexagonal(box, 1e-7), too_many);
  CHECK_THROWS_WITH(fill_rings(disc, 1e-7), too_many);
  CHECK_THROWS_WITH(fill_rings(tube, 1e-5), too_many);
  CHECK_THROWS_WITH(wall_around(disc, 1e-7, 3), too_many);
  CHECK_THROWS_WITH(wall_rings(disc, 1e-10, 3), too_many);
  CHECK_THROWS_WITH(wall_rings(tube, 1e-5, 3), too_many);
  CHECK_THROWS_WITH(fill_lattice(box, 1e-300), ContainsSubstring("spacings of particles"));
  CHECK_THROWS_WITH(fill_hexagonal(box, 1e-300), ContainsSubstring("spacings of particles"));
}

TEST_CASE("a cylinder along no axis is refused") {
  for (int const axis : {-1, 3, 7}) {
    Cylinder const tube{.axis = axis, .centre = {0, 0, 0}, .radius = 1, .from = 0, .to = 1};
    auto const why = "set-up: the axis of a cylinder is 0, 1 or 2, not " + std::to_string(axis);
    CHECK_THROWS_WITH(fill_lattice(tube, 0.1), why);
    CHECK_THROWS_WITH(fill_rings(tube, 0.1), why);
    CHECK_THROWS_WITH(tube.signed_distance({0, 0, 0}), why);
  }
}

TEST_CASE("the bed of a drum is filled up to its surface") {
  Ball<2> const drum{.centre = {0, 0}, .radius = 1};
  HalfSpace<2> const below{.point = {0, -0.2}, .normal = {0, 1}};
  auto const bed = fill_lattice(drum & below, 0.02);
  double const angle = std::acos(0.2), segment = angle - 0.2 * std::sin(angle);
  CHECK(std::abs(double(bed.size()) * 0.02 * 0.02 / segment - 1) < 0.01);
  for (auto const& x : bed) CHECK((x.norm() < 1 && x[1] < -0.2));
}

TEST_CASE("shapes filled from one anchor continue each other's lattice") {
  Box<2> const whole{{-1, -1}, {1, 1}};
  HalfSpace<2> const below{.point = {0.1, 0}, .normal = {0.5, 1}};
  Vec<2, double> const anchor(-1, -1);
  auto const lower = fill_lattice(whole & below, 0.1, anchor),
             upper = fill_lattice(whole & complement(below), 0.1, anchor);
  CHECK(lower.size() > 150);
  CHECK(upper.size() > 150);
  CHECK(same_points(joined(lower, upper), fill_lattice(whole, 0.1), 1e-12));
  // A box may be anywhere on the lattice of another one.
  for (auto const& x : fill_lattice(Box<2>{{-0.32, 0.1}, {0.48, 0.33}}, 0.1, anchor)) {
    CHECK(number_within(fill_lattice(whole, 0.1), x, 1e-12) == 1);
    CHECK((x[0] > -0.32 && x[0] < 0.48 && x[1] > 0.1 && x[1] < 0.33));
  }
  CHECK(fill_lattice(Box<2>{{-0.32, 0.1}, {0.48, 0.33}}, 0.1, anchor).size() == 8 * 2);
}

TEST_CASE("rounding does not decide about particles on a boundary") {
  // The plane goes through the centres of a diagonal of cubes, which belong to neither side.
  for (double const shift : {0.0, 0.1, 1.0 / 3, -7.7, 1000.0 / 7}) {
    Vec<2, double> const low(shift, 1 - 2 * shift);
    Box<2> const box{low, low + Vec<2, double>::Constant(2)};
    HalfSpace<2> const below{.point = low, .normal = {-1, 1}};
    CHECK(fill_lattice(box & below, 0.1).size() == 190);
    CHECK(fill_lattice(box & complement(below), 0.1).size() == 190);
  }
}

TEST_CASE("points may be chosen by a shape") {
  auto const points = fill_lattice(Box<2>{{-1, -1}, {1, 1}}, 0.1);
  Ball<2> const disc{.centre = {0, 0}, .radius = 0.5};
  auto const within = points_within(points, disc), outside = points_within(points, complement(disc));
  CHECK(within.size() + outside.size() == points.size());
  CHECK(within.size() == 80);
  for (auto const& x : within) CHECK(x.norm() < 0.5);
}

TEST_CASE("what cannot be filled is said") {
  using Catch::Matchers::ContainsSubstring;
  Box<2> const box{{-1, 2}, {-0.4, 2.3}};
  CHECK_THROWS_WITH(fill_lattice(HalfSpace<2>{.point = {0, 0}, .normal = {0, 1}}, 0.1),
                    ContainsSubstring("finite bounds"));
  CHECK_THROWS_WITH(fill_lattice(complement(box), 0.1), ContainsSubstring("finite bounds"));
  CHECK_THROWS_AS(fill_lattice(box, 0), std::invalid_argument);
  CHECK_THROWS_WITH(fill_lattice(box, -0.1), ContainsSubstring("-0.1"));
  CHECK(fill_lattice(box & Ball<2>{.centre = {9, 9}, .radius = 1}, 0.1).empty());
}

TEST_CASE("a parameter of a shape that is out of its range is refused by all that uses the shape, also as a part") {
  using Catch::Matchers::ContainsSubstring;
  auto const refused = [](auto const& shape, std::string const& why) {
    using S = std::remove_cvref_t<decltype(shape)>;
    Vec<S::dim, double> const zero = Vec<S::dim, double>::Zero(), one = Vec<S::dim, double>::Ones();
    Box<S::dim> const room{-9 * one, 9 * one};
    auto const message = ContainsSubstring(why);
    std::vector<Vec<S::dim, double>> const points{zero};
    CHECK_THROWS_WITH(fill_lattice(shape & room, 0.5), message);
    CHECK_THROWS_WITH(fill_lattice(room - shape, 0.5, zero), message);
    CHECK_THROWS_WITH(fill_lattice(shape & room, 0.5, ShareOfRank{0, 1}), message);
    CHECK_THROWS_WITH(fill_hexagonal(offset(shape, 0.1) & room, 0.5), message);
    CHECK_THROWS_WITH(wall_around(shape | room, 0.5, 3), message);
    CHECK_THROWS_WITH(volume_of(shape & room, 0.5), message);
    CHECK_THROWS_WITH(points_within(points, complement(shape)), message);
    if constexpr (requires { S::name; }) {
      CHECK_THROWS_WITH(fill_lattice(shape, 0.5), message);
      CHECK_THROWS_WITH(fill_hexagonal(shape, 0.5), message);
      CHECK_THROWS_WITH(wall_around(shape, 0.5, 3), message);
      CHECK_THROWS_WITH(volume_of(shape, 0.5), message);
    }
  };
  double const nan = std::numeric_limits<double>::quiet_NaN();
  refused(Box<2>{{0, 1}, {2, -1}}, "set-up: high[1] (m) of a Box must be 1 or more, as low[1] is, not -1");
  refused(Box<3>{{0, 0, nan}, {2, 1, 1}}, "high[2] (m) of a Box");
  refused(Ball<2>{.centre = {0, 0}, .radius = -1}, "set-up: the radius (m) of a Ball must be above 0, not -1");
  refused(Ball<3>{.centre = {0, 0, 0}}, "the radius (m) of a Ball must be above 0, not 0");
  refused(Ball<3>{.centre = {0, nan, 0}, .radius = 1}, "the centre (m) of a Ball must be finite, not nan");
  refused(Cylinder{.axis = 2, .centre = {0, 0, 0}, .radius = 1, .from = 2, .to = 1},
          "set-up: the second end (m) of a Cylinder, `to`, must be above the first one, `from`, not 1");
  refused(Cylinder{.axis = 2, .centre = {0, 0, 0}, .radius = -1, .from = 0, .to = 1}, "the radius (m) of a Cylinder");
  refused(HalfSpace<2>{.point = {0, 0}, .normal = {0, 0}},
          "set-up: the length of the normal of a HalfSpace must be above 0, not 0");
  refused(offset(Box<2>{{0, 0}, {1, 2}}, -0.6), "the distance (m) of an Offset must be at least -0.5");
  refused(section(Ball<3>{.centre = {0, 0, 0}, .radius = -2}, 0), "the radius (m) of a Ball");
  CHECK_THROWS_WITH(wall_rings(Ball<2>{.centre = {0, 0}, .radius = -1}, 0.1, 3), ContainsSubstring("radius (m)"));
  CHECK_THROWS_WITH(fill_rings(Ball<2>{.centre = {0, 0}, .radius = -1}, 0.1), ContainsSubstring("radius (m)"));
  CHECK_THROWS_WITH(fill_between(Box<2>{{0, 0}, {1, 1}}, Box<2>{{2, 2}, {-1, 3}}, 0.1), ContainsSubstring("high[0]"));
}

TEST_CASE("a box, a ball or a cylinder that has no room for a particle is refused") {
  using Catch::Matchers::ContainsSubstring;
  auto const no_room = ContainsSubstring("has no room for a particle: the spacing must be below its size, not 1 m");
  CHECK_THROWS_WITH(fill_lattice(Box<2>{{0, 0}, {0.4, 5}}, 1), ContainsSubstring("a Box of 0.4 x 5 m") && no_room);
  CHECK_THROWS_WITH(fill_lattice(Box<2>{{0, 0}, {0.4, 5}}, 1, ShareOfRank{0, 2}), no_room);
  CHECK_THROWS_WITH(fill_hexagonal(Ball<2>{.centre = {0, 0}, .radius = 0.1}, 1), no_room);
  CHECK_THROWS_WITH(fill_rings(Ball<2>{.centre = {0, 0}, .radius = 0.1}, 1), no_room);
  CHECK_THROWS_WITH(fill_rings(Cylinder{.axis = 1, .centre = {0, 0, 0}, .radius = 5, .from = 0, .to = 0.3}, 1),
                    no_room);
  CHECK(fill_lattice(Box<2>{{0, 0}, {0.6, 5}}, 1).size() == 5);
}

}  // namespace scree::test::fill_tests
