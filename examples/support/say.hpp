// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace support {

/// Prints words for a person. A stream that cannot be written, as a full disk or a closed pipe, loses them; no run
/// stops for that.
template <class... Args>
void say(std::FILE* stream, fmt::format_string<Args...> format, Args&&... args) {
  std::fputs(fmt::format(format, std::forward<Args>(args)...).c_str(), stream);
}

/// A text as one line for a terminal: control characters as \x1b, and no longer than 2000 characters.
inline std::string printable(std::string_view text) {
  constexpr std::size_t longest = 2000;
  std::string line;
  for (char const c : text.substr(0, longest)) {
    auto const code = static_cast<unsigned char>(c);
    if (code < 32 || code == 127)
      line += fmt::format("\\x{:02x}", code);
    else
      line += c;
  }
  if (text.size() > longest) line += fmt::format("... ({} characters more)", text.size() - longest);
  return line;
}

}  // namespace support
