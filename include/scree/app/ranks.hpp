// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cases.hpp"
#include "schema.hpp"

#include <functional>
#include <string>
#include <utility>

namespace scree::app {

/// Returns the description of the option for the number of ranks of a case:
///     .add("ranks", &Numerics::ranks, app::about_ranks())
inline About about_ranks() {
  return {
      .range = {1, 64},
      .meaning = "ranks that the case is divided into, which share the threads; with mpirun they are its processes"};
}

inline namespace SCREE_CASES {
/// Rejects, at `key`, more than one rank in a program that is compiled without ranks.
template <class T>
void require_ranks(Schema<T>& schema, std::string key, std::function<int(T const&)> ranks) {
  schema.require({std::move(key), [ranks](T const& options) { return has_ranks || ranks(options) == 1; },
                  "this program is compiled for whole cases; configure it with -DSCREE_MPI=ON"});
}
}  // namespace SCREE_CASES

}  // namespace scree::app
