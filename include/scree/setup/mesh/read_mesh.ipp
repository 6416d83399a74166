// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "../files/bytes_of.hpp"
#include "read_mesh.hpp"

#include <cctype>

namespace scree {

SCREE_BODY Triangles read_triangles(std::filesystem::path const& file) {
  std::string const name = file.filename().string();
  std::string ending = file.extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".stl") return read_stl(detail::bytes_of(file), name);
  if (ending == ".obj") return read_obj(detail::bytes_of(file), name);
  throw std::runtime_error(file.string() + ": a mesh is read from a file that ends with .stl or .obj");
}

SCREE_BODY Mesh read_mesh(std::filesystem::path const& file, Placement const& placement) {
  return Mesh(placed(read_triangles(file), placement));
}

}  // namespace scree
