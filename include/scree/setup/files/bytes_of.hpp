// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <string>

namespace scree::detail {

/// The bytes of a file. Throws std::runtime_error with the file and the reason if it cannot be read, or if it is larger
/// than a fourth of the memory that is available.
std::string bytes_of(std::filesystem::path const& file);

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "bytes_of.ipp"
#endif
