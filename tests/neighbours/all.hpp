// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <support/policies.hpp>

#include <scree/neighbours/brute_force.hpp>
#include <scree/neighbours/cell_list.hpp>
#include <scree/neighbours/verlet_list.hpp>

#include <tuple>

namespace scree::test {

/// Every search under a policy: add a new one here to test it.
template <class P>
using Searches = std::tuple<BruteForce<P>, CellList<P>, VerletList<P>, ReproducibleList<P>>;
/// Searches that read the sources' positions when they are built.
template <class P>
using BuiltSearches = std::tuple<CellList<P>, VerletList<P>, ReproducibleList<P>>;

/// Calls f.template operator()<Search>() for each search of a list.
template <class F, class... Ss>
void for_each_search(std::tuple<Ss...>*, F const& f) {
  (f.template operator()<Ss>(), ...);
}

}  // namespace scree::test
