// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/lattice.hpp>
#include <scree/setup/mesh/read_mesh.hpp>
#include <scree/setup/walls.hpp>

#include "shells.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>
#include <utility>
#include <vector>

// Closed shells that touch, overlap or enclose each other are their union.
namespace scree::test::unite_tests {
using namespace shells;
namespace {

Box<3> const left{{0, 0, 0}, {1, 1, 1}}, right{{1, 0, 0}, {2, 1, 1}};

/// How a mesh differs from the planes of its shells at the points of a lattice.
struct Compared {
  int wrong = 0, inexact = 0, seen = 0;

  /// `k`: the format in which the shells are read.
  void add(std::vector<Convex> const& shells, int k) {
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
};

}  // namespace

TEST_CASE("unions of 200 random sets of shells are those of their planes at each point, by each way of asking") {
  Random random{std::mt19937(5)};
  Compared all;
  for (int k = 0; k < 200; ++k) all.add(random_shells(random), k);
  CHECK(all.wrong == 0);
  CHECK(all.inexact == 0);
  CHECK(all.seen > 250'000);
}

// In these sets an edge of another shell, or of two of them, is just behind the middle of a triangle: the sum of the
// solid angles is no whole number there.
TEST_CASE("a shell whose edge is behind the middle of another shell's triangle is united with it") {
  std::vector<std::pair<unsigned, int>> const sets = {{20, 29}, {52, 174}, {63, 161}, {82, 165}};
  for (auto const& [seed, number] : sets) {
    Random random{std::mt19937(seed)};
    for (int k = 0; k < number; ++k) random_shells(random);
    Compared one;
    CAPTURE(seed);
    CHECK_NOTHROW(one.add(random_shells(random), number));
    CHECK(one.wrong == 0);
    CHECK(one.inexact == 0);
    CHECK(one.seen > 1000);
  }
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
