// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "searches.hpp"

#include <utility>

// Trials: steps of a run that may have to be repeated.
namespace scree::detail {

/// The steps of a run. On a GPU, neighbour lists are checked rarely. Steps are therefore taken on trial, and a later
/// check shows whether all of them used valid lists:
///
///     certain  -- step() begins a trial, if the system wants one -->  in trial
///     certain  -- step() without a trial                         -->  certain
///     in trial -- step()                                         -->  in trial
///     in trial -- the system builds lists within a step          -->  certain; the trial was good
///     in trial -- step() finds that invalid lists were used      -->  certain, at the beginning of the trial
///     in trial -- become_certain(), the trial was good           -->  certain
///     in trial -- become_certain(), the trial had failed         -->  certain, at the beginning of the trial
///
/// Call become_certain() before code that reads the state (observers, inlets, components, the caller of run()). `State`
/// has a `system` and a `clock`. If others share the case, trials begin, fail and are repeated on all of them together.
template <class State>
class Trials {
 public:
  explicit Trials(State& state) : state_(state) {}

  /// Calls take(), which advances the state by one step, on trial if `may_begin` is true and the system begins a trial.
  /// If the trial has failed, restores the state at the beginning of the trial and returns false. Exceptions from a
  /// step outside a trial are thrown again. An exception from a step of a trial may be an effect of outdated lists, so
  /// on a single rank it is thrown again only if the trial was good.
  template <class Take>
  bool step(Take const& take, bool may_begin) {
    try {
      if (may_begin && state_.system.begin_trial()) beginning_ = state_.clock, has_begun_ = true;
      take();
      return true;
    } catch (ListsOutrun const&) {
      go_back();
    } catch (...) {
      // In a shared case an error may have occurred in this part alone. Checks of the state follow a check of the
      // lists.
      bool const is_shared = state_.system.whole_case().is_shared();
      if (is_shared) state_.system.end_trial();
      if (is_shared || become_certain()) throw;
    }
    return false;
  }
  /// Ends a trial. If the trial has failed, restores the state at the beginning of the trial and returns false.
  bool become_certain() {
    bool const failed = state_.system.trial_failed();
    if (failed)
      go_back();
    else
      state_.system.end_trial();
    return !failed;
  }
  /// Returns question(), a condition that does not depend on the state. If question() throws, the run ends in a certain
  /// state: the present state or, if the trial has failed or there are several ranks, the state at the beginning of the
  /// trial.
  template <class Question>
  bool ask(Question const& question) {
    try {
      return question();
    } catch (...) {
      if (!state_.system.whole_case().is_shared())
        become_certain();
      else if (state_.system.in_trial())
        go_back();  // the error is in this part alone, and the others do not take part
      throw;
    }
  }

 private:
  void go_back() {
    state_.system.undo_trial();
    if (has_begun_) state_.clock = beginning_;
  }

  State& state_;
  // Not a std::optional, because GCC 12 warns that its map may be uninitialized.
  decltype(State::clock) beginning_;
  bool has_begun_ = false;
};

}  // namespace scree::detail
