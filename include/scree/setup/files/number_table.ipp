// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "number_table.hpp"

namespace scree::detail {

SCREE_BODY std::string_view trimmed(std::string_view text) {
  static constexpr std::string_view blanks = " \t\v\f\r";
  std::size_t const from = text.find_first_not_of(blanks);
  return from == text.npos ? std::string_view() : text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

SCREE_BODY std::vector<std::string_view> split_at(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0;;) {
    std::size_t const to = line.find(separator, from);
    parts.push_back(trimmed(line.substr(from, to == line.npos ? to : to - from)));
    if (to == line.npos) return parts;
    from = to + 1;
  }
}

SCREE_BODY NumberTable read_numbers(std::string_view text, std::string const& name,
                                    std::vector<std::string> const& units) {
  NumberTable table{name};
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  auto const number_in = [](std::string_view word, double& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size();
  };
  bool at_start = true;
  for (int line = 1; !text.empty(); ++line) {
    std::size_t const end = std::min(text.find('\n'), text.size());
    std::string_view const content = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (content.empty() || content[0] == '#') continue;
    auto const words = split_at(content, ',');
    double value = 0;
    bool const is_head =
        at_start && std::none_of(words.begin(), words.end(), [&](auto word) { return number_in(word, value); });
    at_start = false;
    if (words.size() != units.size())
      table.fail_at(line, std::min(words.size(), units.size()),
                    "there are " + std::to_string(words.size()) + " columns of " + std::to_string(units.size()) +
                        ", which commas separate");
    std::vector<double> row;
    for (std::size_t k = 0; k < words.size(); ++k) {
      std::string const word(words[k].substr(0, 40));
      if (is_head) {
        std::size_t const from = words[k].find_first_of("[(");
        if (from == std::string_view::npos) continue;
        auto const unit = trimmed(words[k].substr(from + 1, words[k].find_first_of("])", from) - from - 1));
        if (unit != units[k]) table.fail_at(line, k, "the unit of '" + word + "' must be " + units[k]);
        continue;
      }
      if (!number_in(words[k], value)) table.fail_at(line, k, "'" + word + "' is not a number");
      if (!std::isfinite(value)) table.fail_at(line, k, "'" + word + "' is not a finite number");
      row.push_back(value);
    }
    if (is_head) continue;
    table.rows.push_back(row);
    table.lines.push_back(line);
  }
  return table;
}

}  // namespace scree::detail
