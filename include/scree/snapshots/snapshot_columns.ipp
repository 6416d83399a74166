// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "snapshot_columns.hpp"

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

}  // namespace scree::detail
