// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree::app {

/// Returns texts joined as in "a, b, c", with any text in place of the comma.
std::string join(std::span<std::string const> texts, std::string_view between = ", ");

/// Returns a text of at most `most` bytes. In a longer text, "..." replaces the middle.
std::string shortened(std::string_view text, std::size_t most = 80);

/// Returns the number of letters to insert, remove, replace or swap with the next letter to turn one word into the
/// other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the name that was probably meant, or an empty text if no name is within an edit distance of a third of the
/// length of the word.
std::string nearest(std::string_view word, std::span<std::string const> names);

}  // namespace scree::app
