// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

// How a case program is compiled decides whether its cases may be divided into parts (docs/distributed.md): with
// SCREE_MPI defined the parts are ranks of mpirun or threads, with SCREE_PARTS threads; without either a case is whole.
// What depends on it is in an inline namespace of that name: the files of a program may differ, and a linker would take
// functions and classes of one name for the same.
#ifdef SCREE_MPI
#define SCREE_PARTS
#define SCREE_CASES cases_on_ranks
#elif defined(SCREE_PARTS)
#define SCREE_CASES cases_on_threads
#else
#define SCREE_CASES whole_cases
#endif

namespace scree::app {

inline namespace SCREE_CASES {
/// Whether the program runs one case on several parts.
#ifdef SCREE_PARTS
inline constexpr bool has_parts = true;
#else
inline constexpr bool has_parts = false;
#endif
}  // namespace SCREE_CASES

/// The option that tells how many parts a case has:
///     .add("parts", &Numerics::parts, app::about_parts())
inline About about_parts() {
  return {.range = {1, 64},
          .meaning = "parts that the case is divided into, which share the threads; with mpirun they are its ranks"};
}

inline namespace SCREE_CASES {
/// Refuses, at `key`, more than one part in a program that is compiled without parts.
template <class T>
void require_parts(Schema<T>& schema, std::string key, std::function<int(T const&)> parts) {
  schema.require({std::move(key), [parts](T const& options) { return has_parts || parts(options) == 1; },
                  "this program is compiled for whole cases; configure it with -DSCREE_MPI=ON"});
}
}  // namespace SCREE_CASES

}  // namespace scree::app
