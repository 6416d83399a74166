// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/shapes/polygon.hpp>

#include "samples.hpp"

#include <scree/setup/mesh/read_polygon.hpp>

#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>

namespace scree::test::polygon_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
using X = Vec<2, double>;
Polygon::Loop const hook{{-0.8, -0.5}, {0.7, -0.5}, {0.7, 0.9}, {0.2, 0.9}, {0.2, 0.1}, {-0.8, 0.1}};
bool in_hook(X const& x) {
  return x[0] > -0.8 && x[0] < 0.7 && x[1] > -0.5 && x[1] < 0.9 && (x[0] > 0.2 || x[1] < 0.1);
}

}  // namespace

static_assert(Shape<Polygon>);

TEST_CASE("signed distances of a polygon are exact, in either direction of its corners") {
  auto backwards = hook;
  std::reverse(backwards.begin(), backwards.end());
  check_distances(Polygon(hook), in_hook, Exact::everywhere);
  check_distances(Polygon(backwards), in_hook, Exact::everywhere);
  CHECK(Polygon(hook).bounds().low == X(-0.8, -0.5));
  CHECK(Polygon(hook).bounds().high == X(0.7, 0.9));
}

TEST_CASE("a polygon within another one is a hole") {
  Polygon::Loop const outer{{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}};
  Polygon const ring({outer, {{-0.3, -0.3}, {-0.3, 0.3}, {0.3, 0.3}, {0.3, -0.3}}});
  auto const inside = [](X const& x) { return x.cwiseAbs().maxCoeff() < 0.9 && x.cwiseAbs().maxCoeff() > 0.3; };
  check_distances(ring, inside, Exact::everywhere);
  CHECK(std::abs(*ring.exact_volume_below(9) - (1.8 * 1.8 - 0.36)) < 1e-15);
  CHECK(std::abs(*ring.exact_volume_below(0.1) - (1.8 - 0.6 * 0.4)) < 1e-15);
}

TEST_CASE("the area of a polygon below a level is that of its parts") {
  Polygon const polygon(hook), triangle(Polygon::Loop{{0, 5}, {2, 6}, {1, 7}});
  CHECK(*polygon.exact_volume_below(-1) == 0);
  CHECK(std::abs(*polygon.exact_volume_below(0) - 0.75) < 1e-15);
  CHECK(std::abs(*polygon.exact_volume_below(0.5) - (0.9 + 0.2)) < 1e-15);
  CHECK(std::abs(*polygon.exact_volume_below(2) - 1.3) < 1e-15);
  CHECK(std::abs(*triangle.exact_volume_below(9) - 1.5) < 1e-14);
  CHECK(std::abs(*triangle.exact_volume_below(6) - 0.75) < 1e-14);  // the level cuts it from (1/2, 6) to (2, 6)
}

TEST_CASE("polygons are read from the lines or the faces of an OBJ file") {
  std::string const points = "v 0 0 3\nv 2 0 3\nv 2 1 3\nv 0 1 3\n";
  for (char const* lines : {"l 1 2 3 4 1\n", "l 1 2\nl 3 2\nl 3 4 1\n", "f 1 2 3 4\n", "f 4 3 2 1\n"}) {
    CAPTURE(lines);
    Polygon const read = polygon_from_obj(points + lines, "a.obj", {.scale = 0.5, .angle = 0.5, .translation = {1, 2}});
    CHECK(std::abs(*read.exact_volume_below(9) - 0.5) < 1e-15);
    CHECK(read.contains(X(1 + 0.9 * std::cos(0.5), 2 + 0.91 * std::sin(0.5))));
  }
  Polygon const upright = polygon_from_obj("v 0 3 0\nv 2 3 0\nv 2 3 1\nl 1 2 3 1", "a.obj");
  CHECK(upright.bounds().high == X(2, 1));
}

TEST_CASE("what is no polygon is refused") {
  CHECK_THROWS_WITH(Polygon(Polygon::Loop{{0, 0}, {1, 0}}), ContainsSubstring("three corners or more, not 2"));
  CHECK_THROWS_WITH(Polygon(Polygon::Loop{{0, 0}, {1, 0}, {2, 0}}), ContainsSubstring("no area"));
  CHECK_THROWS_WITH(Polygon(Polygon::Loop{{0, 0}, {1, 0}, {1, 0}, {2, 1}}), ContainsSubstring("corner 2 is repeated"));
  CHECK_THROWS_WITH(Polygon(Polygon::Loop{{0, 0}, {1, std::nan("")}, {2, 1}}),
                    ContainsSubstring("corner 2 is not finite"));
  CHECK_THROWS_WITH(Polygon(Polygon::Loop{{0, 0}, {2, 2}, {2, 0}, {0, 1}}),
                    ContainsSubstring("from (0, 0) to (2, 2) and from (2, 0) to (0, 1) cross"));
  std::string const points = "v 0 0 3\nv 2 0 3\nv 2 1 3\nv 0 1 4\n";
  CHECK_THROWS_WITH(polygon_from_obj(points + "l 1 2 3", "a.obj"),
                    "a.obj, line 5: vertex 1 is the end of 1 pieces of lines; closed polygons have two");
  CHECK_THROWS_WITH(polygon_from_obj(points + "l 1 2 3 4 1", "a.obj"), ContainsSubstring("one y or one z"));
  CHECK_THROWS_WITH(polygon_from_obj(points + "l 1 2 3 5 1", "a.obj"), ContainsSubstring("line 5: '5' is none"));
  CHECK_THROWS_WITH(polygon_from_obj(points, "a.obj"), "a.obj: set-up: a polygon: there is none");
}

}  // namespace scree::test::polygon_tests
