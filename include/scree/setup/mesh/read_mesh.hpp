// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "mesh.hpp"
#include "obj.hpp"
#include "placement.hpp"
#include "stl.hpp"

#include <filesystem>

namespace scree {

/// Returns the triangles of a file that ends with .stl or .obj. Throws std::runtime_error, with the file and the place,
/// if the file cannot be read.
Triangles read_triangles(std::filesystem::path const& file);

/// Returns the body in an STL or OBJ file:
///
///     Mesh const vessel = read_mesh("vessel.stl", {.scale = 1e-3});  // drawn in mm
///     fmt::print("{}", vessel.report().text(dr));
///
/// Throws as read_triangles(), Placement::check() and the constructor of Mesh do.
Mesh read_mesh(std::filesystem::path const& file, Placement const& placement = {});

}  // namespace scree

#ifndef SCREE_COMPILED
#include "read_mesh.ipp"
#endif
