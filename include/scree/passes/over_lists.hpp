// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../kernels/default_bases.hpp"
#include "../neighbours/verlet_list.hpp"
#include "fuse.hpp"
#include "pass.hpp"

#include <type_traits>
#include <utility>

// Names for the lists of the loops and sums in the library scree::compiled. The compiler evaluates a list only if a
// program runs a loop, and only for the basis of the loop. The library is built without AVX, so a program built with
// AVX compiles all loops itself, with wider packs.
#if defined(SCREE_COMPILED) && !defined(__AVX__)
#define SCREE_COMPILED_LOOPS
namespace scree::detail {

/// The source of a loop that sums over one body with neighbour lists.
template <class P, class Target, class Over>
struct source_in_lists;
template <class P, class Target, class Body, class Lens, class... Terms>
struct source_in_lists<P, Target, Over<Body, Lens, Terms...>> {
  using Own = VerletList<P>;
  using List = std::conditional_t<std::is_same_v<Target, Body>, Own, typename Own::OfOthers>;
  using type = Source<P, decltype(std::declval<List const&>().view()), Lens, Terms...>;
};
/// The source of sums for material particles over neighbours in the material.
template <class P, class... Terms>
using OfMaterial = typename source_in_lists<P, Material, Over<Material, AsIs, Terms...>>::type;
/// The source of sums for material particles over neighbours in the walls.
template <class P, class Lens, class... Terms>
using OfWall = typename source_in_lists<P, Material, Over<Wall, Lens, Terms...>>::type;
/// The source of sums for wall particles over neighbours in the material.
template <class P, class... Terms>
using AtWall = typename source_in_lists<P, Wall, Over<Material, AsIs, Terms...>>::type;

/// The loop of a pair pass with neighbour lists, in a system with exactly one body for each name in the pass.
template <class P, class Pass>
struct loop_over_lists;
template <class P, class Target, class Where, class Then, class... Overs>
struct loop_over_lists<P, PairPass<Target, Where, Then, Overs...>> {
  using type = PairLoopOver<P, Where, Then, typename source_in_lists<P, Target, Overs>::type...>;
};
/// The loops of several pair passes with neighbour lists.
template <class P, class Passes>
struct loops_over_lists;
template <class P, class... Passes>
struct loops_over_lists<P, Tuple<Passes...>> {
  using type = Tuple<typename loop_over_lists<P, Passes>::type...>;
};
template <class P, class... Passes>
using LoopsOf = typename loops_over_lists<P, Tuple<Passes...>>::type;

template <class T, class List>
inline constexpr bool is_listed_type = false;
template <class T, class... Ts>
inline constexpr bool is_listed_type<T, Tuple<Ts...>> = is_one_of<T, Ts...>;

}  // namespace scree::detail
#endif
