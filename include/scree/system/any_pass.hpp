// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"

#include <string_view>

namespace scree::detail {

/// A type-erased pass: a name, the columns of ghosts that the pass reads, the columns that it changes, and a function
/// that runs its loops. Arrays of columns have one element for each body of the system. The value refers to a pass,
/// which must outlive the value.
struct AnyPass {
  std::string_view label = {};                     // name for profilers; empty if the pass names itself
  bool active = true;                              // whether the pass runs
  ColumnNumbers const* reads_of_ghosts = nullptr;  // nullptr if the pass refreshes ghosts itself
  ColumnNumbers const* changes = nullptr;          // nullptr if the pass may change any column
  bool moves = false;                              // whether positions change
  void (*loops)(void const* pass, void* system) = nullptr;
  void const* pass = nullptr;
};

}  // namespace scree::detail
