// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/mesh/obj.hpp>

#include "bodies.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <numbers>

namespace scree::test::obj_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
std::string const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

double area_of(Triangles const& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) area += mesh.area_vector(t)[2];
  return area;
}

}  // namespace

TEST_CASE("polygons of an OBJ file become triangles, whatever stands behind the slashes") {
  std::string const text =
      "# a square\nmtllib a.mtl\no square\n" + square + "vn 0 0 1\nvt 0 0\ng side\nusemtl red\ns off\n";
  for (char const* face : {"f 1 2 3 4\n", "f 1/1 2/1 3/1 4/1", "f 1//1 2//1 3//1 4//1", "f -4 -3 -2 -1",
                           "f 1/1/1 2 -2/1 4", "f 1 2 \\\n3 4"}) {
    CAPTURE(face);
    Triangles const mesh = read_obj(text + face, "a.obj");
    CHECK(mesh.size() == 2);
    CHECK(area_of(mesh) == 1);
    CHECK(mesh.place_of(1).starts_with("a.obj, line 1"));
  }
}

TEST_CASE("concave polygons are cut along their inside") {
  using std::numbers::pi;
  // An L, once with a corner on one of its straight sides.
  std::string const l = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 1 0\n";
  for (char const* face : {"f 1 2 3 4 5 6", "f 4 5 6 1 2 3", "f 1 2 3 4 5 6 7", "f 7 1 2 3 4 5 6"}) {
    Triangles const mesh = read_obj(l + face, "a.obj");
    CAPTURE(face);
    CHECK(std::abs(area_of(mesh) - 3) < 1e-15);
    for (std::size_t t = 0; t < mesh.size(); ++t) {
      CHECK(mesh.area_vector(t)[2] > 0);
      X3 const middle = (mesh.vertex(t, 0) + mesh.vertex(t, 1) + mesh.vertex(t, 2)) / 3;
      CHECK((middle[0] < 1 || middle[1] < 1));
    }
  }
  // A star of 40 corners, in a plane of any direction.
  std::string star, face = "f";
  for (int k = 0; k < 40; ++k) {
    double const r = k % 2 == 0 ? 1 : 0.3, a = 2 * pi * k / 40;
    star += "v " + std::to_string(r * std::cos(a)) + " " + std::to_string(r * std::sin(a)) + " " +
            std::to_string(r * std::cos(a)) + "\n";
    face += " " + std::to_string(k + 1);
  }
  Triangles const mesh = read_obj(star + face, "a.obj");
  CHECK(mesh.size() == 38);
  CHECK(std::abs(area_of(mesh) - 20 * 0.3 * std::sin(2 * pi / 40)) < 1e-5);
}

TEST_CASE("what an OBJ file cannot mean is refused with its line") {
  auto const refused = [](std::string const& line, std::string const& why) {
    CAPTURE(line);
    CHECK_THROWS_WITH(read_obj(square + line, "a.obj"), ContainsSubstring("a.obj, line 5: ") && ContainsSubstring(why));
  };
  refused("f 1 2 5", "'5' is none of the 4 vertices so far");
  refused("f 1 2 -5", "'-5' is none");
  refused("f 0 1 2", "'0' is none");
  refused("f 1 2 99999999999999999999", "is none");
  refused("f 1 2 x", "'x' is none");
  refused("f 1 2 /3", "'/3' is none");
  refused("f 1 2", "three corners or more");
  refused("f 1 3 2 4", "crosses itself");
  refused("v 1 2", "three coordinates");
  refused("v 1 2 nan", "not a finite number");
  refused("v 1 2 3e", "not a number");
  refused("curv2 1 2", "'curv2' is not read");
  std::string many = "f";
  for (int k = 0; k < 1001; ++k) many += " 1";
  refused(many, "more than 1000 corners");
  CHECK(read_obj("", "a.obj").size() == 0);
}

}  // namespace scree::test::obj_tests
