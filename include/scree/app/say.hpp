// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace scree::app {

/// Prints text for the user. If the stream cannot be written (full disk, closed pipe), the text is lost and the run
/// continues.
template <class... Args>
void say(std::FILE* stream, fmt::format_string<Args...> format, Args&&... args) {
  std::fputs(fmt::format(format, std::forward<Args>(args)...).c_str(), stream);
}

/// Returns a text as one line for a terminal: control characters are written as \x1b, words of more than 240 bytes are
/// shortened to 80 bytes, and the whole line is shortened to 1000 bytes.
std::string printable(std::string_view text);

/// Prints "note: ..." on the standard error stream of the first rank.
void print_note(std::string_view note);

}  // namespace scree::app
