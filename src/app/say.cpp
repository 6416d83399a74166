// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/say.hpp>

#include <scree/core/this_part.hpp>

namespace scree::app {

std::string printable(std::string_view text) {
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

void print_note(std::string_view note) {
  if (writes_files()) say(stderr, "note: {}\n", printable(note));
}

}  // namespace scree::app
