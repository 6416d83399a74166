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

/// Whether G provides the ghosts of one body: copies of particles, such as periodic images, that are stored after the
/// owned particles and serve as their neighbours.
///   Settings                     the type of the settings of the provider
///   G(settings, support, margin) makes a provider; support and margin in m
///   settings()                   the settings of the provider
///   signature()                  text by which a snapshot with other settings is rejected
///   any()                        whether there may be ghosts at all
///   settle(body)                 between steps: moves owned particles to where they belong, such as the other end of a
///                                period
///   create(body)                 replaces all ghosts, according to the positions of the owned particles; the ghosts
///                                suffice until two particles together have moved by the margin
///   refresh(body, columns)       copies columns of the origins to the ghosts
/// A body is an AnyParticles with any fields; columns are ColumnNumbers. Sums follow the order of the particles in
/// memory, so the order of ghosts must depend only on the owned particles, their positions and their order. Runs are
/// then bitwise reproducible and can be restarted bit for bit.
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
/// Whether a provider brings particles from other ranks of the case (distributed/other_ranks.hpp). Such a provider also
/// has
///   Ranks                                    the type of the member `ranks` of the settings of a solver
///   Settings(ranks, periods)
///   before_settle(all providers, all bodies), before_create(all providers, all bodies)    static
///   must_settle(builds)                      whether to settle before the next step, after a number of builds of lists
///   images()                                 the provider of the periodic images alone
///   images_within(radius)                    the provider of the periodic images within another radius (m)
///   refresh_all(all providers, all bodies, columns of each)    static; refresh() for all bodies at once
///   positions_changed()                      announces that the positions of ghosts are outdated
///   announces_changes(whether), columns_changed(columns)    while all changes of fields are announced, only changed
///                                            fields are copied to ghosts
///   scattered(), begin_again(all), scatter(all, bodies)    for snapshots: whether particles are divided among ranks;
///                                            declares that each rank has all particles again; divides them again
///   begin_with_shares(all), settled()        declares that each rank begins with a part of the particles; whether
///                                            particles are where they belong
///   copies_near(body, bodies, distance, images, fields)    copies of particles on other ranks, for checks
///   largest(number), join(frames), joined(found, particles), ...    over all ranks, see core/one_rank.hpp
template <class G>
inline constexpr bool on_ranks = requires {
  typename G::Ranks;
};
}  // namespace detail

}  // namespace scree
