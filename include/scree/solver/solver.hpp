// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../snapshots/snapshot_of.hpp"
#include "observer.hpp"
#include "population.hpp"
#include "refused.hpp"

#include <cmath>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// Advances one formulation in time: makes it from particles, runs it, saves and restores its state. It only combines
/// parts that can be used on their own: passes, an integrator, a motion.
template <class P>
class Solver : public Population<P> {
  using Base = Population<P>;

 public:
  using typename Base::Evolved;
  using typename Base::Space;
  using typename Base::vector;
  using Observers = std::vector<Observer<Solver>>;
  using Base::check_validity, Base::turnover, Base::update_rates;

  /// Everything runs on this instance of the execution space. Positions in m; every particle gets the volume
  /// spacing^dim.
  Solver(Space const& space, SolverSettings<P> const& settings, std::vector<vector> const& material,
         std::vector<vector> const& wall = {})
      : Solver(space, settings, particles_of<Material>(material), particles_of<Wall>(wall)) {}
  /// The same with named groups (fields/groups.hpp) for the material, the walls, or both. Bodies that carry `group` get
  /// the numbers of these groups. Throws std::invalid_argument if the motion is by group and does not know one of them.
  /// Points may also be shares (fields/shared_points.hpp), where each part of a case gives its own, then for all
  /// bodies.
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::are_no_vectors<vector, A, B>)
      Solver(Space const& space, SolverSettings<P> const& settings, A const& material, B const& wall = {},
             detail::PointsFit<vector, A, B> = {})
      : Solver(space, settings, particles_of<Material>(material), particles_of<Wall>(wall)) {}
  /// Made from the particles of each body, in any order: `Solver<F>(settings, particles_of<Soil>(points), ...)`.
  template <class... Tags, class... Points>
  requires(sizeof...(Tags) > 0)
      Solver(Space const& space, SolverSettings<P> const& settings, ParticlesOf<Tags, Points> const&... particles)
      : Solver(space, detail::starts<typename P::bodies, vector>(particles...), settings) {}
  /// All these on the default instance.
  Solver(SolverSettings<P> const& settings, std::vector<vector> const& material, std::vector<vector> const& wall = {})
      : Solver(detail::default_instance<Space>(), settings, material, wall) {}
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::are_no_vectors<vector, A, B>) Solver(SolverSettings<P> const& settings, A const& material,
                                                        B const& wall = {}, detail::PointsFit<vector, A, B> = {})
      : Solver(detail::default_instance<Space>(), settings, material, wall) {}
  template <class... Tags, class... Points>
  requires(sizeof...(Tags) > 0) explicit Solver(SolverSettings<P> const& settings,
                                                ParticlesOf<Tags, Points> const&... particles)
      : Solver(detail::default_instance<Space>(), settings, particles...) {}
  /// Takes what no other constructor takes, so that the compiler prints this sentence and not a list of constructors.
  template <Label mistake =
                "the settings or points do not fit: each name in the braces must be a member of SolverSettings, in the "
                "order of its members; with SolverSettings<F>{...} for {...} the compiler says which one is wrong">
  explicit Solver(...) = delete;  // SolverSettings<F>{...} for {...}: the compiler then says which name is wrong

  Solver(Solver&&) = default;
  Solver& operator=(Solver&& other) {
    if (this == &other) return *this;
    Base::operator=(std::move(static_cast<Base&>(other)));
    before_trial_ = other.before_trial_;
    return *this;
  }
  Solver(Solver const&) = delete;  // a copy would share the fields; another solver can restore() this one's snapshot()

  /// Makes all checks that the next step makes of settings, positions, fields, walls and limits of the step, and throws
  /// what it would throw; inlets are fed if it is time to. Call it before a run to do what must not be done for a case
  /// that is refused, as to replace earlier results: the run makes the same checks again, and its results do not
  /// change.
  void check_start() {
    open();
    if (steps_ == 0) return this->check_step();
    Snapshot const before = snapshot();  // the next step reads what the last one left in fields that passes write
    this->check_step();
    restore(before);
  }
  /// Runs until the given time (s), calling each observer at its times, or until `stop`, called after each step,
  /// returns true. `asks` saves a GPU a wait in each step: `stop` is called only if `asks`, where given, returns true.
  /// Several parts of a case go on together: both hold for all if they hold for one.
  /// Throws std::invalid_argument for a time that is negative or NaN, for an infinite one without `stop`, and when
  /// steps have become so short that the run would not end. Throws std::logic_error if the solver is advancing already,
  /// in a run whose observer calls it or on another thread, and if it was moved from.
  void run(double until, Observers const& observers = {}, std::function<bool(Solver const&)> const& stop = {},
           std::function<bool()> const& asks = {}) {
    check_setting(until >= 0 && (stop || std::isfinite(until)), "the end of a run (s)", until,
                  "0 or more, and finite without a `stop`");
    detail::Busy::Hold const hold(busy_);
    if (time_ < until) open();
    RunEnds ends(until);
    if (steps_ == 0 && !observers.empty()) check_settings_once(), update_rates();
    Schedule<Solver> schedule(observers, *this);
    long const steps_before = steps_;
    while (time_ < until) {
      double const target = schedule.next(until);
      if (!try_step(target)) continue;
      bool const may_stop = certain_if_thrown([&] {
        ends.check_after_step(time_, control_.deciding());
        return stop && (!asks || this->parts().on_any(asks()));
      });
      bool const serves = openings_due();
      if ((may_stop || serves || has_come(target, time_)) && !certain()) continue;
      if (serves) serve_openings();
      schedule.act(*this);
      if (may_stop && this->parts().on_any(stop(*this))) break;
    }
    if (steps_ > steps_before) check_validity();
  }

  // These overloads take arguments that do not fit, and name the mistake at compile time.
  template <class X, class... Others>
  requires(!std::is_convertible_v<X const&, Observers const&>) void run(double, X const&, Others const&...) {
    detail::explain_observers<X, Solver>();
  }
  template <class X, class... Others>
  requires(!std::is_convertible_v<X const&, Observer<Solver> const&>) void run(double, std::initializer_list<X>,
                                                                               Others const&...) {
    detail::explain_observers<std::initializer_list<X>, Solver>();
  }
  template <class Stop, class... Others>
  requires(!std::is_convertible_v<Stop const&, std::function<bool(Solver const&)>>) void run(double, Observers const&,
                                                                                             Stop const&,
                                                                                             Others const&...) {
    static_assert(
        sizeof(Stop) == 0,
        "`stop` is a function of the solver that returns a bool: run(end, {}, [&](S const& now) { return ...; })");
  }

  /// Everything that the next step needs; a solver made from the same settings and particles continues from it bit for
  /// bit. Throws as check_finite() does: no run can continue from such a state, and it must not overwrite a good
  /// snapshot. On several parts all make it together, and get that of the whole case.
  Snapshot snapshot() const {
    ProfilingRegion const region("scree::snapshot");
    busy_.check_is_here();
    check_finite(this->material(), Evolved{}, steps_);
    Snapshot result = snapshot_of(system_);
    if (openings_) result.signature += openings_->signature(), openings_->add_to(result);
    result.time = time_;
    result.steps = steps_;
    if (turnover().added > 0)
      result.arrays.push_back(detail::filled(confines_head(), followers_.confines().material()));
    add_counters(result, "step limits", control_.counts());
    result.counters[next_look_name] = control_.next_look();
    return result;
  }
  /// Throws std::runtime_error, and leaves the solver unchanged, if the snapshot is of another formulation or number of
  /// particles, if the motion is by group and the groups differ, or if it has other inlets and drains, which this
  /// solver must have been given before. On several parts all restore the same one, which may come from any number of
  /// parts.
  void restore(Snapshot const& snapshot) {
    ProfilingRegion const region("scree::restore");
    busy_.check_is_here();
    detail::require_same_groups_in<P>(snapshot, system_);
    std::function<void()> set_openings;
    std::vector<vector> confines;
    long next_look = 0;
    restore_into(system_, snapshot, openings_ ? openings_->signature() : "", [&](auto const& turnovers) {
      next_look = detail::counter_within(snapshot, next_look_name, 0, snapshot.steps + TimeStepControl::rarest_look);
      if (openings_) set_openings = openings_->read(snapshot);
      if (turnovers[body_index<Material, typename P::bodies>()].added > 0)
        confines = detail::values_of<vector>(detail::matching_array(snapshot, confines_head()));
    });
    if (set_openings) set_openings();
    if (!confines.empty()) followers_.confines().add_material(confines);
    started_ = true;
    time_ = snapshot.time;
    steps_ = snapshot.steps;
    control_.restore(counters_of(snapshot, "step limits"), next_look);
  }

 private:
  using Base::Base;
  using Base::busy_, Base::check_settings_once, Base::open, Base::openings_due, Base::serve_openings, Base::sorts_now,
      Base::step_closed;
  using Base::control_, Base::followers_, Base::openings_, Base::settings_, Base::started_, Base::steps_, Base::system_,
      Base::time_;
  using typename Base::AtStart;
  static constexpr char const* next_look_name = "next look at step limits";
  static SnapshotArray confines_head() { return detail::head_of<vector>("confines/material", "m"); }
  /// One step of a run towards a time (s), possibly part of a trial. If the trial fails, the solver returns to the
  /// beginning of the trial, and the result is false.
  bool try_step(double target) {
    try {
      if (!sorts_now() && system_.begin_trial()) before_trial_ = {time_, steps_, control_};
      double const dt = step_closed(target - time_);
      if (target - time_ < 1e-6 * dt) time_ = target;
      return true;
    } catch (detail::ListsOutrun const&) {
      undo_trial();
    } catch (...) {
      // On several parts an error may be that of one part alone, and checks of the state come after one of the lists.
      if (this->parts().several()) system_.end_trial();
      if (this->parts().several() || certain()) throw;
    }
    return false;
  }
  template <class Question>
  bool certain_if_thrown(Question const& question) {
    try {
      return question();
    } catch (...) {
      if (!this->parts().several())
        certain();
      else if (system_.in_trial())
        undo_trial();  // an error of this part alone: the others do not answer
      throw;
    }
  }
  /// Ends a trial. If it failed, the solver returns to the beginning of the trial, and the result is false.
  bool certain() {
    bool const failed = system_.trial_failed();
    if (failed)
      undo_trial();
    else
      system_.end_trial();
    return !failed;
  }
  void undo_trial() {
    system_.undo_trial();
    std::tie(time_, steps_, control_) = before_trial_;
  }

  std::tuple<double, long, TimeStepControl> before_trial_;
};

/// The solver of a formulation with a mistake: the compiler has said which, and says little of the rest of the program.
template <class P>
requires(!detail::explain_formulation<P>()) class Solver<P> : public Population<detail::StandIn<P>> {
 public:
  using Observers = std::vector<Observer<Solver>>;
  explicit Solver(...);
  void check_start();
  template <class... Others>
  void run(double, Observers const& = {}, Others const&...) {}
  template <class Body = Material, class... Any>
  void set(Any const&...) {}
  Snapshot snapshot() const;
  void restore(Snapshot const&);
};

}  // namespace scree
