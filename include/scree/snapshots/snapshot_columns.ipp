// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "snapshot_columns.hpp"

#include <cxxabi.h>

#include <cstdlib>

namespace scree::detail {

SCREE_BODY std::vector<SnapshotArray> heads_of(std::string const& body, std::vector<ColumnHead> const& columns) {
  std::map<std::string, int> times;
  std::vector<SnapshotArray> heads;
  for (ColumnHead const& column : columns) {
    std::string name = body + "/" + std::string(column.prefix) + std::string(column.name);
    int const number = ++times[name];
    if (number > 1) name += " (" + std::to_string(number) + ")";
    heads.push_back({std::move(name), std::string(column.unit), column.element, column.components, {}});
  }
  return heads;
}

SCREE_BODY std::string name_of_class(std::type_info const& type) {
  char* const readable = abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr);
  std::string const whole = readable == nullptr ? type.name() : readable, own = "scree::";
  std::free(readable);
  std::string const short_name = whole.substr(0, whole.find('<'));
  bool const is_own = short_name.starts_with(own) && short_name.find("::", own.size()) == std::string::npos;
  return is_own ? short_name.substr(own.size()) : whole;
}

}  // namespace scree::detail
