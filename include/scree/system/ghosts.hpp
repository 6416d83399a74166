// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../fields/particles.hpp"
#include "../fields/standard.hpp"

#include <concepts>
#include <string>
#include <vector>

namespace scree {

/// Provides the ghosts of one body: copies of particles, for example periodic images, stored behind the
/// owned particles, which are their neighbours.
///   Settings                     what it is made from
///   G(settings, support, margin) lengths in m
///   settings()                   the settings that it is made from
///   signature()                  text by which a snapshot of other settings is refused
///   any()                        whether there may be ghosts at all
///   settle(body)                 between steps: moves owned particles to where they belong, such as the other end of a
///                                period
///   create(body)                 replaces all ghosts, according to the positions of the owned particles; they suffice
///                                until two particles together have moved by the margin
///   refresh(body, columns)       copies columns of the origins to the ghosts
/// A body is an AnyParticles, whatever its fields; columns are ColumnNumbers.
/// Sums are taken in the order of the particles in memory, so ghosts must come in an order that depends only on the
/// owned particles, their positions and their order; with this, runs repeat and restart bit for bit.
template <class G, class P>
concept GhostProvider = std::constructible_from<G, typename G::Settings, double, double> && std::movable<G> &&
    requires(G ghosts, G const& made, AnyParticles<P>& body, ColumnNumbers columns) {
  { made.settings() } -> std::convertible_to<typename G::Settings>;
  { made.signature() } -> std::convertible_to<std::string>;
  { made.any() } -> std::convertible_to<bool>;
  ghosts.settle(body);
  ghosts.create(body);
  ghosts.refresh(body, columns);
};

namespace detail {
/// Whether a provider brings particles from other ranks of the case (distributed/other_ranks.hpp). It also has
///   Ranks                                    the member `ranks` of the settings of a solver
///   Settings(ranks, periods)
///   before_settle(all providers, all bodies), before_create(the same)    static
///   must_settle(builds)                      whether to settle before the next step, after a number of builds of lists
///   images()                                 the images at the ends of periods alone
///   images_within(radius)                    images at the ends of periods within another radius (m)
///   refresh_all(all providers, all bodies, columns of each)    static; refresh() of all bodies at once
///   positions_changed()                      positions of the body changed, so those of ghosts are outdated
///   announces_changes(whether), columns_changed(columns)    while all changes of fields are announced, only changed
///                                            fields are copied to ghosts
///   scattered(), begin_again(all), scatter(all, bodies)    for snapshots: whether particles are divided; to join and
///                                            divide them again
///   begin_with_shares(all), settled()        the ranks begin with shares; whether particles are where they belong
///   copies_near(body, bodies, distance, images, fields)    copies of particles of other ranks, for checks
///   largest(number), join(frames), joined(found, particles), ...    over all ranks, see core/one_rank.hpp
template <class G>
inline constexpr bool on_ranks = requires {
  typename G::Ranks;
};
}  // namespace detail

}  // namespace scree
