// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

// Macros decide whether the cases of a program may be divided among ranks (docs/distributed.md): with SCREE_MPI, ranks
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

}  // namespace scree::app
