// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../core/whole_case.hpp"
#include "../fields/particles.hpp"
#include "../fields/shared_points.hpp"
#include "../fields/standard.hpp"

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
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

/// A provider that answers for its case as a whole, because others may have particles of it
/// (distributed/other_ranks.hpp). It also has the functions of AllHere.
template <class G>
concept DividesCase = requires(G const& ghosts) {
  ghosts.whole_case();
};

/// A provider in a case whose particles are all here, with what a Neighbourhood asks of any provider. The argument
/// `all` has the providers of all bodies.
template <class P, class G>
struct AllHere : G {
  using G::G;

  WholeCase const& whole_case() const { return whole_case_here; }
  /// The images at the ends of periods.
  G& images() { return *this; }
  /// The particles that a solver is given.
  template <class Start>
  static void begin(std::vector<AllHere>&, Start const& start) {
    for (auto const& body : start.all)
      for (auto const& range : body.ranges) require_all_points(range.here.size(), range.all.size());
  }
  /// Whether particles have to settle before the first checks.
  bool has_share() const { return false; }
  /// Before settle() of the bodies, and before create().
  static void before_settle(std::vector<AllHere>&, AllBodiesRead<P>) {}
  static void before_create(std::vector<AllHere>&, AllBodies<P>) {}
  /// Whether to settle before the next step, when lists are built. It may count the builds since it last did.
  bool must_settle(int& /*unsettled*/) const { return G::any(); }
  /// refresh() of all bodies, with columns of each.
  static void refresh_all(std::vector<AllHere>& all, AllBodies<P> bodies, ColumnNumbers const* columns) {
    for (std::size_t k = 0; k < bodies.size(); ++k)
      if (!columns[k].empty()) all[k].refresh(bodies[k], columns[k]);
  }
  /// Positions of the body have changed, so those of ghosts are outdated.
  void positions_changed() {}
  /// While all changes of fields are announced, only changed fields are copied to ghosts.
  void announces_changes(bool) {}
  void columns_changed(ColumnNumbers) {}
  /// Throws std::logic_error if ghosts have other values than their origins. For tests.
  void check_ghosts(AnyParticles<P> const&, ColumnNumbers) const {}
  /// For snapshots: all particles of the case are here again; creates their ghosts, and returns the numbers of those
  /// that stay here, none if all do.
  static void begin_again(std::vector<AllHere>&) {}
  static std::optional<std::vector<std::vector<int>>> scatter(std::vector<AllHere>& all, AllBodies<P> bodies) {
    for (std::size_t k = 0; k < bodies.size(); ++k) all[k].create(bodies[k]);
    return std::nullopt;
  }
  /// visit(copies) for copies of particles that are elsewhere: of a body, with some fields, within a distance (m) of
  /// all bodies here, with images if those are wanted.
  template <class... Any>
  void with_copies_near(Any const&...) const {}
};

template <class P, class G>
using provider_in_case = std::conditional_t<DividesCase<G>, G, AllHere<P, G>>;

}  // namespace detail

}  // namespace scree
