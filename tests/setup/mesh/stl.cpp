// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/mesh/read_mesh.hpp>

#include "bodies.hpp"

#include <support/folder.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <numbers>

namespace scree::test::stl_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
Triangles const block = box_mesh({0, 0, 0}, {1, 2, 3});

void check_same(Triangles const& one, Triangles const& other) {
  REQUIRE(one.size() == other.size());
  for (std::size_t t = 0; t < one.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) CHECK(one.vertex(t, k) == other.vertex(t, k));
}
std::string replaced(std::string text, std::string const& what, std::string const& by) {
  return text.replace(text.find(what), what.size(), by);
}

}  // namespace

TEST_CASE("an STL file is read, ASCII or binary, in either case of letters and with either end of lines") {
  check_same(read_stl(ascii_stl(block), "a.stl"), block);
  check_same(read_stl(binary_stl(block), "a.stl"), block);
  std::string upper = ascii_stl(block), windows;
  for (char& c : upper) c = char(std::toupper(c));
  for (char const c : ascii_stl(block)) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  check_same(read_stl(upper, "a.stl"), block);
  check_same(read_stl(windows, "a.stl"), block);
  Triangles two = block;
  append(two, block);
  check_same(read_stl(ascii_stl(block) + ascii_stl(block), "a.stl"), two);
}

TEST_CASE("a binary STL file may begin with the word that marks an ASCII file") {
  check_same(read_stl(binary_stl(block, "solid facet vertex"), "a.stl"), block);
}

TEST_CASE("a triangle of an STL file is named by its number or its line") {
  CHECK(read_stl(binary_stl(block), "a.stl").place_of(4) == "a.stl, triangle 5");
  CHECK(read_stl(ascii_stl(block), "a.stl").place_of(1) == "a.stl, line 9");
}

TEST_CASE("a binary STL file of another length than it says is refused") {
  std::string const whole = binary_stl(block);
  CHECK_THROWS_WITH(read_stl(whole.substr(0, whole.size() - 1), "cut.stl"),
                    "cut.stl: it names 12 triangles, for which a binary STL file has 684 bytes, but it has 683");
  CHECK_THROWS_WITH(read_stl(whole + "x", "long.stl"), ContainsSubstring("684 bytes, but it has 685"));
  std::string many = whole;
  for (std::size_t k = 80; k < 84; ++k) many[k] = char(255);
  CHECK_THROWS_WITH(read_stl(many, "many.stl"), ContainsSubstring("4294967295 triangles"));
  CHECK_THROWS_WITH(read_stl(whole.substr(0, 83), "head.stl"), ContainsSubstring("83 bytes are no STL file"));
  CHECK_THROWS_WITH(read_stl("", "empty.stl"), ContainsSubstring("0 bytes"));
}

TEST_CASE("coordinates that are not finite are refused with their triangle or line") {
  Triangles broken = block;
  broken.vertices[7][1] = std::nan("");
  CHECK_THROWS_WITH(read_stl(binary_stl(broken), "a.stl"), "a.stl, triangle 3: a coordinate is not a finite number");
  std::string const good = ascii_stl(block);
  CHECK_THROWS_WITH(read_stl(replaced(good, "vertex 0", "vertex 1e999"), "a.stl"),
                    ContainsSubstring("a.stl, line 4: '1e999'"));
  CHECK_THROWS_WITH(read_stl(replaced(good, "vertex 0", "vertex inf"), "a.stl"),
                    ContainsSubstring("not a finite number"));
  CHECK_THROWS_WITH(read_stl(replaced(good, "vertex 0", "vertex 1,5"), "a.stl"),
                    ContainsSubstring("'1,5' is not a number"));
}

TEST_CASE("an ASCII STL file that breaks off or has other words is refused with its line") {
  std::string const good = ascii_stl(block);
  CHECK_THROWS_WITH(read_stl(replaced(good, "endloop", "endfacet"), "a.stl"),
                    "a.stl, line 7: 'endloop' is expected, not 'endfacet'");
  CHECK_THROWS_WITH(read_stl(replaced(good, "vertex 0 0 0", "vertex 0 0"), "a.stl"),
                    "a.stl, line 4: a vertex has three coordinates");
  CHECK_THROWS_WITH(read_stl(replaced(good, "facet", "polygon"), "a.stl"),
                    ContainsSubstring("line 2: 'facet' or 'endsolid'"));
  CHECK_THROWS_WITH(read_stl(good.substr(0, good.find("endsolid")), "a.stl"),
                    ContainsSubstring("'endsolid' is missing"));
  for (std::size_t length = 0; length < 400; ++length) {
    CAPTURE(length);
    CHECK_THROWS_AS(read_stl(good.substr(0, length), "a.stl"), std::runtime_error);
  }
}

TEST_CASE("a file is scaled, turned and moved, in this order") {
  Folder const folder;
  auto const file = folder.write("Block.STL", binary_stl(block));
  Placement const there{
      .scale = 1e-3, .rotation = rotation_about({0, 0, 2}, std::numbers::pi / 2), .translation = {1, 0, 0}};
  Mesh const mesh = read_mesh(file, there);
  CHECK((mesh.bounds().low - X3(1 - 2e-3, 0, 0)).norm() < 1e-15);
  CHECK((mesh.bounds().high - X3(1, 1e-3, 3e-3)).norm() < 1e-15);
  CHECK_THROWS_WITH(read_mesh(file, {.scale = 0}), ContainsSubstring("scale of a mesh must be above 0, not 0"));
  CHECK_THROWS_WITH(read_mesh(file, {.rotation = -Mat<3, double>::Identity()}),
                    ContainsSubstring("rotation of a mesh"));
  CHECK_THROWS_WITH(read_mesh(folder / "none.stl"), ContainsSubstring("No such file"));
  CHECK_THROWS_WITH(read_mesh(folder.path), ContainsSubstring("ends with .stl or .obj"));
  CHECK_THROWS_WITH(read_mesh(folder.write("a.ply", "")), ContainsSubstring("ends with .stl or .obj"));
}

}  // namespace scree::test::stl_tests
