// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../files/text_reader.hpp"
#include "ear_clipping.hpp"
#include "triangles.hpp"

#include <algorithm>
#include <string_view>

// Lines of OBJ files, for meshes and polygons.
namespace scree::detail {

inline constexpr std::size_t most_corners = 1000;  // of a polygon

/// Returns the vertices that a line "f ..." or "l ..." names, as places from 0. Each word of the line has the number of
/// a vertex before its first slash, counted from 1 or, if negative, back from the last vertex so far.
inline std::vector<int> obj_vertices(TextReader const& reader, std::size_t vertices) {
  std::vector<int> result;
  for (std::size_t k = 1; k < reader.words().size(); ++k) {
    auto const word = reader.word(k).substr(0, reader.word(k).find('/'));
    TextReader single(word, "");
    long number = 0;
    try {
      if (single.next()) number = single.integer(0);
    } catch (std::runtime_error const&) {
    }
    long const count = long(vertices), place = number < 0 ? count + number : number - 1;
    if (number == 0 || place < 0 || place >= count)
      reader.fail("'" + std::string(reader.word(k).substr(0, 40)) + "' is none of the " + std::to_string(count) +
                  " vertices so far");
    result.push_back(int(place));
  }
  return result;
}

inline Vec<3, double> obj_vertex(TextReader const& reader) {
  std::size_t const count = reader.words().size();
  reader.demand(count == 4 || count == 5 || count == 7 || count == 8,
                "a vertex has three coordinates, and a weight or a colour behind them");
  return {reader.number(1), reader.number(2), reader.number(3)};
}

/// Adds the triangles of the polygon whose corners are the vertices at these places.
inline void add_polygon(Triangles& to, std::vector<Vec<3, double>> const& vertices, std::vector<int> const& places,
                        TextReader const& reader) {
  reader.demand(places.size() >= 3, "a polygon has three corners or more");
  reader.demand(places.size() <= most_corners, "a polygon with more than 1000 corners is not read");
  std::vector<Vec<3, double>> polygon;
  for (int const place : places) polygon.push_back(vertices[std::size_t(place)]);
  auto const triangles = clip_ears(polygon);
  reader.demand(triangles.size() + 2 == places.size(), "this polygon crosses itself");
  for (auto const& [a, b, c] : triangles) {
    to.corners.push_back({places[a], places[b], places[c]});
    to.numbers.push_back(reader.line());
  }
}

/// Whether a line of an OBJ file that is not a vertex is accepted: polygons ("f"), lines ("l"), comments, and
/// statements that have nothing to do with the geometry.
inline bool is_skipped_obj(std::string_view word) {
  static constexpr std::string_view skipped[] = {
      "vn",       "vt",     "vp",     "o",        "g",   "s",    "mg",  "usemtl", "mtllib",     "p",         "bevel",
      "c_interp", "maplib", "usemap", "d_interp", "lod", "call", "csh", "l",      "shadow_obj", "trace_obj", "f"};
  return word[0] == '#' || std::find(std::begin(skipped), std::end(skipped), word) != std::end(skipped);
}

/// Calls visit(reader, vertices so far) at each line of an OBJ file that is not a vertex, and returns the vertices.
template <class Visit>
std::vector<Vec<3, double>> read_obj_lines(std::string_view text, std::string const& name, Visit const& visit) {
  std::vector<Vec<3, double>> vertices;
  TextReader reader(text, name);
  while (reader.next(true)) {
    if (reader.word(0) == "v") {
      check_vertices(name, double(vertices.size()) + 1);
      vertices.push_back(obj_vertex(reader));
    } else if (!is_skipped_obj(reader.word(0))) {
      reader.fail("'" + std::string(reader.word(0).substr(0, 40)) +
                  "' is not read: only vertices, polygons and lines are");
    } else {
      visit(reader, vertices);
    }
  }
  return vertices;
}

}  // namespace scree::detail
