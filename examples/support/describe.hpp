// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

#include <fmt/format.h>

namespace support {

namespace detail {

inline std::string markdown_row(std::span<std::string const> cells, std::span<std::size_t const> widths) {
  std::string line = "|";
  for (std::size_t c = 0; c < cells.size(); ++c) line += fmt::format(" {:<{}} |", cells[c], widths[c]);
  return line + "\n";
}

}  // namespace detail

/// The table of all options in Markdown: key, unit, default, what is allowed, meaning.
template <class T>
std::string option_table(Schema<T> const& schema) {
  std::vector<std::vector<std::string>> rows = {{"key", "unit", "default", "allowed", "meaning"}};
  for (auto const& option : schema.options()) {
    auto about = option.about;
    auto const standard = option.text(T{});
    auto const unit = about.unit.empty() ? "1" : about.unit;
    auto allowed = option.allowed;
    if (auto const tail = detail::with_unit(about); !tail.empty()) allowed.resize(allowed.size() - tail.size());
    rows.push_back({option.key(), unit, standard.empty() ? about.unset : standard, allowed, about.meaning});
  }
  std::vector<std::size_t> widths(5, 3);
  for (auto const& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::vector<std::string> rule;
  for (auto const width : widths) rule.emplace_back(width, '-');
  rows.insert(rows.begin() + 1, rule);
  std::string table;
  for (auto const& row : rows) table += detail::markdown_row(row, widths);
  return table;
}

/// The options as a commented case file, which read_case() reads back to the same options.
template <class T>
std::string case_text(Schema<T> const& schema, T const& options) {
  std::string text;
  for (auto const& [section, meaning] : schema.sections()) {
    text += fmt::format("{}# {}\n[{}]\n", text.empty() ? "" : "\n", meaning, section);
    for (auto const& option : schema.options()) {
      if (option.section != section) continue;
      text += fmt::format("# {}; {}\n", option.about.meaning, option.allowed);
      auto const value = option.text(options);
      if (value.empty())
        text += fmt::format("# {} =   # not given: {}\n", option.name, option.about.unset);
      else
        text += fmt::format("{} = {}\n", option.name, value);
    }
  }
  return text;
}

}  // namespace support
