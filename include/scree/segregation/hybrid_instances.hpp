// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/over_lists.hpp"
#include "hybrid.hpp"

// Pair loops that are compiled into the library scree::compiled: those of hybrid segregation and, for diagnostics,
// those of the consistent gradients of the fields on which its rate depends.
#ifdef SCREE_COMPILED_LOOPS
namespace scree::detail {

template <class Where, class Then, class F>
using PassWithGradient =
    PairPass<Material, Where, Then, Over<Material, AsIs, ConsistencyMatrixSum, ConsistencyVectorSum<F>>>;
template <class P>
using HybridLoops =
    LoopsOf<P, PassWithGradient<hybrid::NearBoundary, hybrid::BoundaryFlux, SegregationFluxValue>,
            PassWithGradient<Everywhere, ConsistentGradient<Concentration>, Concentration>,
            PassWithGradient<Everywhere, ConsistentGradient<SegregationVelocity>, SegregationVelocity>,
            PairPass<Material, Everywhere, hybrid::AddBoundaryRate, Over<Material, AsIs, hybrid::InteriorTransport>>>;

template <class P, class Loop>
requires is_default_basis<P> && is_listed_type<Loop, HybridLoops<P>>
struct is_compiled_loop<P, Loop> : std::true_type {
};

}  // namespace scree::detail
#endif
