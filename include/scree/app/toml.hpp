// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "value.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// Implemented in toml.cpp, which the host compiler compiles: toml++ 3.3 does not pass through nvcc.

namespace scree::app {

/// The sections of a TOML text in the order of its lines. `source` names it in positions.
/// Throws Problem for a text that is not TOML, including duplicate keys.
std::vector<Section> parse_toml(std::string_view text, std::string const& source);

/// The sections of a TOML file in the order of its lines. Throws Problem as parse_toml() does, and if the file cannot
/// be read.
std::vector<Section> read_toml_file(std::filesystem::path const& file);

/// "section.key=value" from the command line. The value is TOML; otherwise it is taken as text, so that names need no
/// quotes within the shell's. `source` is the option of the command line, for messages.
/// Throws Problem without a dot or an equals sign.
Section parse_override(std::string const& text, std::string const& source = "--set");

}  // namespace scree::app
