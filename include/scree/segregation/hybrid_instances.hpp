// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/over_lists.hpp"
#include "hybrid.hpp"

// The pair loops that the library scree::compiled has: those of hybrid segregation, and exact gradients of the fields
// that its rate depends on, for diagnostics.
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
