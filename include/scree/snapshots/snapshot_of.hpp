// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "snapshot_columns.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

// Conversion between a system and its snapshot. Owned particles are stored; ghosts are created from them again. If the
// order of neighbours depends on more than the present positions, the positions of the last build are stored too: they
// determine the order of summation, and with it the last digits of every sum.
namespace scree {
namespace detail {

template <class P>
SnapshotArray head_of_kept(std::string const& body) {
  return head_of<Vec<P::dim, typename P::real>>("neighbours/" + body, "m");
}
inline SnapshotArray head_of_crossed() { return head_of<double>("neighbours/crossed", "of the skin"); }

template <class P, class List, class Memory>
[[gnu::cold]] void add_memory(Snapshot& snapshot, Memory const& memory) {
  auto const& lists = memory.searches;
  for_each_body(List{}, [&]<class Body>() {
    snapshot.arrays.push_back(filled(head_of_kept<P>(std::string(Body::name)), lists.kept[body_index<Body, List>()]));
  });
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
/// The number of particles of a body at the start, on all ranks.
template <class Body, class Sys>
long number_at_start(Sys const& system) {
  return system.template turnover<Body>().at_start(system.template whole<Body>().size());
}
/// Gives the arrays of particles the values of all ranks.
template <class Sys>
[[gnu::cold]] void collect_from_ranks(Snapshot& snapshot, Sys const& system) {
  for_each_body(typename Sys::bodies{}, [&]<class Body>() {
    auto const& body = system.template body<Body>();
    auto const order = system.ranks().order_of(body);
    std::string const name(Body::name);
    for (SnapshotArray& array : snapshot.arrays) {
      bool const of_lists =
          array.name == "neighbours/" + name && system.neighbour_builds() > 0 && system.ranks().scattered();
      if (!of_lists && array.name.rfind(name + "/", 0) != 0) continue;
      array.bytes.resize(array.bytes_of_each() * std::size_t(body.size()));  // without ghosts
      array.bytes = order.of(std::move(array.bytes), array.bytes_of_each());
    }
  });
}
/// The values of some particles.
std::vector<std::byte> picked(SnapshotArray const& array, std::vector<int> const& numbers);
/// Throws std::runtime_error if time, steps or a counter is out of range.
void check_counts(Snapshot const& snapshot);
/// Throws std::runtime_error unless a counter, 0 if the snapshot has none of that name, is in a range.
[[gnu::cold]] long counter_within(Snapshot const& snapshot, std::string const& name, long least, long most);
/// Particles that came and went, and how many there are then. Throws std::runtime_error if these counts do not fit the
/// number at the start.
template <class Memory, class Sys>
[[gnu::cold]] void read_turnover(Memory& memory, Snapshot const& snapshot, Sys const& system) {
  using List = typename Sys::bodies;
  for_each_body(List{}, [&]<class Body>() {
    std::string const name(Body::name);
    auto counts = counters_of(snapshot, name + " particles");
    Turnover const turnover{counts["added"], counts["removed"]};
    long const at_start = number_at_start<Body>(system);
    if (turnover.added > most_particles || turnover.removed > at_start + turnover.added)
      refuse(snapshot, "of " + std::to_string(at_start) + " and " + std::to_string(turnover.added) +
                           " particles of the " + name + ", " + std::to_string(turnover.removed) + " were removed");
    memory.turnover[body_index<Body, List>()] = turnover;
    memory.owned[body_index<Body, List>()] = checked_count(std::size_t(at_start + turnover.added - turnover.removed));
  });
}
/// Throws std::runtime_error unless the identities are different numbers from 0 to below a bound.
[[gnu::cold]] void check_identities(Snapshot const& snapshot, std::string const& body, long below);
/// check_identities() for all bodies in which particles came or went: the bound is the number of the next particle to
/// be added. In other bodies users may number the particles as they like.
template <class Sys>
void check_identities(Snapshot const& snapshot, Sys const& system, std::vector<Turnover> const& turnovers) {
  using List = typename Sys::bodies;
  for_each_body(List{}, [&]<class Body>() {
    auto const& turnover = turnovers[body_index<Body, List>()];
    bool const changed = turnover.added + turnover.removed > 0;
    long const next = changed ? number_at_start<Body>(system) + turnover.added : 1L << 31;
    check_identities(snapshot, std::string(Body::name), next);
  });
}
/// Reads the counters of lists, after check_counts(). Throws std::runtime_error if they do not fit the number of steps.
template <class Memory>
[[gnu::cold]] void read_counters_of_lists(Memory& memory, Snapshot const& snapshot) {
  auto const within = [&](char const* name, long least, long most) {
    return counter_within(snapshot, std::string("neighbours/") + name, least, most);
  };
  constexpr long updates_of_step = 1000, most = 1L << 62;  // far more than integrators make
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
/// Throws std::runtime_error if the memory does not fit the system: lists are built from the positions in it.
template <class P, class Memory, class Sys>
[[gnu::cold]] void read_lists(Memory& memory, Snapshot const& snapshot, Sys const& system) {
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
    // Values of ghosts follow from the others; a snapshot of several ranks has none.
    std::size_t const expected = kept.size() <= least ? least : std::size_t(system.extent_at(of_owned));
    if (kept.size() != expected)
      refuse(snapshot, "'" + head.name + "' has " + std::to_string(kept.size()) + " values instead of " +
                           std::to_string(expected));
    if (memory.stale) return kept;
    auto const now = values_of<vector>(matching_array(snapshot, head_of<vector>(body + "/position", "m")));
    for (std::size_t i = 0; i < least; ++i)
      if (!(double((now[i] - kept[i]).norm()) <= 1.001 * system.half_skin()))
        refuse(snapshot, "'" + head.name + "' is too far from '" + body + "/position' for lists that are not stale");
    return kept;
  };
  using List = typename Sys::bodies;
  for_each_body(List{}, [&]<class Body>() {
    constexpr std::size_t k = body_index<Body, List>();
    lists.owned[k] = memory.owned[k];
    lists.kept[k] = read_kept(std::string(Body::name), lists.owned[k]);
  });
  auto const crossed = values_of<double>(matching_array(snapshot, head_of_crossed()));
  if (crossed.size() != 1 || !(crossed[0] >= 0 && crossed[0] < 1))
    refuse(snapshot, "'" + head_of_crossed().name + "' is not one number from 0 to below 1");
  lists.history.crossed_before = crossed.front();
}

}  // namespace detail

/// Everything that a snapshot and a system must have in common: dimension, precision, kernel with its smoothing length,
/// search, periods, and the particles' fields and number at the start.
template <class P, class Search, class Ghosts, class... OfBodies>
[[gnu::cold]] std::string signature_of(System<P, Search, Ghosts, OfBodies...> const& system) {
  std::string text = "dimension: " + std::to_string(P::dim);
  text += "\nprecision: " + name_of(element_type<typename P::real>());
  text += "\nkernel: " + detail::name_of_class<typename P::kernel>();
  text += "\nsmoothing length: " + detail::exact_text(double(system.kernel().h())) + " m";
  text += "\nsearch: " + detail::name_of_class<Search>();
  detail::for_each_body(typename System<P, Search, Ghosts, OfBodies...>::bodies{}, [&]<class Body>() {
    long const at_start = detail::number_at_start<Body>(system);
    text.append("\n").append(Body::name).append(" particles: ").append(std::to_string(at_start));
  });
  text += "\n";
  text += system.ghosts().signature();
  detail::for_each_column(system, [&](std::size_t, auto const&, std::size_t, SnapshotArray const& head) {
    text += head.name + ": " + head.layout() + "\n";
  });
  return text;
}

/// The state of a system between two steps. The caller adds time, steps, counters and notes.
template <class P, class Search, class Ghosts, class... OfBodies>
[[gnu::cold]] Snapshot snapshot_of(System<P, Search, Ghosts, OfBodies...> const& system) {
  Snapshot snapshot;
  snapshot.signature = signature_of(system);
  detail::for_each_column(system, [&](std::size_t, auto const& columns, std::size_t k, SnapshotArray array) {
    array.bytes.resize(std::size_t(columns.size()) * array.bytes_of_each());
    columns.to_host(k, array.bytes.data());
    snapshot.arrays.push_back(std::move(array));
  });
  detail::for_each_body(typename System<P, Search, Ghosts, OfBodies...>::bodies{}, [&]<class Body>() {
    Turnover const& turnover = system.template turnover<Body>();
    if (turnover.added + turnover.removed > 0)
      add_counters(snapshot, std::string(Body::name).append(" particles"),
                   {{"added", turnover.added}, {"removed", turnover.removed}});
  });
  if constexpr (ListsWithSkin<Search, P>)
    detail::add_memory<P, typename System<P, Search, Ghosts, OfBodies...>::bodies>(snapshot, system.memory());
  if constexpr (detail::on_ranks<Ghosts>) detail::collect_from_ranks(snapshot, system);
  return snapshot;
}

/// Sets a system, made for the same case, to the state of a snapshot: it continues from there bit for bit like the
/// system that the snapshot was taken from. Throws std::runtime_error, and leaves the system unchanged, if the snapshot
/// does not fit. `more`: lines that the caller has added to the signature. `read(turnovers)` is called before the
/// system changes, so it may throw too.
template <class P, class Search, class Ghosts, class... OfBodies, class Read>
[[gnu::cold]] void restore_into(System<P, Search, Ghosts, OfBodies...>& system, Snapshot const& snapshot,
                                std::string const& more, Read const& read) {
  if (auto const difference = difference_of_signatures(signature_of(system) + more, snapshot.signature);
      !difference.empty())
    detail::refuse(snapshot, "does not fit this run: " + difference);
  detail::check_counts(snapshot);
  using Memory = typename System<P, Search, Ghosts, OfBodies...>::Memory;
  Memory memory(sizeof...(OfBodies));
  detail::read_turnover(memory, snapshot, system);
  detail::for_each_column(system, [&](std::size_t body, auto const&, std::size_t, SnapshotArray const& head) {
    auto const count = detail::matching_array(snapshot, head).count();
    if (count != std::size_t(memory.owned[body]))
      detail::refuse(snapshot, "'" + head.name + "' has values of " + std::to_string(count) + " particles instead of " +
                                   std::to_string(memory.owned[body]));
  });
  detail::check_identities(snapshot, system, memory.turnover);
  if constexpr (ListsWithSkin<Search, P>) detail::read_lists<P>(memory, snapshot, system);
  read(std::as_const(memory.turnover));
  system.restore(memory, [&]([[maybe_unused]] auto const& kept) {
    detail::for_each_column(system,
                            [&](std::size_t body, auto const& columns, std::size_t k, SnapshotArray const& head) {
                              SnapshotArray const& array = detail::matching_array(snapshot, head);
                              if constexpr (detail::on_ranks<Ghosts>)
                                if (system.ranks().scattered())
                                  return columns.from_host(k, detail::picked(array, kept[body]).data());
                              columns.from_host(k, array.bytes.data());
                            });
  });
}
template <class Sys>
void restore_into(Sys& system, Snapshot const& snapshot) {
  restore_into(system, snapshot, "", [](auto const&) {});
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "snapshot_of.ipp"
#endif
