// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/over_lists.hpp"
#include "conservative.hpp"

// The sums over neighbours that the library scree::compiled has: those of conservative segregation.
#if defined(SCREE_COMPILED_LOOPS) && defined(SCREE_HAS_PACKS)
#define SCREE_SUMS(P)                                         \
  namespace scree::detail {                                   \
  SCREE_SUM(P, OfMaterial<P, pair_weights::DisorderSums>);    \
  SCREE_SUM(P, OfWall<P, AsIs, pair_weights::DisorderSums>);  \
  SCREE_SUM(P, OfMaterial<P, pair_weights::FourthMomentSum>); \
  SCREE_SUM(P, OfMaterial<P, PairTransport>);                 \
  }
SCREE_FOR_DEFAULT_BASES(SCREE_SUMS)
#undef SCREE_SUMS
#endif
