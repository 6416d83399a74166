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

/// Positions of the particles of one body; ghosts follow the owned particles.
template <class P>
struct Places {
  Positions<P> all;
  int owned = 0;
  /// The positions of the owned particles, without ghosts.
  Positions<P> targets() const { return all.part(0, owned); }
};

namespace detail {
/// Represents "do something with candidate j".
struct AnyVisitor {
  SCREE_FN void operator()(int) const {}
};
}  // namespace detail

/// Finds, for targets, all sources within a radius.
///   N(radius)                 radius in m
///   update(targets, sources)  call after positions changed; may do nothing while its data are still valid
///   view()                    a handle for the device with a function for_each(i, x_i, f, range), which calls
///                             f(j) once for each of a part of a superset of the sources within the radius of target
///                             i, in an order that depends on the positions only. Where targets are sources, target i
///                             is among them
///   builds()                  how often the structure was rebuilt
///   name                      optional: what snapshots call the search, as for a SmoothingKernel
template <class N, class P>
concept NeighbourSearch = std::constructible_from<N, double> &&
    requires(N search, N const& built, Positions<P> x, Vec<P::dim, typename P::real> xi, detail::AnyVisitor f,
             LaneRange r) {
  search.update(x, x);
  built.view().for_each(0, xi, f, r);
  { built.builds() } -> std::convertible_to<long>;
};

}  // namespace scree
