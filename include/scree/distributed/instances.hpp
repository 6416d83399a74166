// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../system/instances.hpp"
#include "other_ranks.hpp"

// The template instances for cases on several ranks in the library scree::compiled; see also system/instances.hpp.
#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P)                                                                                             \
  SCREE_INSTANCE class scree::CellList<P, scree::ByPosition>;                                                          \
  SCREE_INSTANCE class scree::detail::ListInRows<P, scree::detail::CandidateRows<P, std::uint32_t>,                    \
                                                 scree::ByPosition>;                                                   \
  SCREE_INSTANCE class scree::detail::ListInRows<P, scree::detail::NumberedRows<P, std::uint32_t>, scree::ByPosition>; \
  SCREE_INSTANCE class scree::Searches<P, scree::ReproducibleList<P>>;                                                 \
  SCREE_INSTANCE class scree::Exchange<P>;                                                                             \
  SCREE_INSTANCE class scree::detail::SharedByBodies<P>;                                                               \
  SCREE_INSTANCE class scree::detail::Migration<P>;                                                                    \
  SCREE_INSTANCE class scree::OtherRanks<P>;                                                                           \
  SCREE_INSTANCE class scree::detail::Neighbourhood<P, scree::ReproducibleList<P>, scree::OtherRanks<P>>

SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);

#undef SCREE_INSTANCES
#endif
