// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "snapshot_columns.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

// Conversion between a system and its snapshot. Owned particles are stored; ghosts are created from them again. If the
// order of neighbours depends on more than the present positions, the positions of the last build are stored too: they
// determine the order of summation, and with it the last digits of every sum.
namespace scree {
namespace detail {

[[noreturn]] inline void refuse(Snapshot const& snapshot, std::string const& why) {
  throw std::runtime_error((snapshot.origin.empty() ? "scree: the snapshot" : snapshot.origin) + ": " + why);
}

/// The array of a snapshot with the layout of `head`; throws std::runtime_error if there is none.
inline SnapshotArray const& matching_array(Snapshot const& snapshot, SnapshotArray const& head) {
  SnapshotArray const* const array = snapshot.find(head.name);
  if (array == nullptr) refuse(snapshot, "'" + head.name + "' (" + head.layout() + ") is missing");
  if (array->layout() != head.layout())
    refuse(snapshot, "'" + head.name + "' is " + array->layout() + " instead of " + head.layout());
  if (array->bytes.size() % array->bytes_of_each() != 0)
    refuse(snapshot, "'" + head.name + "' ends within the values of a particle");
  return *array;
}
template <class P>
SnapshotArray head_of_kept(std::string const& body) {
  return head_of<Vec<P::dim, typename P::real>>("neighbours/" + body, "m");
}
inline SnapshotArray head_of_crossed() { return head_of<double>("neighbours/crossed", "of the skin"); }

template <class P, class Memory>
void add_memory(Snapshot& snapshot, Memory const& memory) {
  auto const& lists = memory.searches;
  snapshot.arrays.push_back(filled(head_of_kept<P>("material"), lists.first));
  snapshot.arrays.push_back(filled(head_of_kept<P>("wall"), lists.second));
  snapshot.arrays.push_back(filled(head_of_crossed(), std::vector<double>{lists.history.crossed_before}));
  add_counters(snapshot, "neighbours",
               {{"builds", lists.builds},
                {"updates", lists.history.updates},
                {"last look", lists.history.last_look},
                {"next look", lists.history.next_look},
                {"stale", memory.stale ? 1 : 0},
                {"wrap due", memory.wrap_due ? 1 : 0}});
}
/// Throws std::runtime_error if time, steps or a counter is out of range.
inline void check_counts(Snapshot const& snapshot) {
  if (!(snapshot.time >= 0) || std::isinf(snapshot.time))
    refuse(snapshot, "'time' is " + exact_text(snapshot.time) + " s");
  constexpr long most = 1L << 62;  // leaves room for counting on
  auto counts = snapshot.counters;
  counts["steps"] = snapshot.steps;
  for (auto const& [name, count] : counts)
    if (count < 0 || count > most) refuse(snapshot, "'" + name + "' is " + std::to_string(count));
}
/// Throws std::runtime_error if the memory does not fit the system: lists are built from the positions in it.
template <class P, class Memory, class Sys>
Memory memory_in(Snapshot const& snapshot, Sys const& system) {
  Memory memory;
  auto& lists = memory.searches;
  auto counters = counters_of(snapshot, "neighbours");
  lists.builds = counters["builds"], lists.history.updates = counters["updates"];
  lists.history.last_look = counters["last look"], lists.history.next_look = counters["next look"];
  bool const never_built = lists.builds == 0;
  lists.owned_first = system.template body<Material>().size();
  lists.owned_second = system.template body<Wall>().size();
  memory.stale = counters["stale"] != 0 || never_built, memory.wrap_due = counters["wrap due"] != 0;
  auto const read_kept = [&](std::string const& body, int owned) {
    using vector = Vec<P::dim, typename P::real>;
    auto const head = head_of_kept<P>(body);
    auto const kept = values_of<vector>(matching_array(snapshot, head));
    if (kept.empty() && never_built) return kept;
    std::size_t const least = std::size_t(owned);
    auto const of_owned = std::vector<vector>(kept.begin(), kept.begin() + std::min(kept.size(), least));
    std::size_t const expected = kept.size() < least ? least : std::size_t(system.extent_at(of_owned));
    if (kept.size() != expected)
      refuse(snapshot, "'" + head.name + "' has " + std::to_string(kept.size()) + " values instead of " +
                           std::to_string(expected));
    return kept;
  };
  lists.first = read_kept("material", lists.owned_first);
  lists.second = read_kept("wall", lists.owned_second);
  auto const crossed = values_of<double>(matching_array(snapshot, head_of_crossed()));
  if (crossed.size() != 1 || !(crossed[0] >= 0) || std::isinf(crossed[0]))
    refuse(snapshot, "'" + head_of_crossed().name + "' is not one number, zero or more");
  lists.history.crossed_before = crossed.front();
  return memory;
}

}  // namespace detail

/// Everything that a snapshot and a system must have in common: dimension, precision, kernel with its smoothing length,
/// search, periods, and the particles' number and fields.
template <class P, class Search, class MaterialFields, class WallFields>
std::string signature_of(System<P, Search, MaterialFields, WallFields> const& system) {
  std::string text = "dimension: " + std::to_string(P::dim);
  text += "\nprecision: " + name_of(element_type<typename P::real>());
  text += "\nkernel: " + detail::class_name<typename P::kernel>();
  text += "\nsmoothing length: " + detail::exact_text(double(system.kernel().h())) + " m";
  text += "\nsearch: " + detail::class_name<Search>();
  text += "\nmaterial particles: " + std::to_string(system.template body<Material>().size());
  text += "\nwall particles: " + std::to_string(system.template body<Wall>().size()) + "\n";
  for (Period const& period : system.periods())
    text += "period along axis " + std::to_string(period.axis) + ": " + detail::exact_text(period.low) + " to " +
            detail::exact_text(period.high) + " m\n";
  detail::for_each_column(system, [&](auto const&, std::size_t, SnapshotArray const& head) {
    text += head.name + ": " + head.layout() + "\n";
  });
  return text;
}

/// The state of a system between two steps. The caller adds time, steps, counters and notes.
template <class P, class Search, class MaterialFields, class WallFields>
Snapshot snapshot_of(System<P, Search, MaterialFields, WallFields> const& system) {
  Snapshot snapshot;
  snapshot.signature = signature_of(system);
  detail::for_each_column(system, [&](auto const& columns, std::size_t k, SnapshotArray array) {
    array.bytes.resize(std::size_t(columns.size()) * array.bytes_of_each());
    columns.to_host(k, array.bytes.data());
    snapshot.arrays.push_back(std::move(array));
  });
  if constexpr (ListsWithSkin<Search, P>) detail::add_memory<P>(snapshot, system.memory());
  return snapshot;
}

/// Sets a system, made for the same case, to the state of a snapshot: it continues from there bit for bit like the
/// system that the snapshot was taken from. Throws std::runtime_error, and leaves the system unchanged, if the snapshot
/// does not fit.
template <class P, class Search, class MaterialFields, class WallFields>
void restore_into(System<P, Search, MaterialFields, WallFields>& system, Snapshot const& snapshot) {
  if (auto const difference = difference_of_signatures(signature_of(system), snapshot.signature); !difference.empty())
    detail::refuse(snapshot, "does not fit this run: " + difference);
  detail::check_counts(snapshot);
  detail::for_each_column(system, [&](auto const& columns, std::size_t, SnapshotArray const& head) {
    auto const count = detail::matching_array(snapshot, head).count();
    if (count != std::size_t(columns.size()))
      detail::refuse(snapshot, "'" + head.name + "' has values of " + std::to_string(count) + " particles instead of " +
                                   std::to_string(columns.size()));
  });
  using Memory = decltype(system.memory());
  Memory memory;
  if constexpr (ListsWithSkin<Search, P>) memory = detail::memory_in<P, Memory>(snapshot, system);
  system.restore(memory, [&] {
    detail::for_each_column(system, [&](auto const& columns, std::size_t k, SnapshotArray const& head) {
      columns.from_host(k, detail::matching_array(snapshot, head).bytes.data());
    });
  });
}

}  // namespace scree
