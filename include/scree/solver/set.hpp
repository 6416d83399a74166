// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../formulation/explain_set.hpp"
#include "looks.hpp"

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Changes that the user makes to the state of a solver.
namespace scree::detail {

/// Sets a field of a body to the given values, one per particle.
template <class Body, class P, Field F>
void set_values(SolverState<P>& state, F field, std::vector<value_t<P, F>> const& values) {
  auto& body = state.system.template body<Body>();
  auto const& settings = state.settings;
  constexpr bool evolves = EvolvingBody<Body>;
  if constexpr (FollowingBody<Body> && !RigidTag<Body> && is_checked_on_wall<F>)
    check_on_wall<F>(motion_of_body<Body>(settings.motion), body, values);
  if constexpr (std::is_same_v<F, Volume>) check_volumes(values, "the " + std::string(Body::name));
  if constexpr (std::is_same_v<F, Identity>) check_identities(values, "the " + std::string(Body::name));
  if constexpr (std::is_same_v<F, Volume> && evolves)
    if (state.started && settings.start_checks)
      PositionChecks<P>::template set_volumes<Body>(state.system, settings, values);
  body.from_host(field, values);
  if constexpr (OneOf<Remainder<F>, scree::carried_fields<P, Body>>) body.fill(Remainder<F>{}, zero<value_t<P, F>>());
  state.clock.control.look_before(state.clock.steps);
  if constexpr (std::is_same_v<F, Position>) state.system.positions_changed();
  if constexpr (std::is_same_v<F, Position> && evolves)
    state.followers.confines().add_material(state.system.template whole<Body>().all_of(corners_of(values)));
  if constexpr (std::is_same_v<F, RestPosition> && !RigidTag<Body>) {
    state.followers.template add<Body>(state.system, settings.motion, values);
    state.rigid.prepare(state.system, settings);
  }
}

/// Checks whether a motion fits the bodies that follow it: their groups, and the fields that must agree with the
/// motion.
template <class P>
[[gnu::cold]] void check_motion(SolverState<P> const& state, typename P::motion const& next) {
  check_settings_of(next);
  for_each_body(not_rigid_among<following_bodies<P>>{}, [&]<class Body>() {
    auto const before = motion_of_body<Body>(state.settings.motion), after = motion_of_body<Body>(next);
    if constexpr (OneOf<Group, fields_to_move<P, Body>>)
      if (after.groups() != before.groups())
        throw std::invalid_argument(
            formatted("scree: the new motion is that of %d groups, and the %s has %d: make it "
                      "from the one before, settings().motion",
                      after.groups(), std::string(Body::name).c_str(), before.groups()));
    [&]<class... Fs>(Fields<Fs...>) {
      auto const check = [&]<class F>(F) {
        auto const& body = state.system.template body<Body>();
        if constexpr (is_checked_on_wall<F>) check_on_wall<F>(after, body, body.to_host(F{}));
      };
      (check(Fs{}), ...);
    }(scree::carried_fields<P, Body>{});
  });
}
/// Replaces the motion. After a restore, the positions are compared only in the next step, when all components have set
/// the motion.
template <class P>
void set_motion(SolverState<P>& state, typename P::motion const& next) {
  state.busy.check_is_here();
  if (state.system.in_trial())
    throw std::logic_error(
        "scree: the motion can be changed between steps that are certain: in act() of a component, in "
        "an observer, or outside of a run");
  check_motion(state, next);
  if (state.places_checked) check_places(state, next, "the new motion");
  state.followers.check(next, state.clock.time);
  state.settings.motion = next;
  state.paths_until = std::numeric_limits<double>::infinity(), state.paths_due = state.clock.steps;
  if (state.restoring) return;  // fields and limits are those of the snapshot
  if (state.places_checked)
    state.place_followers(state.clock.time);
  else
    state.moves_anew = true;
  state.clock.control.look_before(state.clock.steps);
}

}  // namespace scree::detail
