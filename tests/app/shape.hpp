// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <support/folder.hpp>

#include <scree/app/case_file.hpp>

/// A small program's options, with every type an option can have.
namespace shape {

using namespace scree::app;

enum class Colour { red, dark_blue };
constexpr auto names_of(Colour) { return Names<Colour, 2>{{{Colour::red, "red"}, {Colour::dark_blue, "dark-blue"}}}; }

struct Shape {
  double length = 0.25;
  int corners = 4;
  Colour colour = Colour::red;
  std::optional<double> angle = {};
};
struct Paint {
  bool glossy = true;
  std::string maker = "nobody";
  std::vector<double> layers = {1, 2.5};
};
struct Options {
  Shape shape;
  Paint paint;
};

inline Schema<Options> schema() {
  Schema<Options> all;
  all.section("shape", &Options::shape, "Its form")
      .add("length", &Shape::length, {.unit = "m", .range = above(0, 10), .meaning = "of an edge"})
      .add("corners", &Shape::corners, {.range = {3, 12}, .meaning = "how many"})
      .add("colour", &Shape::colour, {.meaning = "of its face"})
      .add("angle", &Shape::angle,
           {.unit = "rad", .range = {-1, 1}, .meaning = "of the first edge", .unset = "by corners"});
  all.section("paint", &Options::paint, "Its coat")
      .add("glossy", &Paint::glossy, {.meaning = "it shines"})
      .add("maker", &Paint::maker, {.meaning = "who made it"})
      .add("layers", &Paint::layers, {.unit = "mm", .range = {0, 9}, .meaning = "thickness of each layer"});
  all.require({"paint.layers", [](Options const& o) { return !o.paint.layers.empty(); }, "there must be one"});
  all.only_when({"shape.angle", [](Options const& o) { return o.shape.corners > 3; }, "has no effect on triangles"});
  return all;
}

// The case text read with overrides.
inline Case<Options> read(std::string const& text, std::vector<std::string> const& overrides = {}) {
  Folder const folder;
  return read_case(schema(), folder.write("case.toml", text), overrides);
}

}  // namespace shape
