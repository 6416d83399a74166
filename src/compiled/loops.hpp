// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#ifdef __AVX__
#error "loops of scree::compiled must be compiled without AVX: with -mno-avx"
#endif

#include <scree/granular/granular.hpp>
#include <scree/segregation/conservative.hpp>

// Instances of the functions behind loops and sums, for lists of their types.
namespace scree::detail {

template <class P, class Loop>
void run_compiled_loop(typename P::space const& space, PassLabel const& label, Loop const& loop) {
  run_loop<P>(space, label, loop);
}
template <class P, class... Loops>
constexpr auto all_loops(Tuple<Loops...>*) {
  return Tuple(&run_compiled_loop<P, Loops>...);
}

#ifdef SCREE_HAS_PACKS
template <class P, class Source>
void run_compiled_sum(SumInPacks<P, Source> const& sum, int* j, int count) {
  run_sum(sum, j, count);
}
template <class P, class... Sources>
constexpr auto all_sums(Tuple<Sources...>*) {
  return Tuple(&run_compiled_sum<P, Sources>...);
}
#endif

}  // namespace scree::detail
