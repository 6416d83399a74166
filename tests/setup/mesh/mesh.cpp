// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/hexagonal.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/setup/mesh/read_mesh.hpp>
#include <scree/setup/mesh/winding.hpp>
#include <scree/setup/walls.hpp>

#include "../distances.hpp"
#include "bodies.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>

// Distances from meshes, and their sign.
namespace scree::test::mesh_tests {
namespace {

static_assert(Shape<Mesh> && detail::is_costly<Mesh> &&
              detail::is_costly<decltype(complement(Ball<3>{}) | Ball<3>{})> == false);
static_assert(detail::is_costly<Intersection<Complement<Mesh>, Ball<3>>>);

double torus_distance(X3 const& x) { return std::hypot(std::hypot(x[0], x[1]) - 1, x[2]) - 0.4; }
double sphere_distance(X3 const& x) { return x.norm() - 1; }

/// The largest distance of the triangles from a surface, at their middle and at the middle of their sides.
template <class Distance>
double sagitta(Triangles const& mesh, Distance const& distance) {
  double most = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    X3 const a = mesh.vertex(t, 0), b = mesh.vertex(t, 1), c = mesh.vertex(t, 2);
    for (X3 const& x : {X3((a + b + c) / 3), X3((a + b) / 2), X3((b + c) / 2), X3((c + a) / 2)})
      most = std::max(most, std::abs(distance(x)));
  }
  return most;
}

/// Number of points, farther than `margin` from a body, at which `inside` disagrees with a signed distance.
template <class Inside, class Distance>
int wrong_signs(std::vector<X3> const& points, double margin, Inside const& inside, Distance const& distance) {
  int wrong = 0;
  for (X3 const& x : points) {
    double const d = distance(x);
    wrong += std::abs(d) > margin && inside(x) != (d < 0);
  }
  return wrong;
}

/// Whether a ray along x crosses the triangles an odd number of times.
bool inside_by_parity(Triangles const& mesh, X3 const& x) {
  bool odd = false;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    odd ^= std::isfinite(detail::distance_along_ray(detail::corners_of(mesh, t), x, X3(1, 0, 0)));
  return odd;
}

/// A shape without a walk, so that each signed distance is computed.
template <Shape S>
struct Plain {
  static constexpr int dim = S::dim;
  S shape;
  double signed_distance(Vec<dim, double> const& x) const { return shape.signed_distance(x); }
  bool contains(Vec<dim, double> const& x) const { return shape.contains(x); }
  Box<dim> bounds() const { return shape.bounds(); }
};

std::vector<X3> lattice(double spacing) { return fill_lattice(Box<3>{{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}}, spacing); }

}  // namespace

TEST_CASE("distances from a mesh are those from all of its triangles, to 1e-12") {
  for (Triangles const& triangles :
       {sphere_mesh(1, 8), torus_mesh(1, 0.4, 40, 16), box_mesh({-1, -0.5, -0.3}, {0.2, 0.9, 0.7})}) {
    Mesh const mesh(triangles);
    for (X3 const& x : random_points(300, 1.6)) {
      double const d = mesh.signed_distance(x), exact = distance_from_all(triangles, x);
      CHECK(std::abs(std::abs(d) - exact) < 1e-12);
      CHECK(mesh.contains(x) == (d < 0));
      auto const there = mesh.nearest(x);
      CHECK(std::abs((there.point - x).norm() - exact) < 1e-12);
      CHECK(distance_from_triangle(mesh.triangles(), std::size_t(there.triangle), there.point) < 1e-12);
    }
  }
}

TEST_CASE("a box turned in space is the exact box") {
  Box<3> const box{{-0.7, -0.4, -0.5}, {0.6, 0.8, 0.3}};
  auto const turn = rotation_about({1, -2, 0.5}, 0.9);
  Mesh const mesh(placed(read_stl(ascii_stl(box_mesh(box.low, box.high)), "box.stl"), {.rotation = turn}));
  CHECK(std::abs(mesh.report().volume - 1.3 * 1.2 * 0.8) < 1e-14);
  for (X3 const& x : random_points(2000, 1.5))
    CHECK(std::abs(mesh.signed_distance(x) - box.signed_distance(X3(turn.transpose() * x))) < 1e-12);
}

TEST_CASE("a sphere of triangles is the sphere, to a thousandth of the spacing of its particles") {
  double const dr = 0.1;  // 20 particles across
  Triangles const triangles = read_stl(binary_stl(sphere_mesh(1, 100)), "sphere.stl");
  Mesh const mesh(triangles);
  CHECK(sagitta(mesh.triangles(), sphere_distance) < 1e-3 * dr);
  CHECK(std::abs(mesh.report().volume / (4 * std::numbers::pi / 3) - 1) < 0.005);
  CHECK(mesh.report().encloses_exactly());
  for (X3 const& x : lattice(0.23)) CHECK(std::abs(mesh.signed_distance(x) - sphere_distance(x)) < 1e-3 * dr);
}

TEST_CASE("a torus of triangles approaches the torus with the second order of their size") {
  using std::numbers::pi;
  double before = 0;
  for (int const n : {1, 2, 4}) {
    Triangles const triangles = torus_mesh(1, 0.4, 50 * n, 20 * n);
    Mesh const mesh(triangles);
    double const bound = sagitta(triangles, torus_distance);
    double most = 0;
    for (X3 const& x : lattice(0.19)) most = std::max(most, std::abs(mesh.signed_distance(x) - torus_distance(x)));
    CAPTURE(n, most, bound);
    CHECK(most < 1.001 * bound);
    if (n > 1) CHECK(std::abs(before / bound - 4) < 0.2);
    before = bound;
    if (n == 4) CHECK(most < 1e-3);
    CHECK(std::abs(mesh.report().volume / (2 * pi * pi * 0.16) - 1) < 0.02 / (n * n));
  }
}

TEST_CASE("the winding number is that of all solid angles, within the bound of its error") {
  Triangles const triangles = with_holes(torus_mesh(1, 0.4, 60, 24), 0.05);
  TriangleTree const tree(triangles);
  WindingNumbers const winding(tree);
  for (double const each : {0.1, 1e-2, 1e-3, 1e-4}) {
    double largest = 0;
    for (X3 const& x : random_points(300, 1.6)) {
      double exact = 0;
      for (std::size_t t = 0; t < triangles.size(); ++t)
        exact += detail::solid_angle_share(detail::corners_of(triangles, t), x);
      auto const found = winding.at(tree, x, each);
      CHECK(std::abs(found.number - exact) <= found.error + 1e-12);
      largest = std::max(largest, std::abs(found.number - exact));
    }
    CAPTURE(each, largest);
    CHECK(largest < 0.3 * std::sqrt(each));
    CHECK(largest > 0);
  }
}

TEST_CASE("with a fiftieth of its triangles missing a mesh knows its inside, and the parity of a ray does not") {
  double const dr = 0.1;
  auto const points = lattice(dr);
  for (auto const& [triangles, distance] :
       {std::pair(sphere_mesh(1, 24), &sphere_distance), std::pair(torus_mesh(1, 0.4, 80, 32), &torus_distance)}) {
    Triangles const holed = with_holes(triangles, 0.02);
    REQUIRE(holed.size() < 0.985 * double(triangles.size()));
    Mesh const mesh(holed);
    auto const contains = [&](X3 const& x) { return mesh.contains(x); };
    CHECK(wrong_signs(points, dr, contains, distance) == 0);
    auto const odd = [&](X3 const& x) { return inside_by_parity(holed, X3(x + X3(0, 1e-4, 2e-4))); };
    CHECK(wrong_signs(lattice(0.2), dr, odd, distance) > 3);
  }
}

TEST_CASE("shells that overlap are their union") {
  double const dr = 0.1;
  Triangles two = sphere_mesh(0.7, 12);
  for (auto& x : two.vertices) x -= X3(0.4, 0, 0);
  append(two, box_mesh({-0.5, -0.5, -0.5}, {0.9, 0.5, 0.5}));
  Mesh const mesh(two);
  Box<3> const box{{-0.5, -0.5, -0.5}, {0.9, 0.5, 0.5}};
  auto const both = Ball<3>{.centre = {-0.4, 0, 0}, .radius = 0.7} | box;
  auto const contains = [&](X3 const& x) { return mesh.contains(x); };
  auto const distance = [&](X3 const& x) { return both.signed_distance(x); };
  CHECK(wrong_signs(lattice(dr), dr, contains, distance) == 0);
  // A lattice with particles on the side of the box that is within the sphere has no gap there.
  for (X3 const& x : fill_lattice(Box<3>{{-0.55, -0.45, -0.45}, {-0.45, 0.45, 0.45}}, dr)) {
    CHECK(x[0] == -0.5);
    CHECK(mesh.signed_distance(x) < -1e-7);
  }
}

TEST_CASE("a box of triangles is filled and walled like the box") {
  double const dr = 0.083;
  Box<3> const box{{-0.61, -0.73, -0.52}, {0.64, 0.55, 1.1}};
  Mesh const block(box_mesh(box.low, box.high));
  X3 const anchor(0.01, 0.02, 0.03);
  CHECK(same_points(fill_lattice(block, dr, anchor), fill_lattice(box & whole_space<3>(), dr, anchor), 0));
  CHECK(same_points(fill_hexagonal(block, dr), fill_hexagonal(box & whole_space<3>(), dr), 0));
  Box<3> const around{{-1.2, -1.2, -1.2}, {1.2, 1.2, 0.3}};
  CHECK(same_points(wall_around(complement(block), dr, 2, around), wall_around(complement(box), dr, 2, around), 0));
  CHECK(same_points(wall_around(block, dr, 3), wall_around(box | box, dr, 3), 0));
}

TEST_CASE("distances that fillings and walls do not compute change nothing") {
  double const dr = 0.083;
  Box<3> const around{{-1.2, -1.2, -1.2}, {1.2, 1.2, 0.3}};
  Mesh const torus(torus_mesh(1, 0.4, 40, 16));
  Ball<3> const ball{.centre = {1, 0, 0}, .radius = 0.5};
  auto const check = [&](auto const& shape) {
    Plain<std::remove_cvref_t<decltype(shape)>> const plain{shape};
    CHECK(fill_lattice(shape, dr) == fill_lattice(plain, dr));
    CHECK(wall_around(shape, dr, 3, around) == wall_around(plain, dr, 3, around));
  };
  check(torus);
  check(torus | ball);
  check(torus - ball);
  check(offset(torus, 0.05));
}

TEST_CASE("normals of a mesh point outwards, on both sides and on it") {
  Mesh const block(box_mesh({-1, -1, -1}, {1, 1, 1}));
  CHECK((block.outward_normal({0.3, 0.2, 0.9}) - X3(0, 0, 1)).norm() < 1e-15);
  CHECK((block.outward_normal({0.3, 0.2, 1.4}) - X3(0, 0, 1)).norm() < 1e-15);
  CHECK((block.outward_normal({0.3, 0.2, 1}) - X3(0, 0, 1)).norm() < 1e-15);
  CHECK((outward_normal(block, X3(1.3, 0, 1.4)) - X3(0.6, 0, 0.8)).norm() < 1e-14);
}

}  // namespace scree::test::mesh_tests
