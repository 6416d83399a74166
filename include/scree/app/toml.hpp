// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "value.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// Implemented in toml.cpp, which is compiled by the host compiler, because nvcc does not compile toml++ 3.3.

namespace scree::app {

/// Returns the sections of a TOML text in the order of its lines. `source` is the name of the text in positions. Throws
/// Problem if the text is not valid TOML, for instance because of duplicate keys.
std::vector<Section> parse_toml(std::string_view text, std::string const& source);

/// Returns the sections of a TOML file in the order of its lines. Throws Problem as parse_toml() does, and if the file
/// cannot be read.
std::vector<Section> read_toml_file(std::filesystem::path const& file);

/// Returns the section with the entry of a text "section.key=value" from the command line. A value that is not TOML is
/// taken as text, so that names need no quotes inside the quotes of the shell. `source` is the command-line option, for
/// messages. Throws Problem if the dot or the equals sign is missing.
Section parse_override(std::string const& text, std::string const& source = "--set");

}  // namespace scree::app
