// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../files/bytes_of.hpp"
#include "mesh.hpp"
#include "obj.hpp"
#include "placement.hpp"
#include "stl.hpp"

#include <cctype>
#include <filesystem>

namespace scree {

/// Triangles from a file that ends with .stl or .obj. Throws std::runtime_error with the file and the place if it
/// cannot be read.
inline Triangles read_triangles(std::filesystem::path const& file) {
  std::string const name = file.filename().string();
  std::string ending = file.extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".stl") return read_stl(detail::bytes_of(file), name);
  if (ending == ".obj") return read_obj(detail::bytes_of(file), name);
  throw std::runtime_error(file.string() + ": a mesh is read from a file that ends with .stl or .obj");
}

/// A body from an STL or OBJ file:
///
///     Mesh const vessel = read_mesh("vessel.stl", {.scale = 1e-3});  // drawn in mm
///     fmt::print("{}", vessel.report().text(dr));
inline Mesh read_mesh(std::filesystem::path const& file, Placement const& placement = {}) {
  return Mesh(placed(read_triangles(file), placement));
}

}  // namespace scree
