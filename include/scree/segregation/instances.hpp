// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../passes/over_lists.hpp"
#include "conservative.hpp"

// Sums over neighbours that are compiled into the library scree::compiled: those of conservative segregation.
#if defined(SCREE_COMPILED_LOOPS) && defined(SCREE_HAS_PACKS)
namespace scree::detail {

template <class P>
using SegregationSums = Tuple<OfMaterial<P, pair_weights::DisorderSums>, OfWall<P, AsIs, pair_weights::DisorderSums>,
                              OfMaterial<P, pair_weights::FourthMomentSum>, OfMaterial<P, PairTransport>>;

template <class P, class Source>
requires is_default_basis<P> && is_listed_type<Source, SegregationSums<P>>
inline constexpr bool is_compiled_sum<P, Source> = true;

}  // namespace scree::detail
#endif
