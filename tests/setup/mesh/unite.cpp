// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/lattice.hpp>
#include <scree/setup/mesh/read_mesh.hpp>
#include <scree/setup/walls.hpp>

#include "bodies.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

// Closed shells that touch, overlap or enclose each other are their union.
namespace scree::test::unite_tests {
namespace {

/// A box turned in space or a tetrahedron, as planes: inside is where all of them are in front.
struct Convex {
  std::vector<X3> points, normals;  // of the planes; normals of length one, inwards
  Triangles triangles;
  bool hollow = false;

  /// Positive inside; the distance from the nearest plane.
  double depth(X3 const& x) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < points.size(); ++k) least = std::min(least, normals[k].dot(X3(x - points[k])));
    return least;
  }
};

struct Random {
  std::mt19937 engine;
  int whole(int low, int high) { return low + int(engine() % unsigned(high - low + 1)); }
  double part() { return double(engine()) / 4294967296.0; }
  X3 point() { return {2 * part() - 1, 2 * part() - 1, 2 * part() - 1}; }
  X3 grid_point() { return {whole(0, 4) * 0.5 - 1, whole(0, 4) * 0.5 - 1, whole(0, 4) * 0.5 - 1}; }
};

Convex convex_box(Random& random, X3 const& low, X3 const& high, Mat<3, double> const& turn) {
  Convex box;
  box.triangles = box_mesh(low, high);
  for (std::size_t face = 0; face < 6; ++face) {  // along one diagonal or the other
    auto &one = box.triangles.corners[2 * face], &other = box.triangles.corners[2 * face + 1];
    std::array<int, 4> const round{one[0], one[1], one[2], other[2]};
    if (random.whole(0, 1) == 0) one = {round[0], round[1], round[3]}, other = {round[1], round[2], round[3]};
  }
  for (auto& x : box.triangles.vertices) x = X3(turn * x);
  for (int axis = 0; axis < 3; ++axis)
    for (double const side : {1.0, -1.0}) {
      box.points.push_back(turn * (side > 0 ? low : high));
      box.normals.push_back(side * turn * X3::Unit(axis));
    }
  return box;
}
Convex tetrahedron(std::array<X3, 4> corners) {
  Convex result;
  if (X3(corners[1] - corners[0]).cross(X3(corners[2] - corners[0])).dot(X3(corners[3] - corners[0])) < 0)
    std::swap(corners[0], corners[1]);
  result.triangles.vertices.assign(corners.begin(), corners.end());
  result.triangles.corners = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (std::size_t t = 0; t < 4; ++t) {
    result.points.push_back(result.triangles.vertex(t, 0));
    result.normals.push_back(-result.triangles.area_vector(t).normalized());
  }
  return result;
}

/// 1 to 5 shells. Corners of boxes and of half of the tetrahedra are on a coarse grid, so that faces, edges and corners
/// coincide; each fourth union is turned as a whole, each fourth has boxes in any direction, boxes may have a cavity.
std::vector<Convex> random_shells(Random& random) {
  int const kind = random.whole(0, 3), count = random.whole(1, 5);
  auto const turn = [&] { return rotation_about(random.point(), 3 * random.part()); };
  Mat<3, double> const whole_turn = kind == 1 ? turn() : Mat<3, double>::Identity();
  std::vector<Convex> shells;
  while (int(shells.size()) < count) {
    if (kind >= 2 && random.whole(0, 1) == 0) {
      bool const on_grid = random.whole(0, 1) == 0;
      std::array<X3, 4> corners;
      for (auto& x : corners) x = on_grid ? random.grid_point() : random.point();
      double const six_volumes =
          X3(corners[1] - corners[0]).cross(X3(corners[2] - corners[0])).dot(X3(corners[3] - corners[0]));
      if (std::abs(six_volumes) > 0.1) shells.push_back(tetrahedron(corners));
      continue;
    }
    X3 const a = random.grid_point(), b = random.grid_point(), low = a.cwiseMin(b), high = a.cwiseMax(b);
    if ((high - low).minCoeff() == 0) continue;
    Mat<3, double> const turned = kind == 3 ? turn() : whole_turn;
    shells.push_back(convex_box(random, low, high, turned));
    if (random.whole(0, 3) > 0 || int(shells.size()) == count) continue;
    X3 const by = 0.25 * (high - low);
    shells.push_back(convex_box(random, low + by, high - by, turned));
    shells.back().hollow = true;
    for (std::size_t t = 0; t < 12; ++t) turn_over(shells.back().triangles, t);
  }
  return shells;
}

std::string obj(Triangles const& mesh) {
  std::string text;
  char line[120];
  for (X3 const& x : mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    text += line;
  }
  for (auto const& [a, b, c] : mesh.corners)
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  return text;
}

Triangles joined(std::vector<Convex> const& shells) {
  Triangles all;
  for (auto const& shell : shells) append(all, shell.triangles);
  return all;
}

/// The sum of the shells at x is positive; none where x is within 1e-6 of a plane.
std::optional<bool> is_within(std::vector<Convex> const& shells, X3 const& x) {
  int sum = 0;
  for (auto const& shell : shells) {
    double const depth = shell.depth(x);
    if (std::abs(depth) < 1e-6) return std::nullopt;
    if (depth > 0) sum += shell.hollow ? -1 : 1;
  }
  return sum > 0;
}

Box<3> const left{{0, 0, 0}, {1, 1, 1}}, right{{1, 0, 0}, {2, 1, 1}};

}  // namespace

TEST_CASE("unions of 200 random sets of shells are those of their planes at each point, by each way of asking") {
  Random random{std::mt19937(5)};
  int wrong = 0, inexact = 0, seen = 0;
  for (int k = 0; k < 200; ++k) {
    auto const shells = random_shells(random);
    Triangles const all = joined(shells);
    Mesh const mesh(k % 3 == 0   ? read_stl(ascii_stl(all), "a.stl")
                    : k % 3 == 1 ? read_stl(binary_stl(all), "b.stl")
                                 : read_obj(obj(all), "c.obj"));
    inexact += !mesh.report().encloses_exactly();
    auto walk = mesh.walk();
    double const dr = 0.33;
    Box<3> const around{{-1.98, -1.98, -1.98}, {1.98, 1.98, 1.98}};
    X3 const anchor = mesh.bounds().low;
    long filled = 0, on_planes = 0;
    for (X3 const& x : fill_lattice(around, dr, anchor)) {
      bool const inside = mesh.contains(x);
      wrong += (mesh.signed_distance(x) < 0) != inside || (walk(x) < 0) != inside;
      auto const exact = is_within(shells, x);
      if (exact) wrong += inside != *exact, ++seen;
      filled += exact == true, on_planes += !exact;
    }
    long const found = long(fill_lattice(mesh & around, dr, anchor).size());
    wrong += found < filled || found > filled + on_planes;
  }
  CHECK(wrong == 0);
  CHECK(inexact == 0);
  CHECK(seen > 250'000);
}

TEST_CASE("unions of boxes on a grid have the volume of its cells and the distance from them, inside and outside") {
  Random random{std::mt19937(9)};
  double volume = 0, most = 0;
  for (int k = 0; k < 40; ++k) {
    std::vector<Convex> shells;
    for (int count = random.whole(2, 5); int(shells.size()) < count;) {
      X3 const a = random.grid_point(), b = random.grid_point(), low = a.cwiseMin(b), high = a.cwiseMax(b);
      if ((high - low).minCoeff() > 0) shells.push_back(convex_box(random, low, high, Mat<3, double>::Identity()));
    }
    Mesh const mesh(joined(shells));
    auto const cells = fill_lattice(Box<3>{{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}}, 0.5);
    std::vector<bool> full;
    for (X3 const& x : cells) full.push_back(*is_within(shells, x));
    double const exact = 0.125 * double(std::count(full.begin(), full.end(), true));
    volume = std::max(volume, std::abs(mesh.report().volume - exact));
    for (X3 const& x : random_points(60, 1.4)) {
      bool const inside = *is_within(shells, x);
      double distance = std::numeric_limits<double>::infinity();
      for (std::size_t c = 0; c < cells.size(); ++c) {
        Box<3> const cell = detail::grown(Box<3>{cells[c], cells[c]}, 0.25);
        if (full[c] != inside) distance = std::min(distance, cell.signed_distance(x));
      }
      most = std::max(most, std::abs(mesh.signed_distance(x) - (inside ? -distance : distance)));
    }
  }
  CHECK(volume < 1e-12);
  CHECK(most < 1e-12);
}

TEST_CASE("two boxes that share a face are filled and walled like one, with particles on the face") {
  for (double const dr : {0.1, 2.0 / 19}) {  // the face is between particles, and amid them
    Triangles two = box_mesh(left.low, left.high);
    append(two, box_mesh(right.low, right.high));
    Mesh const mesh(two);
    Box<3> const whole{{0, 0, 0}, {2, 1, 1}};
    auto const one_shell = whole & whole_space<3>();
    CHECK(fill_lattice(mesh, dr).size() == fill_lattice(one_shell, dr).size());
    CHECK(wall_around(mesh, dr, 3).size() == wall_around(whole | whole, dr, 3).size());
    CHECK(mesh.contains({1, 0.5, 0.5}));
    CHECK(mesh.signed_distance({1, 0.5, 0.5}) == -0.5);
    CHECK(std::abs(mesh.report().volume - 2) < 1e-14);
    CHECK(std::abs(*mesh.exact_volume_below(0.25) - 0.5) < 1e-15);
    CHECK_THAT(mesh.report().text(dr),
               Catch::Matchers::ContainsSubstring("16.7 % of the area within another shell or between two that touch"));
  }
}

TEST_CASE("a shell that is inside out is turned over where it touches, overlaps or follows another one") {
  for (X3 const& by : {X3(1, 0, 0), X3(1, 1, 0), X3(1, 1, 1), X3(0.5, 0.25, 0), X3(3, 0, 0)})
    for (int const which : {0, 1}) {
      Triangles one = box_mesh(left.low, left.high), other = box_mesh(left.low + by, left.high + by), all;
      for (std::size_t t = 0; t < 12; ++t) turn_over(which == 0 ? one : other, t);
      append(all, one), append(all, other);
      X3 const shared = (X3::Ones() - by).cwiseMax(0.0);
      CAPTURE(by.transpose(), which);
      CHECK(std::abs(Mesh(all).report().volume - (2 - shared.prod())) < 1e-12);
      CHECK(Mesh(all).report().encloses_exactly());
    }
}

TEST_CASE("a shell that may be a cavity or a body is refused") {
  Triangles all = box_mesh({0, 0, 0}, {3, 3, 3}), inner = box_mesh({1, 1, 2}, {2, 2, 3});
  for (std::size_t t = 0; t < 12; ++t) turn_over(inner, t);
  append(all, inner);
  CHECK_THROWS_WITH(Mesh(all), Catch::Matchers::ContainsSubstring("mesh, triangle 13: this closed shell is inside out "
                                                                  "and touches a larger one from within"));
}

TEST_CASE("a mesh without room for a particle is refused") {
  Mesh const tiny(box_mesh({0, 0, 0}, {1e-30, 1e-30, 1e-30}));
  CHECK_THROWS_WITH(fill_lattice(tiny, 0.1),
                    Catch::Matchers::ContainsSubstring("a Mesh of 1e-30 x 1e-30 x 1e-30 m has no room for a particle"));
}

}  // namespace scree::test::unite_tests
