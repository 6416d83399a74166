// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/schema.hpp>

namespace scree::app {

Option const* OptionList::find(std::string const& section, std::string const& name) const {
  auto const earlier = renamed.find(section + "." + name);
  for (auto const& option : options) {
    bool const is_it = option.section == section && option.name == name;
    if (is_it || (earlier != renamed.end() && option.key() == earlier->second)) return &option;
  }
  return nullptr;
}

std::vector<std::string> OptionList::section_names() const {
  std::vector<std::string> names;
  for (auto const& section : sections) names.push_back(section.first);
  return names;
}

std::vector<std::string> OptionList::names_in(std::string const& section) const {
  std::vector<std::string> names;
  for (auto const& option : options)
    if (option.section == section) names.push_back(option.name);
  return names;
}

}  // namespace scree::app
