// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/say.hpp>

#include <scree/app/text.hpp>
#include <scree/core/writes_files.hpp>

namespace scree::app {

std::string printable(std::string_view text) {
  constexpr std::size_t longest_word = 240, longest = 1000;
  std::string line, word;
  auto const end_word = [&] {
    line += word.size() > longest_word ? shortened(word) : word;
    word.clear();
  };
  for (char const c : text) {
    auto const code = static_cast<unsigned char>(c);
    if (code < 32 || code == 127)
      word += fmt::format("\\x{:02x}", code);
    else
      word += c;
    if (c == ' ') end_word();
  }
  end_word();
  return shortened(line, longest);
}

void print_note(std::string_view note) {
  if (writes_files()) say(stderr, "note: {}\n", printable(note));
}

}  // namespace scree::app
