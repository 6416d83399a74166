// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"

#include <string_view>

namespace scree::detail {

/// A pass as a value, whatever its types: a name, the columns that it needs of ghosts and those that it changes, and a
/// function with its loops. Arrays of columns have an element for each body of the system. The value refers to a pass,
/// which must outlive it.
struct AnyPass {
  std::string_view label = {};                     // for profilers; empty: the pass names itself
  bool active = true;                              // the pass runs
  ColumnNumbers const* reads_of_ghosts = nullptr;  // none: the pass refreshes ghosts itself
  ColumnNumbers const* changes = nullptr;          // none: any columns
  bool moves = false;                              // positions change
  void (*loops)(void const* pass, void* system) = nullptr;
  void const* pass = nullptr;
};

}  // namespace scree::detail
