// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

// How a case program is compiled decides whether its cases may be divided into ranks (docs/distributed.md): with
// SCREE_MPI defined the ranks are processes of mpirun or threads, with SCREE_RANKS threads; without either a case is
// whole. Everything that depends on it is in an inline namespace of that name: the files of a program may differ in it,
// and a linker would otherwise merge functions and classes of the same name.
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

/// The option that tells how many ranks a case has:
///     .add("ranks", &Numerics::ranks, app::about_ranks())
inline About about_ranks() {
  return {
      .range = {1, 64},
      .meaning = "ranks that the case is divided into, which share the threads; with mpirun they are its processes"};
}

inline namespace SCREE_CASES {
/// Refuses, at `key`, more than one rank in a program that is compiled without ranks.
template <class T>
void require_ranks(Schema<T>& schema, std::string key, std::function<int(T const&)> ranks) {
  schema.require({std::move(key), [ranks](T const& options) { return has_ranks || ranks(options) == 1; },
                  "this program is compiled for whole cases; configure it with -DSCREE_MPI=ON"});
}
}  // namespace SCREE_CASES

}  // namespace scree::app
