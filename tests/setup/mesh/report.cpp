// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/mesh/mesh.hpp>
#include <scree/setup/mesh/placement.hpp>

#include "bodies.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <numbers>

// The report of a mesh, its changes, and refused meshes.
namespace scree::test::report_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
Triangles const block = box_mesh({0, 0, 0}, {1, 2, 3});

/// Each triangle with vertices of its own, as in an STL file.
Triangles apart(Triangles const& mesh) {
  Triangles result;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    int const first = int(3 * t);
    for (std::size_t k = 0; k < 3; ++k) result.vertices.push_back(mesh.vertex(t, k));
    result.corners.push_back({first, first + 1, first + 2});
  }
  return result;
}

}  // namespace

TEST_CASE("a good mesh is reported as it is and not changed") {
  Mesh const mesh(apart(block));
  auto const& report = mesh.report();
  CHECK(report.triangles == 12);
  CHECK(report.triangles_read == 12);
  CHECK(report.orientation.shells == 1);
  CHECK(report.orientation.closed_shells == 1);
  CHECK(report.encloses_exactly());
  CHECK(report.welded_vertices + report.degenerate_triangles + report.orientation.turned_triangles == 0);
  CHECK(report.orientation.turned_shells == 0);
  CHECK(std::abs(report.volume - 6) < 1e-14);
  CHECK(std::abs(report.area - 22) < 1e-14);
  CHECK(report.bounds.low == X3(0, 0, 0));
  CHECK(report.bounds.high == X3(1, 2, 3));
  CHECK(std::abs(report.wall.distance - 1) < 1e-15);
  CHECK(report.gap.place.empty());
  CHECK(report.text(0.1) ==
        "mesh: 12 triangles in 1 shells, 1 of them closed\n"
        "  from (0, 0, 0) to (1, 2, 3) m, 10 x 20 x 30 spacings\n"
        "  area 22 m^2, volume 6 m^3\n"
        "  thinnest wall: 10 spacings, at " +
            report.wall.place + "\n");
}

TEST_CASE("vertices that differ by rounding are joined, those that differ by more are not") {
  Triangles mesh = apart(block);
  mesh.vertices[4] += X3(1e-7, 0, 0);
  CHECK(Mesh(mesh).report().welded_vertices == 1);
  CHECK(Mesh(mesh).report().encloses_exactly());
  mesh.vertices[4] += X3(1e-4, 0, 0);
  CHECK(Mesh(mesh).report().welded_vertices == 0);
  CHECK(Mesh(mesh).report().orientation.open_edges.size() == 4);
}

TEST_CASE("vertices are joined whatever their place is among the cubes in which they are sorted") {
  Triangles mesh = apart(sphere_mesh(1, 6));
  auto const moves = random_points(int(mesh.vertices.size()), 3e-8);
  for (std::size_t k = 0; k < moves.size(); ++k) mesh.vertices[k] += moves[k];
  Mesh const joined(mesh);
  CHECK(joined.triangles().vertices.size() == 4 * 6 * 6 + 2);
  CHECK(joined.report().encloses_exactly());
}

TEST_CASE("vertices without a triangle do not count") {
  Triangles mesh = block;
  mesh.vertices.push_back({1e9, 0, 0});
  CHECK(Mesh(mesh).bounds().high == X3(1, 2, 3));
}

TEST_CASE("triangles without area are dropped") {
  Triangles mesh = block;
  mesh.vertices.push_back({0.5, 0, 0});  // on an edge
  mesh.corners.push_back({0, 0, 1});
  mesh.corners.push_back({0, 8, 1});
  CHECK(Mesh(mesh).report().degenerate_triangles == 2);
  CHECK(Mesh(mesh).report().encloses_exactly());
}

TEST_CASE("triangles that are turned over against their neighbours are turned back") {
  Triangles mesh = sphere_mesh(1, 6);
  double const volume = Mesh(mesh).report().volume;
  for (std::size_t const t : {3, 50, 51, 200}) turn_over(mesh, t);
  CHECK(Mesh(mesh).report().orientation.turned_triangles == 4);
  CHECK(Mesh(mesh).report().volume == volume);
}

TEST_CASE("a closed shell that is inside out is turned over, but for one within another shell") {
  Triangles mesh = block;
  for (std::size_t t = 0; t < mesh.size(); ++t) turn_over(mesh, t);
  CHECK(Mesh(mesh).report().orientation.turned_shells == 1);
  CHECK(std::abs(Mesh(mesh).report().volume - 6) < 1e-14);
  Triangles hollow = block, hole = box_mesh({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  for (std::size_t t = 0; t < hole.size(); ++t) turn_over(hole, t);
  append(hollow, hole);
  Mesh const with_cavity(hollow);
  CHECK(with_cavity.report().orientation.turned_shells == 0);
  CHECK(with_cavity.report().orientation.nested_shells == 1);
  CHECK(with_cavity.report().encloses_exactly());
  CHECK(std::abs(with_cavity.report().volume - (6 - 0.125)) < 1e-14);
  CHECK(std::abs(with_cavity.report().wall.distance - 0.25) < 1e-14);
  CHECK(std::abs(with_cavity.report().gap.distance - 0.5) < 1e-14);
  CHECK(std::abs(with_cavity.signed_distance({0.5, 0.5, 0.5}) - 0.25) < 1e-15);
  CHECK(std::abs(with_cavity.signed_distance({0.5, 0.5, 2}) + 0.5) < 1e-15);
}

TEST_CASE("holes and shells that overlap are reported") {
  Triangles const holed = without(sphere_mesh(1, 10), [](std::size_t t) { return t % 50 == 7; });
  Mesh const with_hole(holed);
  CHECK(with_hole.report().orientation.open_edges.size() == 3 * 16);
  CHECK_FALSE(with_hole.report().encloses_exactly());
  CHECK_THAT(with_hole.report().text(0.1), ContainsSubstring("open edges: there are holes"));
  Triangles two = block;
  append(two, box_mesh({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}));
  auto const report = Mesh(two).report();
  CHECK(report.orientation.shells == 2);
  CHECK(report.buried_share > 0);
  CHECK(report.encloses_exactly());
  CHECK(std::abs(report.volume - 6.5) < 1e-13);
  CHECK_THAT(report.text(0.1), ContainsSubstring("between two that touch, and left out; first at mesh, triangle"));
}

TEST_CASE("an edge of four triangles does no harm to a closed mesh") {
  Triangles mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  append(mesh, box_mesh({1, 1, 0}, {2, 2, 1}));
  auto const report = Mesh(mesh).report();
  CHECK(report.orientation.crowded_edges.size() == 1);
  CHECK(report.encloses_exactly());
  CHECK(std::abs(report.volume - 2) < 1e-14);
}

TEST_CASE("the thinnest wall and gap are those of parallel plates, in any position") {
  Triangles mesh = box_mesh({0, 0, 0}, {3, 3, 0.2});
  append(mesh, box_mesh({0, 0, 0.3}, {3, 3, 1}));
  for (auto& x : mesh.vertices) x = X3(rotation_about({1, 2, 3}, 0.7) * x);
  CHECK(std::abs(Mesh(mesh).report().wall.distance - 0.2) < 1e-14);
  CHECK(std::abs(Mesh(mesh).report().gap.distance - 0.1) < 1e-14);
}

TEST_CASE("a mesh that cannot be a body is refused with its file and a triangle") {
  CHECK_THROWS_WITH(Mesh(Triangles{}), "mesh: there is no triangle with an area");
  Triangles flat{.name = "flat.stl", .vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, .corners = {{0, 1, 2}}};
  CHECK_THROWS_WITH(Mesh(flat), "flat.stl: there is no triangle with an area");
  Triangles sheet = without(block, [](std::size_t t) { return t >= 2; });
  CHECK_THROWS_WITH(Mesh(sheet), ContainsSubstring("mesh, triangle 1: 100 % of the area has no inside behind it") &&
                                     ContainsSubstring("there are 4 open edges"));
  Triangles strip;  // of Moebius
  int const n = 12;
  for (int k = 0; k < n; ++k) {
    double const a = 2 * std::numbers::pi * k / n;
    for (double const s : {-0.2, 0.2}) {
      double const r = 1 + s * std::cos(a / 2);
      strip.vertices.push_back({r * std::cos(a), r * std::sin(a), s * std::sin(a / 2)});
    }
    int const here = 2 * k, next = k + 1 < n ? here + 2 : 0, cross = k + 1 < n ? 0 : 1;
    strip.corners.push_back({here, next + cross, here + 1});
    strip.corners.push_back({next + cross, next + 1 - cross, here + 1});
  }
  CHECK_THROWS_WITH(Mesh(strip), ContainsSubstring("only one side"));
}

}  // namespace scree::test::report_tests
