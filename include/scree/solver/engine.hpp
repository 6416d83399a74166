// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/bodies.hpp"

#include <functional>
#include <string>
#include <vector>

// The functions of a solver on its state. They depend on the choices of a formulation, not on its name, so that the
// library scree::compiled can contain instances of them. Each comment names the header that defines the function.
namespace scree {

struct Snapshot;
struct TimeStepLimit;
template <class P>
struct SolverSettings;

namespace detail {

template <class X>
struct BodyAtStart;
template <class P>
struct SolverState;

template <class P>
using ParticlesAtStart = PerBody<BodyAtStart<Vec<P::dim, typename P::real>>, typename P::bodies>;

/// Returns the state of a solver before its first step (state.hpp).
template <class P>
SolverState<P> state_at_start(typename P::space const& space, ParticlesAtStart<P> const& start,
                              SolverSettings<P> const& settings);
/// Computes the rates of the present state; with `afresh`, also rates that are otherwise computed only at certain steps
/// (stepper.hpp).
template <class P>
void update_rates(SolverState<P>& state, bool afresh);
/// Takes a step of at most `longest` (s); returns its length (stepper.hpp).
template <class P>
double take_step(SolverState<P>& state, double longest);
/// Runs the checks of the next step (stepper.hpp).
template <class P>
void check_step(SolverState<P>& state);
/// Checks the particles before the first step unless they were checked or restored before (looks.hpp).
template <class P>
void check_start_once(SolverState<P>& state);
/// Checks the values of the present state, and returns the time step limits of the physics (looks.hpp).
template <class P>
[[gnu::noinline]] std::vector<TimeStepLimit> limits_now(SolverState<P> const& state);
/// Replaces the motion (set.hpp).
template <class P>
void set_motion(SolverState<P>& state, typename P::motion const& next);
/// Returns the snapshot of a state, without the components of its solver (restart.hpp).
template <class P>
Snapshot snapshot_of_state(SolverState<P> const& state);
/// Restores a state from a snapshot (restart.hpp).
template <class P>
void restore_state(SolverState<P>& state, Snapshot const& snapshot, std::string const& signature,
                   std::function<void()> const& read);

}  // namespace detail
}  // namespace scree
