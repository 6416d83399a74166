// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

// Macros decide whether the cases of a program may be divided into ranks (docs/distributed.md): with SCREE_MPI, ranks
// are processes of mpirun or threads; with SCREE_RANKS, ranks are threads; without either, cases are not divided.
// Everything that depends on this choice is in the inline namespace SCREE_CASES, because the source files of a program
// may differ in their choice, and a linker would otherwise merge functions and classes of the same name.
#ifdef SCREE_MPI
#define SCREE_RANKS
#define SCREE_CASES cases_on_mpi
#elif defined(SCREE_RANKS)
#define SCREE_CASES cases_on_threads
#else
#define SCREE_CASES whole_cases
#endif

namespace scree::app {

inline namespace SCREE_CASES {
/// Whether the program runs one case on several ranks.
#ifdef SCREE_RANKS
inline constexpr bool has_ranks = true;
#else
inline constexpr bool has_ranks = false;
#endif
}  // namespace SCREE_CASES

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
