// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/over_lists.hpp"
#include "adami.hpp"

// The pair loops of AdamiWalls that are compiled in the library scree::compiled, separately and fused into one sweep.
#ifdef SCREE_COMPILED_LOOPS
namespace scree::detail {

using StressOfAdamiWalls = adami::ExtrapolateStress<UniformDensity>;
template <class P>
using AdamiLoops = LoopsOf<
    P,
    PairPass<Wall, Everywhere, adami::ExtrapolateVelocity,
             Over<Material, AsIs, adami::Weights, adami::Weighted<Velocity>>>,
    PairPass<Wall, Everywhere, StressOfAdamiWalls, Over<Material, AsIs, adami::Weights, adami::Weighted<Stress>>>,
    PairPass<Wall, Everywhere, Together<adami::ExtrapolateVelocity, StressOfAdamiWalls>,
             Over<Material, AsIs, adami::Weights, adami::Weighted<Velocity>, adami::Weighted<Stress>>>>;

template <class P, class Loop>
requires is_default_basis<P> && is_listed_type<Loop, AdamiLoops<P>>
struct is_compiled_loop<P, Loop> : std::true_type {
};

}  // namespace scree::detail
#endif
