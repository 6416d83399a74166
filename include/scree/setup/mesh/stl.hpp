// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "triangles.hpp"

#include <string>
#include <string_view>

// A reader of STL files, ASCII and binary. The library has its own reader because it is short; the reader of another
// library would also need tests with files whose stated size is wrong.
namespace scree {

/// Returns the triangles in the bytes of an STL file; `name` is the name of the file. A file is binary if its length
/// fits the number of triangles that it states, whatever it starts with. Any other file is ASCII if it starts with
/// "solid". Throws std::runtime_error, with the file and the line or triangle, if the file does not follow the format
/// or a coordinate is not finite.
Triangles read_stl(std::string_view bytes, std::string const& name);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "stl.ipp"
#endif
