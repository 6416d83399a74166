// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "loops.hpp"

#include <scree/segregation/hybrid.hpp>

namespace scree::detail {

#define SCREE_LOOPS(P)                                   \
  template auto all_loops<P>(LoopsBesideAdamiWalls<P>*); \
  template auto all_loops<P>(AdamiLoops<P>*);            \
  template auto all_loops<P>(SurfaceLoops<P>*);          \
  template auto all_loops<P>(HybridLoops<P>*)
SCREE_FOR_DEFAULT_BASES(SCREE_LOOPS);

}  // namespace scree::detail
