// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/measured_fill.hpp>
#include <scree/setup/mesh/mesh.hpp>
#include <scree/setup/mesh/placement.hpp>
#include <scree/setup/walls.hpp>

#include "bodies.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <atomic>
#include <stdexcept>
#include <type_traits>

// Signed distances at points one after another, and fillings that threads share.
namespace scree::test::walk_tests {
namespace {

/// Two boxes and a sphere that overlap, turned in space; a torus with holes; a box with a cavity; narrow triangles.
std::vector<Mesh> bodies() {
  Triangles overlap = box_mesh({-1, -0.5, -0.5}, {0.3, 0.5, 0.5});
  append(overlap, box_mesh({-0.3, -0.7, -0.4}, {1, 0.2, 0.6}));
  append(overlap, sphere_mesh(0.7, 9));
  Triangles cavity = box_mesh({-1, -1, -1}, {1, 1, 1}), inner = sphere_mesh(0.6, 6);
  for (std::size_t t = 0; t < inner.size(); ++t) turn_over(inner, t);
  append(cavity, inner);
  return {Mesh(placed(overlap, {.rotation = rotation_about({1, 2, -1}, 0.7)})), Mesh(overlap),
          Mesh(with_holes(torus_mesh(1, 0.4, 30, 12), 0.02)), Mesh(cavity), Mesh(torus_mesh(1, 0.4, 200, 6))};
}

/// A ball whose distance fails at a part of its surface.
struct Broken {
  static constexpr int dim = 3;
  static constexpr bool costly_distance = true;
  double signed_distance(Vec<3, double> const& x) const {
    if (x[2] > 0.9) throw std::runtime_error("the top is missing");
    return x.norm() - 1;
  }
  bool contains(Vec<3, double> const& x) const { return signed_distance(x) < 0; }
  Box<3> bounds() const { return {{-1, -1, -1}, {1, 1, 1}}; }
};

/// A ball that counts how often its distance is computed.
struct Counted {
  static constexpr int dim = 3;
  static constexpr bool costly_distance = true;
  std::atomic<long>* count;
  double signed_distance(Vec<3, double> const& x) const {
    ++*count;
    return x.norm() - 1;
  }
  bool contains(Vec<3, double> const& x) const { return signed_distance(x) < 0; }
  Box<3> bounds() const { return {{-1, -1, -1}, {1, 1, 1}}; }
};

/// A shape without a walk, so that each distance is computed by itself.
template <Shape S>
struct OneByOne {
  static constexpr int dim = S::dim;
  S shape;
  double signed_distance(Vec<dim, double> const& x) const { return shape.signed_distance(x); }
  bool contains(Vec<dim, double> const& x) const { return shape.contains(x); }
  Box<dim> bounds() const { return shape.bounds(); }
};

}  // namespace

TEST_CASE("a walk through a mesh finds the same bits as each point by itself") {
  for (Mesh const& mesh : bodies()) {
    CAPTURE(mesh.report().text(0.1));
    int inside = 0;
    for (double const stride : {0.03, 0.1, 0.5}) {
      auto walk = mesh.walk();
      X3 x(-1.3, 0.1, 0.2);
      int wrong = 0;
      for (X3 const& by : random_points(2000, 1)) {
        x += stride * by;
        for (int axis = 0; axis < 3; ++axis) x[axis] -= 2.6 * std::round(x[axis] / 2.6);  // stays near
        double const d = walk(x);
        wrong += d != mesh.signed_distance(x), inside += d < 0;
      }
      CHECK(wrong == 0);
    }
    CHECK((inside > 200 && inside < 5800));
  }
}

TEST_CASE("a walk that passes through corners and sides of triangles, and along them, keeps its side") {
  Triangles two = box_mesh({-1, -1, -1}, {0.5, 0.5, 0.5});
  append(two, box_mesh({-0.5, -0.5, -0.5}, {1, 1, 1}));
  Mesh const mesh(two);
  auto walk = mesh.walk();
  int wrong = 0;
  for (double const z : {-1.0, -0.75, -0.5, 0.0, 0.25, 1.0, 1.25})
    for (double const y : {-1.25, -1.0, -0.5, 0.0, 0.5, 1.0})
      for (double x = -1.25; x <= 1.25; x += 0.25) {
        double const d = walk(X3(x, y, z)), exact = mesh.signed_distance(X3(x, y, z));
        wrong += d != exact;
      }
  CHECK(wrong == 0);
}

TEST_CASE("the nearest point is found whatever distance it is said to be within") {
  Mesh const mesh(torus_mesh(1, 0.4, 30, 12));
  TriangleTree const tree(mesh.triangles());
  for (X3 const& x : random_points(200, 1.5)) {
    auto const there = tree.nearest(x);
    for (double const share : {0.0, 0.5, 1.0, 1.5}) {
      auto const found = tree.nearest(x, share * there.distance);
      CHECK((found.triangle == there.triangle && found.distance == there.distance && found.point == there.point));
    }
  }
}

TEST_CASE("fillings, walls and volumes that threads share are those of each point by itself") {
  double const dr = 0.14;
  Ball<3> const ball{.centre = {0.5, 0, 0}, .radius = 0.5};
  auto const check = [&](auto const& shape) {
    OneByOne<std::remove_cvref_t<decltype(shape)>> const plain{shape};
    CHECK(fill_lattice(shape, dr) == fill_lattice(plain, dr));
    CHECK(wall_around(shape, dr, 3) == wall_around(plain, dr, 3));
    VolumeBelow const volume(shape | shape, dr);
    VolumeBelow const each(plain | plain, dr);
    for (double const level : {-0.7, 0.0, 0.3, 2.0}) CHECK(volume(level) == each(level));
  };
  int holed = 0;
  for (Mesh const& mesh : bodies()) {
    CHECK((ball - offset(mesh, 0.1)).has_jumps() == mesh.has_jumps());
    holed += mesh.has_jumps();
    if (mesh.has_jumps()) continue;
    check(mesh);
    check(ball - mesh);
    auto const filled = fill_up_to(mesh, 0.1, dr), again = fill_up_to(mesh, VolumeBelow<Mesh>(mesh, dr), 0.1, dr);
    CHECK(filled.points == again.points);
    CHECK(filled.volumes == again.volumes);
  }
  CHECK(holed == 1);
}

TEST_CASE("a filling computes few distances more than there are particles at the surface") {
  std::atomic<long> count = 0;
  double const dr = 0.02, at_surface = 4 * std::numbers::pi / (dr * dr);
  auto const points = fill_lattice(Counted{&count}, dr);
  CHECK(double(points.size()) > 15 * at_surface);
  CHECK(double(count) < 5 * at_surface);
}

TEST_CASE("an error in the distance of a shape reaches the caller of a filling") {
  CHECK_THROWS_WITH(fill_lattice(Broken{}, 0.05), Catch::Matchers::ContainsSubstring("the top is missing"));
  CHECK_THROWS_AS(volume_of(Broken{} | Broken{}, 0.05), std::runtime_error);
}

}  // namespace scree::test::walk_tests
