// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "snapshot_columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

// Conversion between a system and its snapshot. Only owned particles are stored; ghosts are created again from them. If
// the order of neighbours does not follow from the present positions alone, the positions at the last build of the
// lists are stored as well. These positions determine the order of summation, and thereby the last digits of every sum.
namespace scree {
namespace detail {

template <class P>
SnapshotArray head_of_kept(std::string const& body) {
  return head_of<Vec<P::dim, typename P::real>>("neighbours/" + body, "m");
}
inline SnapshotArray head_of_crossed() { return head_of<double>("neighbours/crossed", "of the skin"); }

template <class P, class Memory>
[[gnu::cold]] void add_memory(Snapshot& snapshot, Memory const& memory,
                              BodiesOfSnapshot<typename P::space> const& bodies) {
  auto const& lists = memory.searches;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    snapshot.arrays.push_back(filled(head_of_kept<P>(bodies[k].name), lists.kept[k]));
  snapshot.arrays.push_back(filled(head_of_crossed(), std::vector<double>{lists.history.crossed_before}));
  add_counters(snapshot, "neighbours",
               {{"builds", lists.builds},
                {"updates", lists.history.updates},
                {"last look", lists.history.last_look},
                {"next look", lists.history.next_look},
                {"stale", memory.stale ? 1 : 0},
                {"wrap due", memory.wrap_due ? 1 : 0}});
  if (memory.unsettled > 0) add_counters(snapshot, "neighbours", {{"unsettled", memory.unsettled}});
}
/// Returns the values of the particles with the given indices.
std::vector<std::byte> picked(SnapshotArray const& array, std::vector<int> const& numbers);
/// Throws std::runtime_error if time, steps or a counter is out of range.
void check_counts(Snapshot const& snapshot);
/// Returns a counter of a snapshot, or 0 if there is none of that name. Throws std::runtime_error unless the counter is
/// from `least` to `most`.
[[gnu::cold]] long counter_within(Snapshot const& snapshot, std::string const& name, long least, long most);
/// Reads the numbers of particles added and removed, and sets the number of particles that each body then owns. Throws
/// std::runtime_error if these numbers do not fit the number of particles at the start.
template <class Space>
[[gnu::cold]] void read_turnover(std::vector<Turnover>& turnovers, std::vector<int>& owned, Snapshot const& snapshot,
                                 BodiesOfSnapshot<Space> const& bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    std::string const& name = bodies[k].name;
    long const at_start = bodies[k].at_start;
    auto counts = counters_of(snapshot, name + " particles");
    Turnover const turnover{counts["added"], counts["removed"]};
    if (turnover.added > most_particles || turnover.removed > at_start + turnover.added)
      refuse(snapshot, "of " + std::to_string(at_start) + " and " + std::to_string(turnover.added) +
                           " particles of the " + name + ", " + std::to_string(turnover.removed) + " were removed");
    turnovers[k] = turnover;
    owned[k] = checked_count(std::size_t(at_start + turnover.added - turnover.removed));
  }
}
/// Throws std::runtime_error unless each array of a body has one value for each particle that the body owns.
template <class Space>
[[gnu::cold]] void check_columns(Snapshot const& snapshot, BodiesOfSnapshot<Space> const& bodies,
                                 std::vector<int> const& owned) {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    for (SnapshotArray const& head : bodies[k].heads) {
      auto const count = matching_array(snapshot, head).count();
      if (count != std::size_t(owned[k]))
        refuse(snapshot, "'" + head.name + "' has values of " + std::to_string(count) + " particles instead of " +
                             std::to_string(owned[k]));
    }
}
/// Throws std::runtime_error unless the identities of the particles of a body are distinct numbers from 0 to below a
/// bound.
[[gnu::cold]] void check_identities(Snapshot const& snapshot, std::string const& body, long below);
/// Checks the identities of the particles of all bodies. If particles were added or removed, the bound is the identity
/// of the next particle to be added; in other bodies, users may number the particles as they like.
template <class Space>
[[gnu::cold]] void check_identities(Snapshot const& snapshot, BodiesOfSnapshot<Space> const& bodies,
                                    std::vector<Turnover> const& turnovers) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    bool const changed = turnovers[k].added + turnovers[k].removed > 0;
    check_identities(snapshot, bodies[k].name, changed ? bodies[k].at_start + turnovers[k].added : 1L << 31);
  }
}
/// Reads the counters of neighbour lists, after check_counts(). Throws std::runtime_error if the counters do not fit
/// the number of steps.
template <class Memory>
[[gnu::cold]] void read_counters_of_lists(Memory& memory, Snapshot const& snapshot) {
  auto const within = [&](char const* name, long least, long most) {
    return counter_within(snapshot, std::string("neighbours/") + name, least, most);
  };
  constexpr long updates_of_step = 1000, most = 1L << 62;  // far more than an integrator makes
  auto& lists = memory.searches;
  auto& history = lists.history;
  lists.builds = within("builds", 0, most);
  bool const built = lists.builds > 0;
  history.updates = within("updates", 0,
                           !built                                        ? 0
                           : snapshot.steps < most / updates_of_step - 1 ? updates_of_step * (snapshot.steps + 1)
                                                                         : most);
  history.last_look = within("last look", 0, history.updates);
  history.next_look = within("next look", 0, history.last_look + decltype(lists.history)::rarest_look);
  memory.stale = within("stale", 0, 1) != 0 || !built;
  memory.wrap_due = within("wrap due", 0, 1) != 0;
  memory.unsettled = static_cast<int>(std::min(within("unsettled", 0, lists.builds), 1000L));
}
/// Reads the state of neighbour lists. Throws std::runtime_error if it does not fit the system, because lists are built
/// from the positions in it. `extent_at` returns the number of particles of a body, ghosts included, for given
/// positions of its owned particles.
template <class P, class Memory>
[[gnu::cold]] void read_lists(Memory& memory, Snapshot const& snapshot,
                              BodiesOfSnapshot<typename P::space> const& bodies, double half_skin,
                              std::function<int(std::vector<Vec<P::dim, typename P::real>> const&)> const& extent_at) {
  read_counters_of_lists(memory, snapshot);
  auto& lists = memory.searches;
  auto const read_kept = [&](std::string const& body, int owned) {
    using vector = Vec<P::dim, typename P::real>;
    auto const head = head_of_kept<P>(body);
    auto const kept = values_of<vector>(matching_array(snapshot, head));
    bool const never_built = lists.builds == 0;
    if (kept.empty() && never_built) return kept;
    if (never_built) refuse(snapshot, "'" + head.name + "' has values, and 'neighbours/builds' is 0");
    for (vector const& x : kept)
      if (!x.allFinite()) refuse(snapshot, "'" + head.name + "' has a position that is not finite");
    std::size_t const least = std::size_t(owned);
    auto const of_owned = std::vector<vector>(kept.begin(), kept.begin() + std::min(kept.size(), least));
    // Values of ghosts follow from the values of owned particles; a snapshot from several ranks has no values of
    // ghosts.
    std::size_t const expected = kept.size() <= least ? least : std::size_t(extent_at(of_owned));
    if (kept.size() != expected)
      refuse(snapshot, "'" + head.name + "' has " + std::to_string(kept.size()) + " values instead of " +
                           std::to_string(expected));
    if (memory.stale) return kept;
    auto const now = values_of<vector>(matching_array(snapshot, head_of<vector>(body + "/position", "m")));
    for (std::size_t i = 0; i < least; ++i)
      if (!(double((now[i] - kept[i]).norm()) <= 1.001 * half_skin))
        refuse(snapshot, "'" + head.name + "' is too far from '" + body + "/position' for lists that are not stale");
    return kept;
  };
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    lists.owned[k] = memory.owned[k];
    lists.kept[k] = read_kept(bodies[k].name, lists.owned[k]);
  }
  auto const crossed = values_of<double>(matching_array(snapshot, head_of_crossed()));
  if (crossed.size() != 1 || !(crossed[0] >= 0 && crossed[0] < 1))
    refuse(snapshot, "'" + head_of_crossed().name + "' is not one number from 0 to below 1");
  lists.history.crossed_before = crossed.front();
}

/// The entries of the system in signature_of().
struct SignatureOfSystem {
  int dimension;
  ElementType precision;
  std::string kernel, search, ghosts;
  double smoothing_length;  // m
};
template <class Space>
[[gnu::cold]] std::string text_of(SignatureOfSystem const& system, BodiesOfSnapshot<Space> const& bodies) {
  std::string text = "dimension: " + std::to_string(system.dimension);
  text += "\nprecision: " + name_of(system.precision);
  text += "\nkernel: " + system.kernel;
  text += "\nsmoothing length: " + exact_text(system.smoothing_length) + " m";
  text += "\nsearch: " + system.search;
  for (auto const& body : bodies) text += "\n" + body.name + " particles: " + std::to_string(body.at_start);
  text += "\n";
  text += system.ghosts;
  for (auto const& body : bodies)
    for (SnapshotArray const& head : body.heads) text += head.name + ": " + head.layout() + "\n";
  return text;
}
template <class P, class Search, class Ghosts, class... OfBodies>
[[gnu::cold]] std::string signature_of(System<P, Search, Ghosts, OfBodies...> const& system,
                                       BodiesOfSnapshot<typename P::space> const& bodies) {
  SignatureOfSystem const signature{P::dim,
                                    element_type<typename P::real>(),
                                    name_of_class<typename P::kernel>(),
                                    name_of_class<Search>(),
                                    system.ghosts().signature(),
                                    double(system.kernel().h())};
  return text_of(signature, bodies);
}

/// Adds the values of the columns of all bodies, and the numbers of particles added and removed.
template <class Space>
[[gnu::cold]] void add_bodies(Snapshot& snapshot, BodiesOfSnapshot<Space> const& bodies) {
  for (auto const& body : bodies)
    for (std::size_t k = 0; k < body.heads.size(); ++k) {
      SnapshotArray array = body.heads[k];
      array.bytes.resize(std::size_t(body.columns->size()) * array.bytes_of_each());
      body.columns->to_host(k, array.bytes.data());
      snapshot.arrays.push_back(std::move(array));
    }
  for (auto const& body : bodies)
    if (body.turnover.added + body.turnover.removed > 0)
      add_counters(snapshot, body.name + " particles",
                   {{"added", body.turnover.added}, {"removed", body.turnover.removed}});
}
/// Sets the columns of the owned particles to values from a snapshot. In each body, these are the values of the
/// particles with the indices in `kept`, or of all particles if `kept` is nullptr.
template <class Space>
[[gnu::cold]] void pour(Snapshot const& snapshot, BodiesOfSnapshot<Space> const& bodies,
                        std::vector<std::vector<int>> const* kept) {
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t k = 0; k < bodies[b].heads.size(); ++k) {
      SnapshotArray const& array = matching_array(snapshot, bodies[b].heads[k]);
      if (kept == nullptr)
        bodies[b].columns->from_host(k, array.bytes.data());
      else
        bodies[b].columns->from_host(k, picked(array, (*kept)[b]).data());
    }
}

}  // namespace detail

/// Returns everything that a snapshot and a system must have in common: dimension, precision, kernel with smoothing
/// length, search, periods, and for each body its fields and its number of particles at the start.
template <class P, class Search, class Ghosts, class... OfBodies>
[[gnu::cold]] std::string signature_of(System<P, Search, Ghosts, OfBodies...> const& system) {
  return detail::signature_of(system, detail::bodies_of_snapshot(system));
}

/// Returns the state of a system between two steps. The caller adds time, steps, counters and notes.
template <class P, class Search, class Ghosts, class... OfBodies>
[[gnu::cold]] Snapshot snapshot_of(System<P, Search, Ghosts, OfBodies...> const& system) {
  auto const bodies = detail::bodies_of_snapshot(system);
  Snapshot snapshot;
  snapshot.signature = detail::signature_of(system, bodies);
  detail::add_bodies(snapshot, bodies);
  if constexpr (ListsWithSkin<Search, P>) detail::add_memory<P>(snapshot, system.memory(), bodies);
  system.whole_case().collect(snapshot, system);
  return snapshot;
}

/// Restores the state of a snapshot in a system that was made for the same case. The system then continues bit for bit
/// like the system from which the snapshot was taken. Throws std::runtime_error and leaves the system unchanged if the
/// snapshot does not fit. `more` holds lines that the caller has added to the signature. `read(turnovers)` is called
/// before the system changes, so it may throw as well.
template <class P, class Search, class Ghosts, class... OfBodies, class Read>
[[gnu::cold]] void restore_into(System<P, Search, Ghosts, OfBodies...>& system, Snapshot const& snapshot,
                                std::string const& more, Read const& read) {
  auto const bodies = detail::bodies_of_snapshot(system);
  if (auto const difference = difference_of_signatures(detail::signature_of(system, bodies) + more, snapshot.signature);
      !difference.empty())
    detail::refuse(snapshot, "does not fit this run: " + difference);
  detail::check_counts(snapshot);
  using Memory = typename System<P, Search, Ghosts, OfBodies...>::Memory;
  Memory memory(sizeof...(OfBodies));
  detail::read_turnover(memory.turnover, memory.owned, snapshot, bodies);
  detail::check_columns(snapshot, bodies, memory.owned);
  detail::check_identities(snapshot, bodies, memory.turnover);
  if constexpr (ListsWithSkin<Search, P>)
    detail::read_lists<P>(memory, snapshot, bodies, system.half_skin(),
                          [&](auto const& positions) { return system.extent_at(positions); });
  read(std::as_const(memory.turnover));
  system.restore(memory, [&](auto const& kept) { detail::pour(snapshot, bodies, kept ? &*kept : nullptr); });
}
template <class Sys>
void restore_into(Sys& system, Snapshot const& snapshot) {
  restore_into(system, snapshot, "", [](auto const&) {});
}

}  // namespace scree

#ifdef SCREE_COMPILED
namespace scree::detail {
using DefaultBodiesOfSnapshot = BodiesOfSnapshot<Kokkos::DefaultExecutionSpace>;
template <class P>
using DefaultMemory = typename Neighbourhood<P, VerletList<P>, PeriodicImages<P>>::Memory;

SCREE_INSTANCE void read_turnover(std::vector<Turnover>&, std::vector<int>&, Snapshot const&,
                                  DefaultBodiesOfSnapshot const&);
SCREE_INSTANCE void check_columns(Snapshot const&, DefaultBodiesOfSnapshot const&, std::vector<int> const&);
SCREE_INSTANCE void check_identities(Snapshot const&, DefaultBodiesOfSnapshot const&, std::vector<Turnover> const&);
SCREE_INSTANCE std::string text_of(SignatureOfSystem const&, DefaultBodiesOfSnapshot const&);
SCREE_INSTANCE void add_bodies(Snapshot&, DefaultBodiesOfSnapshot const&);
SCREE_INSTANCE void pour(Snapshot const&, DefaultBodiesOfSnapshot const&, std::vector<std::vector<int>> const*);
}  // namespace scree::detail

#define SCREE_SNAPSHOTS(P)                                                                                             \
  SCREE_INSTANCE void scree::detail::add_memory<P>(scree::Snapshot&, scree::detail::DefaultMemory<P> const&,           \
                                                   scree::detail::DefaultBodiesOfSnapshot const&);                     \
  SCREE_INSTANCE void scree::detail::read_lists<P>(                                                                    \
      scree::detail::DefaultMemory<P>&, scree::Snapshot const&, scree::detail::DefaultBodiesOfSnapshot const&, double, \
      std::function<int(std::vector<scree::Vec<P::dim, P::real>> const&)> const&)
SCREE_FOR_DEFAULT_BASES(SCREE_SNAPSHOTS);
#undef SCREE_SNAPSHOTS
#else
#include "snapshot_of.ipp"
#endif
