// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/text.hpp>

#include <algorithm>
#include <vector>

namespace scree::app {

std::string join(std::span<std::string const> texts, std::string_view between) {
  std::string all;
  for (auto const& text : texts) all += (&text == texts.data() ? "" : std::string(between)) + text;
  return all;
}

std::string shortened(std::string_view text, std::size_t most) {
  constexpr std::string_view between = "...";
  if (text.size() <= most) return std::string(text);
  auto const within_letter = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80; };
  std::size_t head = (most - between.size() + 1) / 2, tail = text.size() - (most - between.size()) / 2;
  while (head > 0 && within_letter(head)) --head;
  while (tail < text.size() && within_letter(tail)) ++tail;
  return std::string(text.substr(0, head)).append(between).append(text.substr(tail));
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      bool const swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string nearest(std::string_view word, std::span<std::string const> names) {
  constexpr std::size_t longest = 100;  // of a word that somebody may have meant to write
  std::string best;
  if (word.size() > longest) return best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (auto const& name : names) {
    auto const distance = edit_distance(word, name);
    if (distance < best_distance) best_distance = distance, best = name;
  }
  return best;
}

}  // namespace scree::app
