// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree::app {

/// "a, b, c", with anything in place of the comma.
std::string join(std::span<std::string const> texts, std::string_view between = ", ");

/// Returns a text of at most `most` bytes. A longer text is cut in its middle, which becomes "...".
std::string shortened(std::string_view text, std::size_t most = 80);

/// Number of letters to insert, remove, replace or swap with a neighbour to get from one word to the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that was probably meant, or nothing if none is within a third of the word's length.
std::string nearest(std::string_view word, std::span<std::string const> names);

}  // namespace scree::app
