// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "obj.hpp"
#include "obj_lines.hpp"

namespace scree {

SCREE_BODY Triangles read_obj(std::string_view text, std::string const& name) {
  Triangles result{.name = name, .numbered = "line"};
  result.vertices = detail::read_obj_lines(text, name, [&](detail::TextReader const& reader, auto const& vertices) {
    if (reader.word(0) != "f") return;
    detail::add_polygon(result, vertices, detail::obj_vertices(reader, vertices.size()), reader);
  });
  return result;
}

}  // namespace scree
