// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "snapshot_columns.hpp"

#include <stdexcept>

// Between a system and its snapshot. Owned particles are kept, ghosts are made anew from them. A search whose order of
// neighbours depends on more than the present positions is kept by the positions of its last build: the order of
// summation follows from it, and with it the last digits of every sum.
namespace scree {
namespace detail {

/// A search that tells what its order of neighbours depends on, and can be brought back to it.
template <class Search>
concept RemembersPositions = requires(Search search, Search const& built) {
  search.rebuild_from(built.built_from());
};

[[noreturn]] inline void refuse(Snapshot const& snapshot, std::string const& why) {
  throw std::runtime_error((snapshot.origin.empty() ? "scree: the snapshot" : snapshot.origin) + ": " + why);
}

/// The array of a snapshot that has the layout of `head`; throws std::runtime_error where there is none.
inline SnapshotArray const& matching_array(Snapshot const& snapshot, SnapshotArray const& head) {
  SnapshotArray const* const array = snapshot.find(head.name);
  if (array == nullptr) refuse(snapshot, "'" + head.name + "' (" + head.layout() + ") is missing");
  if (array->layout() != head.layout())
    refuse(snapshot, "'" + head.name + "' is " + array->layout() + " instead of " + head.layout());
  return *array;
}
template <class P>
SnapshotArray head_of_positions(std::string const& pair, std::string const& which) {
  return head_of<Vec<P::dim, typename P::real>>("neighbours/" + pair + "/" + which, "m");
}

template <class P, class Search, class Sys>
void restore_searches(Sys& system, Snapshot const& snapshot) {
  using Memory = decltype(std::declval<Search const&>().built_from());
  using Value = Vec<P::dim, typename P::real>;
  std::map<std::string, Memory> found;  // all of them before the first is used
  system.for_each_search([&](std::string const& pair, Search const&) {
    Memory memory;
    memory.targets = values_of<Value>(matching_array(snapshot, head_of_positions<P>(pair, "targets")));
    memory.sources = values_of<Value>(matching_array(snapshot, head_of_positions<P>(pair, "sources")));
    auto const builds = snapshot.counters.find("neighbour builds/" + pair);
    memory.builds = builds == snapshot.counters.end() ? 0 : builds->second;
    found[pair] = std::move(memory);
  });
  system.for_each_search([&](std::string const& pair, Search& search) { search.rebuild_from(found[pair]); });
}

}  // namespace detail

/// What a snapshot must fit: dimension, precision, kernel with its smoothing length, search, and the particles' number
/// and fields.
template <class P, class Search, class MaterialFields, class WallFields>
std::string signature_of(System<P, Search, MaterialFields, WallFields> const& system) {
  std::string text = "dimension: " + std::to_string(P::dim);
  text += "\nprecision: " + name_of(element_type<typename P::real>());
  text += "\nkernel: " + detail::class_name<typename P::kernel>();
  text += "\nsmoothing length: " + detail::exact_text(double(system.kernel().h())) + " m";
  text += "\nsearch: " + detail::class_name<Search>();
  text += "\nmaterial particles: " + std::to_string(system.template body<Material>().size());
  text += "\nwall particles: " + std::to_string(system.template body<Wall>().size()) + "\n";
  detail::for_each_column(
      system, [&](auto const&, auto, SnapshotArray const& head) { text += head.name + ": " + head.layout() + "\n"; });
  return text;
}

/// The state of a system between two steps. Time, steps, counters and notes are left to the caller.
template <class P, class Search, class MaterialFields, class WallFields>
Snapshot snapshot_of(System<P, Search, MaterialFields, WallFields> const& system) {
  Snapshot snapshot;
  snapshot.signature = signature_of(system);
  detail::for_each_column(system, [&](auto const& body, auto field, SnapshotArray head) {
    snapshot.arrays.push_back(detail::filled(std::move(head), body.to_host(field)));
  });
  if constexpr (detail::RemembersPositions<Search>)
    system.for_each_search([&](std::string const& pair, Search const& search) {
      auto const memory = search.built_from();
      snapshot.arrays.push_back(detail::filled(detail::head_of_positions<P>(pair, "targets"), memory.targets));
      snapshot.arrays.push_back(detail::filled(detail::head_of_positions<P>(pair, "sources"), memory.sources));
      snapshot.counters["neighbour builds/" + pair] = memory.builds;
    });
  return snapshot;
}

/// Brings a system, made for the same case, to the state of a snapshot: from there it goes on bit by bit as the one the
/// snapshot was taken of. Throws std::runtime_error, and leaves the system alone, where the snapshot does not fit.
template <class P, class Search, class MaterialFields, class WallFields>
void restore_into(System<P, Search, MaterialFields, WallFields>& system, Snapshot const& snapshot) {
  if (auto const difference = difference_of_signatures(signature_of(system), snapshot.signature); !difference.empty())
    detail::refuse(snapshot, "does not fit this run: " + difference);
  detail::for_each_column(system, [&](auto const& body, auto, SnapshotArray const& head) {
    auto const count = detail::matching_array(snapshot, head).count();
    if (static_cast<int>(count) != body.size())
      detail::refuse(snapshot, "'" + head.name + "' has values of " + std::to_string(count) + " particles instead of " +
                                   std::to_string(body.size()));
  });
  if constexpr (detail::RemembersPositions<Search>) detail::restore_searches<P, Search>(system, snapshot);
  detail::for_each_column(system, [&](auto& body, auto field, SnapshotArray const& head) {
    using Value = value_t<P, decltype(field)>;
    body.from_host(field, detail::values_of<Value>(detail::matching_array(snapshot, head)));
  });
  system.positions_changed();
}

}  // namespace scree
