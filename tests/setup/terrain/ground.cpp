// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/lattice.hpp>
#include <scree/setup/measured_fill.hpp>
#include <scree/setup/terrain.hpp>
#include <scree/setup/walls.hpp>

#include "../mesh/bodies.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <numbers>

// The ground from a raster, and material on it.
namespace scree::test::ground_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
static_assert(Shape<HeightField> && Shape<Release>);

template <class Height>
Raster sampled(int columns, int rows, double spacing, Height const& height) {
  Raster raster{"made.asc", columns, rows, -1, -2, spacing};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) raster.values.push_back(height(raster.x_of(i), raster.y_of(j)));
  return raster;
}
double hills(double x, double y) { return 0.4 * std::sin(2 * x) * std::cos(1.3 * y) + 0.2 * x; }
Raster const ground = sampled(23, 31, 0.13, hills);

/// All triangles of the surface.
Triangles triangles_of(Raster const& raster) {
  Triangles mesh;
  detail::HeightGrid const grid(raster);
  for (int j = -1; j < raster.rows; ++j)
    for (int i = -1; i < raster.columns; ++i)
      for (auto const& abc : grid.triangles(i, j)) {
        int const first = int(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), abc.begin(), abc.end());
        mesh.corners.push_back({first, first + 1, first + 2});
      }
  return mesh;
}

}  // namespace

TEST_CASE("distances from the ground are those from all of its triangles, within the raster and beyond") {
  HeightField const field(ground);
  Triangles const all = triangles_of(ground);
  for (X3 const& x : random_points(200, 4)) {
    double const d = field.signed_distance(x);
    CHECK(std::abs(std::abs(d) - distance_from_all(all, x)) < 1e-12);
    CHECK((d < 0) == (x[2] < field.height(x[0], x[1])));
    CHECK(field.contains(x) == (d < 0));
  }
}

TEST_CASE("the surface is on its triangles and close to bilinear interpolation") {
  HeightField const field(ground);
  Triangles const all = triangles_of(ground);
  double twist = 0;
  for (int j = 0; j + 1 < ground.rows; ++j)
    for (int i = 0; i + 1 < ground.columns; ++i)
      twist = std::max(twist,
                       std::abs(ground.at(i, j) - ground.at(i + 1, j) - ground.at(i, j + 1) + ground.at(i + 1, j + 1)));
  for (X3 const& x : random_points(100, 4))
    CHECK(distance_from_all(all, X3(x[0], x[1], field.height(x[0], x[1]))) < 1e-14);
  for (X3 const& x : random_points(2000, 1)) {
    CHECK(std::abs(field.height(x[0], x[1]) - ground(x[0], x[1])) <= twist / 16 * (1 + 1e-9));
    if (x[0] > -1) CHECK(std::abs(field.height(x[0] - 5, -7) - ground.at(0, 0)) < 1e-15);
  }
}

TEST_CASE("a plane is exact") {
  HeightField const field(sampled(5, 4, 0.5, [](double x, double y) { return 0.5 * x - 0.25 * y + 3; }));
  X3 const normal = X3(-0.5, 0.25, 1).normalized();
  for (X3 const& x : {X3(0, -1.3, 3.1), X3(-0.4, -1.1, 3.3), X3(0.3, -1.2, 3.6)})
    CHECK(std::abs(field.signed_distance(x) - normal.dot(X3(x - X3(0, 0, 3)))) < 1e-14);
}

TEST_CASE("walls below the ground fill what lies within their rows") {
  HeightField const field(ground);
  double const dr = 0.06;
  Box<3> const within{{-0.5, -1.5, -2}, {1.2, 1, 2}};
  auto const wall = wall_around(complement(field), dr, 3, within);
  std::size_t expected = 0;
  for (X3 const& x : fill_lattice(within & whole_space<3>(), dr)) {
    double const d = field.signed_distance(x);
    expected += d <= 1e-9 * dr && -d <= 3 * dr;
  }
  CHECK(wall.size() == expected);
  CHECK(wall.size() > 1000);
}

TEST_CASE("a release is between the ground and its depth above it, with its volume") {
  auto const cap = [](double x, double y) { return std::max(0.0, 0.3 - sq(x - 0.4) - sq(y)); };
  Raster depth = sampled(23, 31, 0.13, cap);
  for (double& d : depth.values)
    if (d == 0) d = std::nan("");
  depth.name = "depth.asc";
  HeightField const field(ground);
  Release const release(field, depth);
  double volume = 0;  // cells times the mean of their corners
  auto const at = [&](int i, int j) { return std::isfinite(depth.at(i, j)) ? depth.at(i, j) : 0; };
  for (int j = 0; j + 1 < depth.rows; ++j)
    for (int i = 0; i + 1 < depth.columns; ++i)
      volume += sq(0.13) * (at(i, j) + at(i + 1, j) + at(i, j + 1) + at(i + 1, j + 1)) / 4;
  CHECK(std::abs(*release.exact_volume_below(9) / volume - 1) < 1e-13);
  CHECK(std::abs(volume / (std::numbers::pi * sq(0.3) / 2) - 1) < 0.02);
  double const dr = 0.03;
  auto const bed = fill_measured(release, dr, X3(0.01, 0.02, 0.03));
  double total = 0;
  for (double const v : bed.volumes) total += v;
  CHECK(std::abs(total / volume - 1) < 1e-12);
  for (X3 const& x : bed.points) {
    CHECK(x[2] > field.height(x[0], x[1]));
    CHECK(x[2] < field.height(x[0], x[1]) + 0.3);
    X3 const steps = (x - X3(0.025, 0.035, 0.045)) / dr;
    CHECK((steps - X3(steps.array().round())).norm() < 1e-9);
  }
  double const level = 0.2;  // the volume below it, from a fine lattice
  std::size_t below = 0;
  for (X3 const& x : fill_lattice(release, 0.006)) below += x[2] < level;
  CHECK(std::abs(double(below) * math::power<3>(0.006) / *release.exact_volume_below(level) - 1) < 0.02);
}

TEST_CASE("a release that is none, is negative or reaches the edge is refused") {
  HeightField const field(ground);
  CHECK_THROWS_WITH(Release(field, sampled(23, 31, 0.13, [](double, double) { return 0.0; })),
                    ContainsSubstring("no depth above zero"));
  CHECK_THROWS_WITH(Release(field, sampled(23, 31, 0.13, [](double, double) { return 1.0; })),
                    "made.asc: the release reaches the edge of the ground at x = -1, y = -2 m");
  CHECK_THROWS_WITH(Release(field, sampled(23, 31, 0.13, [](double x, double) { return x - 0.5; })),
                    ContainsSubstring("is -1.5 m at x = -1, y = -2 m"));
}

TEST_CASE("a release has the volume of its raster to a hundredth, or is refused with both volumes") {
  HeightField const flat(Raster{"ground.asc", 21, 21, 0, 0, 10, std::vector<double>(441, 0.0)});
  auto const depth = [](double x, double y, double spacing, int n, auto const& value) {
    Raster raster{"depth.asc", n, n, x, y, spacing};
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) raster.values.push_back(value(raster.x_of(i), raster.y_of(j)));
    return raster;
  };
  double const none = std::nan("");
  auto const block = [&](double x, double y) { return std::abs(x - 100) < 22 && std::abs(y - 100) < 22 ? 2 : none; };
  auto const hill = [](double x, double y) { return std::max(0.0, 4 - std::hypot(x - 101, y - 99) / 10); };
  auto const ball = [](double x, double y) { return std::hypot(x - 100, y - 100) <= 5 ? 2.0 : 0.0; };
  int released = 0, refused = 0;
  auto const check = [&](Raster const& raster) {
    double wanted = 0;
    for (double const d : raster.values) wanted += std::isnan(d) ? 0 : d * sq(raster.spacing);
    try {
      double const found = *Release(flat, raster).exact_volume_below(9);
      CHECK(std::abs(found / wanted - 1) <= 0.0100001);
      ++released;
    } catch (std::runtime_error const& error) {
      CAPTURE(wanted);
      CHECK_THAT(error.what(), ContainsSubstring("depth.asc: the release has " + detail::short_text(wanted) + " m^3"));
      ++refused;
    }
  };
  for (double const shift : {0.0, 0.5, 3.3, 5.0}) {
    check(depth(shift, shift, 10, 20, block));  // also between the points of the ground
    check(depth(shift, shift, 5, 39, hill));
    check(depth(shift, shift, 20, 10, hill));
    check(depth(86 + shift, 86, 1, 29, ball));
  }
  check(depth(96, 96, 1, 9, [](double x, double y) { return std::hypot(x - 105, y - 105) < 2 ? 2.0 : 0.0; }));
  CHECK(released >= 8);
  CHECK(refused >= 1);
  CHECK_THROWS_WITH(
      Release(flat, depth(86, 86, 1, 29, ball)),
      "depth.asc: the release has 162 m^3 in its raster, with points 1 m apart, and 200 m^3 at the points of "
      "the ground, 10 m apart: use a ground that is as fine and reaches as far as the release");
  CHECK_THROWS_WITH(
      Release(flat, depth(86, 86, 1, 29, [](double, double) { return 1e300; })),
      ContainsSubstring("the depth of a release is 1e+300 m at x = 86, y = 86 m; it must be 0 to 100000 m"));
}

TEST_CASE("ground with a height that is none is refused") {
  Raster high = ground;
  high.values[2 * 23 + 4] = 1e308;
  CHECK_THROWS_WITH(HeightField(high), ContainsSubstring("made.asc: there is no height within 1e5 m at x = -0.48"));
}

TEST_CASE("ground with a gap is refused, and may be cropped") {
  Raster gap = ground;
  gap.values[2 * 23 + 4] = std::nan("");
  CHECK_THROWS_WITH(
      HeightField(gap),
      ContainsSubstring("made.asc: there is no value at x = -0.48, y = -1.74 m (column 5, row 3 from below)"));
  CHECK(HeightField(gap.cropped(-0.4, -2, 9, 9)).raster().columns == 18);
}

TEST_CASE("a profile of the ground is a polygon in the plane") {
  Polygon const profile = profile_along(ground, {-0.9, -1}, {1.5, 1}, 0.5);
  double const length = std::hypot(2.4, 2.0);
  CHECK(std::abs(profile.bounds().high[0] - length) < 1e-15);
  for (int k = 1; k < 24; ++k) {
    double const s = length * k / 24, z = ground(-0.9 + 2.4 * k / 24, -1 + 2.0 * k / 24);
    CHECK(profile.contains({s, z - 1e-9}));
    CHECK_FALSE(profile.contains({s, z + 1e-9}));
  }
  CHECK_THROWS_WITH(profile_along(ground, {-0.9, -1}, {9, 1}, 0.5),
                    ContainsSubstring("made.asc: there is no value at x = 9"));
  CHECK_THROWS_WITH(profile_along(ground, {0, 0}, {0, 0}, 0.5), ContainsSubstring("length of a profile"));
}

}  // namespace scree::test::ground_tests
