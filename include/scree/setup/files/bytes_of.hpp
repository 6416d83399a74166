// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <string>

namespace scree::detail {

/// Returns the bytes of a file. Throws std::runtime_error, with the file and the reason, if the file cannot be read or
/// is larger than a quarter of the available memory.
std::string bytes_of(std::filesystem::path const& file);

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "bytes_of.ipp"
#endif
