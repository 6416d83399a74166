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

/// An object that limits the time step of a solver.
class StepLimiter {
 public:
  StepLimiter() = default;
  StepLimiter(StepLimiter const&) = delete;
  StepLimiter& operator=(StepLimiter const&) = delete;
  virtual ~StepLimiter() = default;

  /// Returns a limit of the time step, which must be the same on all ranks. The name of the limit must outlive the
  /// solver; its `change` is TimeStepLimit::never if the limit is constant. The limit is evaluated together with the
  /// other limits, at least every 256 steps and after Solver::set_motion().
  virtual TimeStepLimit limit() const { return {"component"}; }
};

/// The part of a component that does not depend on the class of its solver.
class AnyComponent : public StepLimiter {
 public:
  /// Returns the lines that this component adds to the signature of snapshots, each with a line break. They contain the
  /// settings that must be the same in a run that continues from the snapshot.
  virtual std::string signature() const { return ""; }
  /// Adds to a snapshot the data that this component needs to continue. No two components may use the same name for a
  /// counter or an array.
  virtual void save(Snapshot&) const {}
};

/// An object that takes part in the run of a solver of class `S` at defined points, for example a controller that moves
/// a wall according to its load, or an inlet. Derive a class from Component, override the functions that are needed,
/// and pass an object to Solver::attach(). If the case has several ranks, each rank has its own component, and is_due()
/// must return the same result on all ranks.
template <class S>
class Component : public AnyComponent {
 public:
  /// Starts the component. The solver calls this once: at the beginning of the next run or, if the component is
  /// attached during a run, after the next step at the latest. It is not called again in a run that continues from a
  /// snapshot.
  virtual void start(S&) {}
  /// Whether act() is to be called now, between two steps. The solver calls this at the beginning of a run and after
  /// each step, possibly more than once. The result may depend only on values that do not change if steps are repeated:
  /// the time, the number of steps, the number of neighbour-list builds and the component itself.
  virtual bool is_due(S const&) const { return false; }
  /// Acts on the solver, whose state it may read and change. No earlier step will be repeated.
  virtual void act(S&) {}
  /// Acts at the end of each step. On a GPU the step may be repeated, so this function may change fields of particles,
  /// but must neither change the component nor wait for results from the device.
  virtual void after_step(S&) {}

  /// Returns a function that sets this component to the state in a snapshot with the same signature. The function is
  /// called after the state of the solver has been restored; other components may not have been restored yet. Throws
  /// std::runtime_error, and changes nothing, if a value is out of range.
  virtual std::function<void(S&)> read(Snapshot const&) { return {}; }
};

namespace detail {

/// The components of a solver, with a record of the calls to each.
class AttachedComponents {
 public:
  /// Attaches a component. Throws std::invalid_argument for an empty pointer and for a component that is already
  /// attached.
  void attach(std::shared_ptr<AnyComponent> component);
  /// Requests another call to is_due() of a component in the current state. Call this after changing the component.
  void ask_again(AnyComponent const& component);
  bool empty() const { return all_.empty(); }
  std::string signature() const;
  void save(Snapshot& snapshot, long steps) const;

 protected:
  static constexpr long never = -1;
  struct Attached {
    std::shared_ptr<AnyComponent> component;
    long asked_after = never;  // number of steps
    bool started = false;
  };
  /// Returns the components, each with its record in a snapshot.
  std::vector<Attached> all_in(Snapshot const& snapshot) const;

  std::vector<Attached> all_;
};

/// The components of a solver of class `S`.
template <class S>
class Components : public AttachedComponents {
 public:
  void attach(std::shared_ptr<Component<S>> component) { AttachedComponents::attach(std::move(component)); }
  /// Whether a component has not started yet, or is due and has not been called after this step.
  bool due(S const& solver) const {
    for (auto const& each : all_)
      if (!each.started || (each.asked_after != solver.steps() && of(each).is_due(solver))) return true;
    return false;
  }
  /// Starts the components that have not started and calls act() of the components that are due. A component may attach
  /// others.
  void act(S& solver) {
    for (std::size_t k = 0; k < all_.size(); ++k) {
      auto const kept = all_[k].component;  // kept alive even if the component replaces the solver
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
  /// Returns the functions that set all components of a solver to the state in a snapshot. Throws std::runtime_error if
  /// a component rejects the snapshot.
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
