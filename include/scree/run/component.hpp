// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/time_step.hpp"
#include "../snapshots/snapshot.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// Limits the length of the steps of a solver.
class StepLimiter {
 public:
  StepLimiter() = default;
  StepLimiter(StepLimiter const&) = delete;
  StepLimiter& operator=(StepLimiter const&) = delete;
  virtual ~StepLimiter() = default;

  /// A limit of the step, which must be the same on all ranks. Its name must outlive the solver; its `change` is
  /// TimeStepLimit::never if the limit is constant. It is evaluated together with the other limits, at least every 256
  /// steps and after Solver::set_motion().
  virtual TimeStepLimit limit() const { return {"component"}; }
};

/// The part of a component that does not depend on the class of its solver.
class AnyComponent : public StepLimiter {
 public:
  /// The lines that this component adds to the signature of snapshots, each with a line break: settings that must be
  /// the same in a run that continues from the snapshot.
  virtual std::string signature() const { return ""; }
  /// Adds the data that this component needs to continue to a snapshot. The names of its counters and arrays must
  /// differ from those of other components.
  virtual void save(Snapshot&) const {}
};

/// Takes part in the run of a solver of class `S` at defined points: for example a controller that moves a wall
/// according to its load, or an inlet. Derive from it, override the functions that are needed, and give it to
/// Solver::attach(). If the case has several ranks, each has its own component, and is_due() must return the same on
/// all of them.
template <class S>
class Component : public AnyComponent {
 public:
  /// Called once: at the beginning of the next run or, if the component is attached during a run, after the next step
  /// at the latest. Not called again in a run that continues from a snapshot.
  virtual void start(S&) {}
  /// Whether act() is to be called now, between two steps. It is called at the beginning of a run and after each step,
  /// possibly more than once. The result may depend only on values that do not change if steps are repeated: the time,
  /// the number of steps, the number of builds of neighbour lists, the component itself.
  virtual bool is_due(S const&) const { return false; }
  /// Acts on the solver: may read and change its state. None of the steps before will be repeated.
  virtual void act(S&) {}
  /// Called at the end of each step. On a GPU the step may be repeated, so this function may change fields of
  /// particles, but must neither change the component nor wait for results of the device.
  virtual void after_step(S&) {}

  /// Returns a function that sets this component to the state in a snapshot with the same signature. The function is
  /// called after the state of the solver has been restored; other components may not have been restored yet. Throws
  /// std::runtime_error, and changes nothing, if a value is out of range.
  virtual std::function<void(S&)> read(Snapshot const&) { return {}; }
};

namespace detail {

/// The components of a solver, with a record of the calls of each.
class AttachedComponents {
 public:
  /// Attaches a component. Throws std::invalid_argument for an empty pointer, and for a component that is attached
  /// already.
  void attach(std::shared_ptr<AnyComponent> component);
  /// Asks for another call of is_due() of a component in the present state. Call this if the component was changed.
  void ask_again(AnyComponent const& component);
  bool empty() const { return all_.empty(); }
  std::string signature() const;
  void save(Snapshot& snapshot, long steps) const;

 protected:
  static constexpr long never = -1;
  struct Attached {
    std::shared_ptr<AnyComponent> component;
    long asked_after = never;  // steps
    bool started = false;
  };
  /// The components, with the record that a snapshot has of each.
  std::vector<Attached> all_in(Snapshot const& snapshot) const;

  std::vector<Attached> all_;
};

/// The components of a solver of class `S`.
template <class S>
class Components : public AttachedComponents {
 public:
  void attach(std::shared_ptr<Component<S>> component) { AttachedComponents::attach(std::move(component)); }
  /// Whether a component has to start, or is due and has not been called after this step.
  bool due(S const& solver) const {
    for (auto const& each : all_)
      if (!each.started || (each.asked_after != solver.steps() && of(each).is_due(solver))) return true;
    return false;
  }
  /// Starts the components that have not started, and calls act() of those that are due. They may attach others.
  void act(S& solver) {
    for (std::size_t k = 0; k < all_.size(); ++k) {
      auto const kept = all_[k].component;  // also if the component replaces the solver
      auto& component = of(all_[k]);
      if (!all_[k].started) component.start(solver), all_[k].started = true;
      if (all_[k].asked_after == solver.steps()) continue;
      all_[k].asked_after = solver.steps();
      try {
        if (component.is_due(solver)) component.act(solver);
      } catch (...) {
        all_[k].asked_after = never;
        throw;
      }
    }
  }
  void after_step(S& solver) const {
    for (std::size_t k = 0; k < all_.size(); ++k) of(all_[k]).after_step(solver);
  }
  /// Returns the functions that set all components of a solver to the state of a snapshot. Throws std::runtime_error
  /// where one of them refuses it.
  std::vector<std::function<void()>> read(Snapshot const& snapshot, S& solver) {
    std::vector<std::function<void()>> set;
    for (auto const& each : all_)
      if (auto function = of(each).read(snapshot))
        set.push_back([function = std::move(function), &solver] { function(solver); });
    set.push_back([this, attached = all_in(snapshot)] { all_ = attached; });
    return set;
  }

 private:
  static Component<S>& of(Attached const& each) { return static_cast<Component<S>&>(*each.component); }
};

}  // namespace detail
}  // namespace scree

#ifndef SCREE_COMPILED
#include "component.ipp"
#endif
