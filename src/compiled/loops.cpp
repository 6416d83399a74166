// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/models.hpp>
#include <scree/passes/limit.hpp>
#include <scree/passes/stage.hpp>

#ifdef __AVX__
#error "loops.cpp of scree::compiled must be compiled without AVX: with -mno-avx"
#endif

// From here on instances are made. Those of systems are in instances.cpp.
#undef SCREE_INSTANCE
#define SCREE_INSTANCE template
#include <scree/granular/granular.hpp>
#include <scree/segregation/conservative.hpp>

namespace scree::detail {

template <class P, class Loop>
void run_compiled_loop(typename P::space const& space, PassLabel const& label, Loop const& loop) {
  run_loop<P>(space, label, loop);
}
template <class P, class... Loops>
constexpr auto all_loops(Tuple<Loops...>*) {
  return Tuple(&run_compiled_loop<P, Loops>...);
}
#define SCREE_LOOPS(P) template auto all_loops<P>(DefaultLoops<P>*)
SCREE_FOR_DEFAULT_BASES(SCREE_LOOPS);

#ifdef SCREE_HAS_PACKS
template <class P, class Source>
void run_compiled_sum(SumInPacks<P, Source> const& sum, int* j, int count) {
  run_sum(sum, j, count);
}
template <class P, class... Sources>
constexpr auto all_sums(Tuple<Sources...>*) {
  return Tuple(&run_compiled_sum<P, Sources>...);
}
#define SCREE_SUMS(P)                          \
  template auto all_sums<P>(GranularSums<P>*); \
  template auto all_sums<P>(SegregationSums<P>*)
SCREE_FOR_DEFAULT_BASES(SCREE_SUMS);
#endif

}  // namespace scree::detail
