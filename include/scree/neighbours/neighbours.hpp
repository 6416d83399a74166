// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/array.hpp"
#include "../fields/standard.hpp"
#include "lanes.hpp"

#include <concepts>

namespace scree {

/// The positions that a search reads.
template <class P>
using Positions = Array<P, Vec<P::dim, typename P::real> const>;
/// The positions that a search reads, for kernels.
template <class P>
using PositionSpan = ArraySpan<P, Vec<P::dim, typename P::real> const>;

/// The positions of the particles of one body, in which ghosts follow the owned particles.
template <class P>
struct Places {
  Positions<P> all;
  int owned = 0;
  /// Returns the positions of the owned particles, without ghosts.
  Positions<P> targets() const { return all.part(0, owned); }
};

namespace detail {
/// A stand-in for functions that are called with a candidate j.
struct AnyVisitor {
  SCREE_FN void operator()(int) const {}
};
}  // namespace detail

/// A search that finds, for targets, all sources within a radius.
///   N(radius)                 radius in m
///   update(targets, sources)  updates the search after a change of positions; may do nothing while its data are valid
///   view()                    returns a handle for the device with a function for_each(i, x_i, f, range), which calls
///                             f(j) once for each candidate of target i in the part `range`. The candidates are a
///                             superset of the sources within the radius, in an order that depends only on the
///                             positions and on the order of the particles in memory. If the targets are the
///                             sources, target i is one of its own candidates
///   builds()                  returns how often the structure was rebuilt
///   name                      optional: the name of the search in snapshots, as for a SmoothingKernel
template <class N, class P>
concept NeighbourSearch = std::constructible_from<N, double> &&
    requires(N search, N const& built, Positions<P> x, Vec<P::dim, typename P::real> xi, detail::AnyVisitor f,
             LaneRange r) {
  search.update(x, x);
  built.view().for_each(0, xi, f, r);
  { built.builds() } -> std::convertible_to<long>;
};

}  // namespace scree
