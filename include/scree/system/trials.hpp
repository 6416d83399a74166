// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "searches.hpp"

#include <utility>

// Steps of a run that may have to be repeated.
namespace scree::detail {

/// Takes the steps of a run. On a GPU neighbour lists are checked rarely, so steps form a trial, and it turns out later
/// whether all of them used valid lists:
///
///     certain  -- step() begins a trial, if the system wants one -->  in trial
///     certain  -- step() without a trial                         -->  certain
///     in trial -- step()                                         -->  in trial
///     in trial -- the system builds lists within a step          -->  certain; the trial was good
///     in trial -- step() finds that lists were outrun            -->  certain, at the beginning of the trial
///     in trial -- become_certain(), the trial was good           -->  certain
///     in trial -- become_certain(), the trial had failed         -->  certain, at the beginning of the trial
///
/// Whoever reads the state (observers, inlets, components, a caller of run()) needs certainty first. `State` has a
/// `system` and a `clock`. Where others share the case, all of them begin, fail and repeat together.
template <class State>
class Trials {
 public:
  explicit Trials(State& state) : state_(state) {}

  /// take() advances the state by one step. If the trial failed, the state returns to the beginning of the trial, and
  /// the result is false. An error of a step that is certain is thrown; one of a step in a trial may be an effect of
  /// outdated lists, so it is thrown only if the trial was good.
  template <class Take>
  bool step(Take const& take, bool may_begin) {
    try {
      if (may_begin && state_.system.begin_trial()) beginning_ = state_.clock, has_begun_ = true;
      take();
      return true;
    } catch (ListsOutrun const&) {
      go_back();
    } catch (...) {
      // In a shared case an error may be of this part alone, and checks of the state come after one of the lists.
      bool const is_shared = state_.system.whole_case().is_shared();
      if (is_shared) state_.system.end_trial();
      if (is_shared || become_certain()) throw;
    }
    return false;
  }
  /// Ends a trial. If it failed, the state returns to its beginning, and the result is false.
  bool become_certain() {
    bool const failed = state_.system.trial_failed();
    if (failed)
      go_back();
    else
      state_.system.end_trial();
    return !failed;
  }
  /// The answer to a question that does not depend on the state. If it throws, the run ends in a state that is certain:
  /// this one or, if the trial had failed, that of its beginning.
  template <class Question>
  bool ask(Question const& question) {
    try {
      return question();
    } catch (...) {
      if (!state_.system.whole_case().is_shared())
        become_certain();
      else if (state_.system.in_trial())
        go_back();  // an error of this part alone: the others do not answer
      throw;
    }
  }

 private:
  void go_back() {
    state_.system.undo_trial();
    if (has_begun_) state_.clock = beginning_;
  }

  State& state_;
  // No std::optional: GCC 12 warns that its map may not be initialized.
  decltype(State::clock) beginning_;
  bool has_begun_ = false;
};

}  // namespace scree::detail
