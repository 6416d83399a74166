// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/models.hpp>
#include <scree/passes/limit.hpp>
#include <scree/passes/stage.hpp>

// From here on instances are made. Those of systems are in instances.cpp.
#undef SCREE_INSTANCE
#define SCREE_INSTANCE template
#include "loops.hpp"

namespace scree::detail {

#define SCREE_LOOPS(P) template auto all_loops<P>(DefaultLoops<P>*)
SCREE_FOR_DEFAULT_BASES(SCREE_LOOPS);

#ifdef SCREE_HAS_PACKS
#define SCREE_SUMS(P)                          \
  template auto all_sums<P>(GranularSums<P>*); \
  template auto all_sums<P>(SegregationSums<P>*)
SCREE_FOR_DEFAULT_BASES(SCREE_SUMS);
#endif

}  // namespace scree::detail
