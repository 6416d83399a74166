// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../integrators/largest_cfl.hpp"
#include "../laws/grains.hpp"
#include "state.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Checks of the state of a solver: once before the first step, and whenever the limits of the step are evaluated.
namespace scree::detail {

/// The name of an evolving body in messages about its particles; empty if no other body evolves.
template <class P, class Body>
inline constexpr std::string_view name_among_evolving = evolving_bodies<P>::count > 1 ? std::string_view(Body::name)
                                                                                      : std::string_view();

/// Runs an action of a step. If the action throws std::runtime_error, a value that is not finite is the likely cause;
/// if there is one, it is reported instead.
template <class P, class Action>
auto or_name(SolverState<P> const& state, Action const& action) {
  try {
    return action();
  } catch (std::runtime_error const&) {
    for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
      check_finite(state.system.template body<Body>(), Merge<evolved_fields<evolves_of<P, Body>>, Fields<Volume>>{},
                   state.clock.steps, name_among_evolving<P, Body>);  // volumes weight all sums
    });
    throw;
  }
}

/// Returns the largest grain diameter of a physics model, m; for combined models, that of the mechanics.
template <class Physics>
double largest_grains_of(Physics const& physics) {
  if constexpr (requires { physics.mechanics; })
    return largest_grains_of(physics.mechanics);
  else if constexpr (requires { physics.law; })
    return largest_diameter(physics.law);
  else
    return 0;
}
/// Returns a warning if the diameter of the grains (m) is more than ten times the spacing (m); otherwise an empty text.
[[gnu::cold]] inline std::string warning_of_grains(double diameter, double spacing) {
  if (!(diameter > 10 * spacing)) return "";
  return formatted(
      "scree: warning: the diameter of the grains, %.6g m, is %.4g times the spacing of the particles, %.6g m: the "
      "law is one of many grains in a small volume; is it given in mm?",
      diameter, diameter / spacing, spacing);
}
template <class P>
void warn_of_models(SolverState<P> const& state) {
  auto const& settings = state.settings;
  if (!settings.start_checks || !settings.warn || !state.system.whole_case().reports()) return;
  double largest = 0;  // diameter, m
  for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
    largest = std::max(largest, largest_grains_of(physics_of_body<Body>(settings.physics)));
  });
  std::string text = warning_of_grains(largest, settings.spacing);
  if constexpr (requires { settings.physics.warning(); }) {
    std::string const of_models = settings.physics.warning();
    if (!text.empty() && !of_models.empty()) text += '\n';
    text += of_models;
  }
  if (!text.empty()) settings.warn(text);
}
/// Warns of a state for which a model is not suited, once for each model. Two successive checks must find such a state,
/// because a flow passes through such states while it starts. The intervals between checks double, up to 16384 steps.
template <class P>
[[gnu::cold]] void warn_of_state(SolverState<P>& state) {
  auto const& settings = state.settings;
  long const steps = state.clock.steps, never = std::numeric_limits<long>::max();
  if (!settings.start_checks || steps < state.models_due) return;
  state.models_due = never;
  if (!state.system.whole_case().anywhere(bool(settings.warn))) return;
  std::vector<std::string> found;
  for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
    auto const body = state.system.template whole<Body>(state.clock.time);
    for (auto& text : warnings_of_state(physics_of_body<Body>(settings.physics), body))
      found.push_back(std::move(text));
  });
  state.doubts.resize(found.size());
  std::string given;
  for (std::size_t k = 0; k < found.size(); ++k) {
    auto& [before, said] = state.doubts[k];
    bool const now = !found[k].empty();
    if (now && before && !said) said = true, given += (given.empty() ? "" : "\n") + found[k];
    before = now;
    if (!said) state.models_due = std::min(2 * steps, steps + 16384);
  }
  if (!given.empty() && settings.warn && state.system.whole_case().reports())
    settings.warn(given + formatted("; found at %.6g s, after step %ld", state.clock.time, steps));
}
/// Checks, once, the settings that depend on each other.
template <class P>
void check_settings_once(SolverState<P>& state) {
  if (state.settings_checked) return;
  check_settings_of(state.settings.physics);
  check_cfl_of<typename P::integrator>(state.settings.physics);
  state.settings_checked = true;
  warn_of_models(state);
}
template <class P>
void check_precision(SolverState<P> const& state) {
  PositionChecks<P>::precision(state.farthest(), state.settings, state.clock.steps);
}
/// Checks the particles before the first step; with `warns` it also warns of them.
template <class P>
void check_particles(SolverState<P>& state, bool warns = false) {
  state.system.settle_shares();
  check_precision(state);
  if constexpr (has_rigid_bodies<typename P::bodies>)
    if (state.settings.start_checks) state.rigid.check_start(state.settings.spacing);
  PositionChecks<P>::start(state.system, state.settings, warns);
}
/// Checks the particles before the first step unless they were checked or restored before.
template <class P>
void check_start_once(SolverState<P>& state) {
  if (state.started) return;
  check_particles(state, true);
  state.started = true;
}

template <class Physics>
constexpr bool explain_limits() {
  constexpr bool has_limits = HasLimits<Physics>;
  static_assert(has_limits,
                "`physics` needs a function `limits(resolution)`: a tuple of limits of the step, which may be empty");
  if constexpr (has_limits) {
    constexpr bool are_right = are_limits<decltype(std::declval<Physics const&>().limits(Resolution{}))>;
    static_assert(are_right, "`limits(resolution)` of `physics` returns a tuple of what limit() returns");
    return are_right;
  }
  return false;
}
/// Checks the values of the present state, and returns the time step limits of the physics.
template <class P>
std::vector<TimeStepLimit> limits_now(SolverState<P> const& state) {
  auto const& settings = state.settings;
  check_precision(state);
  if constexpr (has_rigid_bodies<typename P::bodies>) {
    state.rigid.contact().check(state.system, state.clock.steps);
    if (settings.lost_share < 1)
      state.rigid.check_inside(state.system, state.followers.box(settings.motion, state.clock.time), state.support());
  }
  Resolution const resolution = state.resolution();
  std::vector<TimeStepLimit> all;
  for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
    auto const& physics = physics_of_body<Body>(settings.physics);
    if constexpr (explain_limits<physics_of<P, Body>>()) {
      auto const of_body = limits_of(state.system.template whole<Body>(), evolved_fields<evolves_of<P, Body>>{},
                                     physics.limits(resolution), state.clock.steps,
                                     bounds_of<P>(physics, resolution, [&] { return state.nothing_lost(); }),
                                     name_among_evolving<P, Body>);
      for (auto const& limit : of_body) all.push_back(limit);
    }
  });
  return all;
}

/// The limits of a time step, beginning with the limits of the physics.
struct LimitsOfStep {
  std::vector<TimeStepLimit> all;
  std::size_t of_physics = 0;
};
/// Checks the state and returns the limits of the time step.
template <class P>
LimitsOfStep look(SolverState<P>& state, TimeStepControl& control, PositionChecks<P>& checks) {
  auto const& settings = state.settings;
  // Any fault found after this line is not caused by outdated neighbour lists.
  if (state.system.whole_case().is_shared()) state.system.stop_if_trial_failed();
  state.followers.check(settings.motion, state.clock.time);
  checks.walls_now_and_then(state.system, settings, state.clock.steps);
  auto limits = limits_now(state);
  std::size_t const of_physics = limits.size();
  limits.push_back({"motion", settings.motion.time_step(), TimeStepLimit::never});
  if constexpr (has_rigid_bodies<typename P::bodies>)
    for (auto const& limit : state.rigid.limits(state.system, settings.physics, settings.spacing))
      limits.push_back(limit);
  for (auto const& limiter : state.limiters) limits.push_back(limiter->limit());
  control.look(limits, state.clock.steps);
  return {std::move(limits), of_physics};
}
/// Checks that the functions of the motion agree with each other, from the time of the last such check to a time (s).
template <class P>
[[gnu::cold]] void check_paths(SolverState<P>& state, double until) {
  bool const went_back = !(state.paths_until <= state.clock.time);
  state.followers.check_paths(state.settings.motion, went_back ? state.clock.time : state.paths_until, until);
  state.paths_until = until, state.paths_due = state.clock.steps + 32;
}

/// Returns the largest distance (m), beyond rounding, between the particles of a body and the positions that a motion
/// gives them at present.
template <class Body, class P>
[[gnu::cold]] double misplaced(SolverState<P> const& state, typename P::motion const& motion) {
  using real = typename P::real;
  auto const& body = state.system.template body<Body>();
  auto const x = body.to_host(fields::position), rest = body.to_host(fields::rest_position);
  auto const of_body = motion_of_body<Body>(motion);
  auto const of = moves_of(of_body, body);
  double const rounding = 64 * double(std::numeric_limits<real>::epsilon());
  double farthest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    auto const there = of(k).displaced(rest[k], 0.0, state.clock.time);
    double const scale = double(norm(rest[k]) + norm(there));
    double const far = double((there - x[k]).norm()) - rounding * scale;
    if (!(far <= farthest)) farthest = far;  // NaN stays
  }
  auto const& whole_case = state.system.whole_case();
  return whole_case.anywhere(std::isnan(farthest)) ? farthest : whole_case.largest(farthest);
}
/// Throws std::invalid_argument unless all bodies that follow the motion are where a given motion puts them at present.
/// `name` denotes the given motion in the message.
template <class P>
[[gnu::cold]] void check_places(SolverState<P> const& state, typename P::motion const& motion, char const* name) {
  for_each_body(not_rigid_among<following_bodies<P>>{}, [&]<class Body>() {
    double const far = misplaced<Body>(state, motion) / state.settings.spacing;
    if (!(far <= 1e-6))
      throw std::invalid_argument(
          formatted("scree: %s would put particles of the %s %.3g spacings from where they are "
                    "at %g s: it must begin where the motion before ended",
                    name, std::string(Body::name).c_str(), far, state.clock.time));
  });
}
/// Checks, once after a snapshot was restored, whether the motion of the settings fits the positions of the bodies,
/// because the run that wrote the snapshot may have had another motion. Throws std::invalid_argument if it does not.
template <class P>
void check_places_once(SolverState<P>& state) {
  if (state.places_checked) return;
  check_places(state, state.settings.motion, "the motion of the settings");
  if (state.moves_anew) state.place_followers(state.clock.time);
  state.places_checked = true, state.moves_anew = false;
}

}  // namespace scree::detail
