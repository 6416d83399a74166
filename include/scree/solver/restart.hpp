// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/space.hpp"
#include "../snapshots/snapshot_of.hpp"
#include "looks.hpp"
#include "state.hpp"

#include <functional>
#include <string>
#include <vector>

// Saving the state of a solver in snapshots, and restoring it.
namespace scree::detail {

inline constexpr char const* next_look_name = "next look at step limits";
template <class P>
SnapshotArray confines_head() {
  return head_of<typename SolverState<P>::vector>("confines/material", "m");
}
/// Returns the number of particles that were added to the evolving bodies, from the turnover of each body.
template <class P, class TurnoverOf>
long added_to_evolving(TurnoverOf const& turnover_of) {
  long all = 0;
  for_each_body(evolving_bodies<P>{}, [&]<class Body>() { all += turnover_of.template operator()<Body>().added; });
  return all;
}

/// Returns the snapshot of a state. Throws std::runtime_error if evolving values are not finite.
template <class P>
Snapshot snapshot_of_state(SolverState<P> const& state) {
  ProfilingRegion const region("scree::snapshot");
  state.busy.check_is_here();
  long const steps = state.clock.steps;
  for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
    check_finite(state.system.template body<Body>(), evolved_fields<evolves_of<P, Body>>{}, steps,
                 name_among_evolving<P, Body>);
  });
  Snapshot result = snapshot_of(state.system);
  result.time = state.clock.time;
  result.steps = steps;
  if (added_to_evolving<P>([&]<class Body>() { return state.system.template turnover<Body>(); }) > 0)
    result.arrays.push_back(filled(confines_head<P>(), state.followers.confines().material()));
  add_counters(result, "step limits", state.clock.control.counts());
  result.counters[next_look_name] = state.clock.control.next_look();
  return result;
}

inline long next_look_of(Snapshot const& snapshot) {
  return counter_within(snapshot, next_look_name, 0, snapshot.steps + TimeStepControl::rarest_look);
}
/// Restores a state from a snapshot. `signature` is the signature of the components of the solver, and `read` reads the
/// data of the components before anything is changed. Throws std::runtime_error, and changes nothing, if the snapshot
/// does not fit.
template <class P>
void restore_state(SolverState<P>& state, Snapshot const& snapshot, std::string const& signature,
                   std::function<void()> const& read) {
  ProfilingRegion const region("scree::restore");
  state.busy.check_is_here();
  require_same_groups_in<P>(snapshot, state.system);
  using vector = typename SolverState<P>::vector;
  std::vector<vector> confines;
  restore_into(state.system, snapshot, signature, [&](auto const& turnovers) {
    next_look_of(snapshot);  // throws if out of range
    read();
    if (added_to_evolving<P>([&]<class Body>() { return turnovers[body_index<Body, typename P::bodies>()]; }) > 0)
      confines = values_of<vector>(matching_array(snapshot, confines_head<P>()));
  });
  if (!confines.empty()) state.followers.confines().add_material(confines);
  state.started = true, state.places_checked = false, state.moves_anew = false;
  state.clock.time = snapshot.time;
  state.clock.steps = snapshot.steps;
}

/// Returns the snapshot of a solver with its components.
template <class P>
Snapshot snapshot_with(AttachedComponents const& components, SolverState<P> const& state) {
  Snapshot result = snapshot_of_state(state);
  result.signature += components.signature();
  components.save(result, state.clock.steps);
  return result;
}
/// Restores a solver and its components from a snapshot. Throws as restore_state() does.
template <class S, class P>
void restore_with(Components<S>& components, S& solver, SolverState<P>& state, Snapshot const& snapshot) {
  std::vector<std::function<void()>> set_components;
  restore_state(state, snapshot, components.signature(), [&] { set_components = components.read(snapshot, solver); });
  state.restoring = true;
  try {
    for (auto const& set : set_components) set();
  } catch (...) {
    state.restoring = false;
    throw;
  }
  state.restoring = false;
  state.clock.control.restore(counters_of(snapshot, "step limits"), next_look_of(snapshot));
}

}  // namespace scree::detail
