// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/describe.hpp>

#include <algorithm>

namespace scree::app {

namespace {

std::string markdown_row(std::vector<std::string> const& cells, std::vector<std::size_t> const& widths) {
  std::string line = "|";
  for (std::size_t c = 0; c < cells.size(); ++c) line += fmt::format(" {:<{}} |", cells[c], widths[c]);
  return line + "\n";
}

}  // namespace

std::string option_table(OptionList const& list, void const* standard) {
  std::vector<std::vector<std::string>> rows = {{"key", "unit", "default", "allowed", "meaning"}};
  for (auto const& option : list.options) {
    auto const& about = option.about;
    auto const value = option.text(standard);
    auto const unit = about.unit.empty() ? "1" : about.unit;
    auto allowed = option.allowed;
    if (auto const tail = detail::with_unit(about); !tail.empty()) allowed.resize(allowed.size() - tail.size());
    rows.push_back({option.key(), unit, value.empty() ? about.unset : value, allowed, about.meaning});
  }
  std::vector<std::size_t> widths(5, 3);
  for (auto const& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::vector<std::string> rule;
  for (auto const width : widths) rule.emplace_back(width, '-');
  rows.insert(rows.begin() + 1, rule);
  std::string table;
  for (auto const& row : rows) table += markdown_row(row, widths);
  return table;
}

std::string case_text(OptionList const& list, void const* options) {
  std::string text;
  for (auto const& [section, meaning] : list.sections) {
    text += fmt::format("{}# {}\n[{}]\n", text.empty() ? "" : "\n", meaning, section);
    for (auto const& option : list.options) {
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

}  // namespace scree::app
