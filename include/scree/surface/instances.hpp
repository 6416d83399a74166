// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/over_lists.hpp"
#include "detect.hpp"

// The pair loops of surface_passes() that are compiled in the library scree::compiled.
#ifdef SCREE_COMPILED_LOOPS
namespace scree::detail {

template <class P>
using SurfaceLoops =
    LoopsOf<P,
            PairPass<Material, surface::Outer, StoreSums, Over<Material, AsIs, KernelSums<Material>>,
                     Over<Wall, AsIs, KernelSums<Wall>>>,
            PairPass<Material, surface::Outermost, surface::FindSurface,
                     Over<Material, AsIs, surface::Umbrella<Material>>, Over<Wall, AsIs, surface::Umbrella<Wall>>>,
            PairPass<Material, surface::Outer, surface::FindVicinity, Over<Material, AsIs, surface::FreeSurfaceSums>>>;

template <class P, class Loop>
requires is_default_basis<P> && is_listed_type<Loop, SurfaceLoops<P>>
struct is_compiled_loop<P, Loop> : std::true_type {
};

}  // namespace scree::detail
#endif
