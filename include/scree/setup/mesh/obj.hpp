// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "triangles.hpp"

#include <string>
#include <string_view>

// A reader of OBJ files (Wavefront). It reads vertices, polygons and lines; it skips materials and texture coordinates.
namespace scree {

/// Returns the triangles in the text of an OBJ file; `name` is the name of the file. Polygons of up to 1000 corners,
/// including concave ones, are cut into triangles; normals, texture coordinates, groups, materials and lines are
/// skipped. Throws std::runtime_error, with the file and the line, for everything that does not follow the format.
Triangles read_obj(std::string_view text, std::string const& name);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "obj.ipp"
#endif
