// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../run/observer.hpp"
#include "../system/trials.hpp"
#include "population.hpp"
#include "restart.hpp"
#include "set.hpp"
#include "stepper.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// A solver for one formulation. It is made from particles, advances them in time, and saves and restores its state.
/// The solver only combines parts that can be used on their own: passes, an integrator, a motion, components.
template <class P>
class Solver {
  using Choices = detail::choices_of<P>;
  using State = detail::SolverState<Choices>;
  using Openings = detail::Openings<Solver, State>;

 public:
  using policy = P;
  using Basis = basis_of<P>;
  using Space = typename P::space;
  using vector = Vec<P::dim, typename P::real>;
  using Evolved = evolved_fields<typename P::physics::evolves>;
  using Observers = std::vector<Observer<Solver>>;
  static constexpr bool evolves_position = detail::evolves_position<P>;
  static constexpr bool has_stress = OneOf<Stress, material_fields<P>>;  // whether the material carries the stress
  static constexpr bool has_rigid_bodies = detail::has_rigid_bodies<typename P::bodies>;
  static constexpr bool has_ranks = detail::DividesCase<typename P::template ghosts<Basis>>;

  /// Makes the solver on an instance of the execution space, from the particles of the material and the walls, given as
  /// positions (m) or named groups (fields/groups.hpp). Alternatively, each rank of a case gives its share of the
  /// particles (fields/shared_points.hpp); then all bodies must be given as shares. Every particle gets the volume
  /// spacing^dim; bodies that carry `group` get the numbers of their groups. Throws std::invalid_argument if the motion
  /// is given by group and lacks one of the groups.
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::are_particles<A, B>) Solver(Space const& space, SolverSettings<P> const& settings, A const& material,
                                               B const& wall = {}, detail::PointsFit<vector, A, B> = {})
      : Solver(space, settings, particles_of<Material>(material), particles_of<Wall>(wall)) {}
  /// Makes the solver from the particles of each body, in any order: `Solver<F>(settings, particles_of<Soil>(points),
  /// ...)`.
  template <class... Tags, class... Points>
  requires(sizeof...(Tags) > 0)
      Solver(Space const& space, SolverSettings<P> const& settings, ParticlesOf<Tags, Points> const&... particles)
      : state_(detail::state_at_start<Choices>(space, detail::starts<typename P::bodies, vector>(particles...),
                                               settings)) {}
  /// Makes the solver on the default instance of the execution space, from positions, groups or shares.
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::are_particles<A, B>) Solver(SolverSettings<P> const& settings, A const& material, B const& wall = {},
                                               detail::PointsFit<vector, A, B> = {})
      : Solver(detail::default_instance<Space>(), settings, material, wall) {}
  template <class... Tags, class... Points>
  requires(sizeof...(Tags) > 0) explicit Solver(SolverSettings<P> const& settings,
                                                ParticlesOf<Tags, Points> const&... particles)
      : Solver(detail::default_instance<Space>(), settings, particles...) {}
  /// Accepts arguments that no other constructor accepts, so that the compiler prints one message instead of a list of
  /// constructors.
  template <Label mistake =
                "the settings or points do not fit: each name in the braces must be a member of SolverSettings, in the "
                "order of its members; with SolverSettings<F>{...} for {...} the compiler says which one is wrong">
  explicit Solver(...) = delete;  // with SolverSettings<F>{...} for {...}, the compiler says which name is wrong

  Solver(Solver&&) = default;
  Solver& operator=(Solver&& other) {
    if (this != &other)
      state_ = std::move(other.state_), components_ = std::move(other.components_),
      openings_ = std::move(other.openings_);
    return *this;
  }
  Solver(Solver const&) = delete;  // a copy would share the fields; another solver can restore() this one's snapshot()

  /// Returns the particles of a body.
  template <BodyTag Body>
  auto const& body() const {
    return state_.system.template body<Body>();
  }
  /// Returns the particles of the material.
  auto const& material() const { return body<Material>(); }
  /// Returns the particles of the walls.
  auto const& wall() const { return body<Wall>(); }
  /// Returns a body of the whole case in the present state, including its particles on other ranks
  /// (fields/whole_body.hpp).
  template <BodyTag Body = Material>
  auto whole() const {
    return state_.system.template whole<Body>(time());
  }
  /// Returns the instance of the execution space in which all loops of the solver run.
  Space const& space() const { return state_.system.space(); }
  /// Returns the present time, s.
  double time() const { return state_.clock.time; }
  /// Returns the number of steps since the start.
  long steps() const { return state_.clock.steps; }
  /// Returns how often the neighbour lists were built.
  long neighbour_builds() const { return state_.system.neighbour_builds(); }
  /// Returns the object that answers questions about the whole case: WholeCase (core/whole_case.hpp), or the same
  /// object as ranks().
  auto const& whole_case() const { return state_.system.whole_case(); }
  /// Returns the ranks of a case that may have several ranks: OtherRanks of the first body.
  auto const& ranks() const { return whole_case(); }
  /// Returns how often a run on a GPU repeated steps because neighbour lists expired earlier than expected.
  long failed_trials() const { return state_.system.failed_trials(); }
  /// Returns, for each time step limit, the number of steps whose length it determined.
  std::map<std::string, long> const& limits() const { return state_.clock.control.counts(); }
  /// Returns a note if the motion, the rigid bodies or a component has required steps shorter than a tenth of those of
  /// the physics model. The note names the first such limit, with both steps (s); it is "" if there was none. Progress
  /// prints the note once.
  std::string const& note_on_steps() const { return state_.note_on_steps; }
  /// Returns the settings of the solver; set_motion() changes the motion in them. The type is SolverSettings of the
  /// choices of P: `auto const&` refers to the current settings, whereas a SolverSettings<P> is a copy.
  SolverSettings<Choices> const& settings() const { return state_.settings; }
  /// Returns the spacing, smoothing length and support of the kernel, m, and sums over the initial lattice.
  Resolution resolution() const { return state_.resolution(); }
  /// Returns the number of particles of the evolving bodies at the start, on all ranks.
  long particles_at_start() const { return state_.at_start; }
  /// Returns the numbers of particles that were added to and removed from the material, on all ranks: the present
  /// number is the number at the start + added - removed.
  Turnover const& turnover() const { return state_.system.template turnover<Material>(); }
  /// Returns the number of particles of the evolving bodies, on all ranks, that are more than a support outside the box
  /// around the walls and the positions given to the material. The box is open at the top and along periods. Returns
  /// zero without walls, or if positions are prescribed.
  long lost() const {
    if constexpr (evolves_position) return detail::number_beyond(state_.system, state_.nothing_lost());
    return 0;
  }

  /// Sets a field of a body to the values of a function at the given points, one point per particle (on the host). The
  /// function must return a value: an Eigen expression would outlive the values it refers to. Throws
  /// std::invalid_argument for slip normals that SlipNormal::check_on_wall() refuses; for volumes that are not positive
  /// or that, during a run, fit the distances between the particles worse than the old ones (see `start_checks`); and
  /// for identities that are negative or not unique.
  template <class Body = Material, Field F, class Points, class Function>
  void set(F field, Points const& points, Function const& function) {
    using List = typename std::remove_cvref_t<decltype(body<Body>())>::fields;
    using X = std::remove_cvref_t<decltype(*points.begin())>;
    if constexpr (detail::explain_set<P, Body, F, List, X, Function>()) {
      state_.busy.check_is_here();
      std::vector<value_t<P, F>> values;
      values.reserve(points.size());
      for (auto const& x : points) values.push_back(static_cast<value_t<P, F>>(function(x)));
      detail::set_values<Body>(state_, field, values);
      // A value that is not finite is reported by the next step.
      bool const is_finite =
          std::all_of(values.begin(), values.end(), [](auto const& each) { return detail::is_finite(each); });
      if (state_.started && !whole_case().anywhere(!is_finite)) evaluate_again();
    }
  }
  /// Sets a field of a body to the values of a function at the present positions.
  template <class Body = Material, Field F, class Function>
  void set(F field, Function const& function) {
    set<Body>(field, body<Body>().to_host(fields::position), function);
  }
  // Any other argument is an error at compile time, with a message that shows how to pass a field.
  template <class Body = Material, class Name, class... Others>
  requires(!Field<Name>) void set(Name const&, Others const&...) {
    static_assert(sizeof(Name) == 0, "set() takes a field as an object: set(fields::velocity, function)");
  }
  /// Replaces the motion of the walls. The new motion must give the walls their present positions; the velocity may
  /// jump. This function must be called between steps, for example in Component::act(). Throws std::invalid_argument if
  /// a particle would jump; after restore(), the next step throws instead. Snapshots do not contain the motion: the
  /// code that changes the motion must also restore it.
  void set_motion(typename P::motion const& motion) { detail::set_motion(state_, motion); }

  /// Adds particles to the material, with new identities:
  ///   solver.add(points, given(fields::velocity, u), given(fields::concentration, [](auto const& x) { return ...; }));
  /// Each particle gets the volume spacing^dim unless a volume is given; all other fields that are not given are zero.
  /// Throws std::invalid_argument, and adds no particles, if the new particles overlap with others or with walls, or if
  /// their distances or volumes do not fit the spacing (see `start_checks`). This function must be called between
  /// steps, for example in an observer. The rates are evaluated again.
  template <class... Fs, class... Values>
  void add(std::vector<vector> const& points, Given<Fs, Values> const&... values) {
    if constexpr (detail::explain_population<P>()) {
      detail::static_check_given<P, Fs...>();
      if (points.empty()) return;
      StartWords const words{"among those to be added,", " of those that are there"};
      detail::add_particles(state_, points, words, words, values...);
      particles_changed();
    }
  }
  // Any other points are an error at compile time, with a message that says what is wrong with them.
  template <class Points, class... Others>
  requires(!std::is_convertible_v<Points const&, std::vector<vector> const&>) void add(Points const&,
                                                                                       Others const&...) {
    static_assert(!detail::explain_points<Points, vector>(), "add() takes plain points: give the points() of groups");
  }
  /// Removes the particles of the material for which `condition(i)` is true. The condition is a function of a particle
  /// that names the fields it needs in `reads`, like a term. Returns the given fields of the removed particles (on the
  /// host), one entry per particle. This function must be called between steps. Throws std::invalid_argument if the
  /// `check()` of the condition does, for instance for a plane without a normal or an empty block.
  template <class Condition, class... Fs>
  auto remove(Condition const& condition, Fields<Fs...> fields = {}) {
    if constexpr (detail::explain_population<P>()) {
      check_settings_of(condition);
      auto const removed = detail::remove_particles(state_, condition, fields);
      if (!removed.empty()) particles_changed();
      return removed;
    }
  }
  /// Reserves memory for a number of particles of the material, so that a lack of memory is reported before the run and
  /// not while particles enter. Throws std::invalid_argument, with the needed and the available memory, if the memory
  /// does not suffice. Neighbour lists need additional memory.
  void reserve(int particles) {
    if constexpr (detail::explain_population<P>()) state_.system.template body<Material>().reserve(particles);
  }
  /// Adds an inlet (openings/inlet.hpp), which opens at the beginning of the next step or run. `values` are the fields
  /// of entering particles, as for add(), except the velocity, which is that of the inlet. Throws std::invalid_argument
  /// for settings that are out of range. A run throws std::invalid_argument if entering particles would overlap with
  /// others.
  template <class... Fs, class... Values>
  void feed(Inlet<P::dim> const& inlet, Given<Fs, Values> const&... values) {
    static_assert(evolves_position, "inlets need a physics model that evolves the position of the material");
    static_assert(!OneOf<Velocity, Fields<Fs...>>, "the velocity of particles that enter is that of the inlet");
    if constexpr (detail::explain_population<P>()) {
      detail::static_check_given<P, Fs...>();
      detail::add_inlet(openings(), state_, inlet, values...);
    }
  }
  /// Adds a drain: particles of the material for which `within(i)` is true are removed, as by remove(). If any are
  /// removed, `receive(time, list)` is called with the time (s) and the identities, volumes and given fields of the
  /// removed particles. A particle is removed before it has moved by `reach` inside the drain, unless it moves farther
  /// in one step. Throws std::invalid_argument for settings that are out of range.
  template <class Condition, class... Fs, class Receive = detail::Ignore>
  void drain(Drain const& settings, Condition const& within, Fields<Fs...> = {}, Receive const& receive = {}) {
    if constexpr (detail::explain_population<P>()) {
      check_settings_of(within);
      using Handed = Merge<Fields<Identity, Volume>, Fields<Fs...>>;
      openings().add(settings, state_.support(), state_.system.half_skin(),
                     detail::emptied<Choices>(within, Handed{}, receive));
    }
  }
  /// Adds an open end (openings/open_end.hpp), through which particles leave with prescribed fields: values, or
  /// functions of the position (m) that can be called on a device.
  template <class... Fs, class... Values>
  void open_end(OpenEnd<P::dim> const& end, Given<Fs, Values> const&... values) {
    static_assert(OneOf<Held, material_fields<P>>,
                  "an open end keeps the velocity of particles that leave: the formulation needs "
                  "`using carries = Fields<Held>`");
    if constexpr (detail::explain_population<P>()) detail::add_open_end(openings(), state_, end, values...);
  }
  /// Returns the volume and the number of particles that entered through each inlet.
  std::vector<Passed> entered() const { return openings_ ? openings_->entered() : std::vector<Passed>(); }
  /// Returns the volume and the number of particles that left through each drain.
  std::vector<Passed> left() const { return openings_ ? openings_->left() : std::vector<Passed>(); }
  /// Attaches a component (run/component.hpp), which becomes active with the next step or run. Throws
  /// std::invalid_argument if the component is already attached.
  void attach(std::shared_ptr<Component<Solver>> component) {
    state_.busy.check_is_here();
    components_.attach(component);
    state_.limiters.push_back(std::move(component));
  }

  /// Computes the rates of the present state by the same passes as a step.
  void update_rates() { detail::update_rates(state_, false); }
  /// Runs the passes of the `diagnostics` of the formulation, which are for output only.
  void update_diagnostics() {
    ProfilingRegion const region("scree::diagnostics");
    run_passes(state_.system, detail::diagnostic_passes(settings().diagnostics, resolution(), settings().physics));
    if constexpr (has_rigid_bodies) state_.rigid.contact().add_to_walls(state_.system);
  }
  /// Returns the packing of the grains under pressure: the median and the 5 % and 95 % quantiles of the ratio of their
  /// number density to that at rest. The median is about 1 in beds and flows whose pressure follows the packing
  /// (docs/checks.md). Requires the stress among the fields of the material. All ranks of a case must call this
  /// function together. It runs its own neighbour search, so it is meant for output and not for each step.
  Packing packing() const {
    static_assert(has_stress, "packing() needs the stress of the material, which this formulation does not have");
    return detail::PositionChecks<Choices>::packing_under_pressure(state_.system, settings());
  }
  /// Returns the building blocks of time integrators for the present state.
  Stepper<Choices> stepper() { return Stepper<Choices>(state_); }

  /// Checks the present state as a run does: throws std::runtime_error if a value is not finite, and OutsideValidity if
  /// the state is outside the validity of the model. A run makes this check at its end and whenever it evaluates the
  /// limits of the time step, at least every 256 steps. The check takes one sweep over the particles.
  void check_validity() const { detail::limits_now(state_); }
  /// Runs the checks of the next step: of settings, positions, fields, walls and the limits of the time step. Throws as
  /// that step would. Starts the components, and runs those that are due, for example inlets. This function may be
  /// called before a run to find errors before anything irreversible is done, for instance before earlier results are
  /// replaced. The run makes the same checks again, and its results do not change.
  void check_start() {
    begin();
    if (steps() == 0) return detail::check_step(state_);
    Snapshot const before = snapshot();  // the next step reads what the last one left in fields that passes write
    detail::check_step(state_);
    restore(before);
  }
  /// Advances by one step of at most `longest` (s); returns its length. Throws std::invalid_argument unless `longest`
  /// is positive; `longest` may be infinite if the physics model limits the step. Throws std::logic_error as run()
  /// does.
  double step(double longest) {
    check_setting(longest > 0, "the length of a step (s)", longest, "above 0");
    detail::Busy::Hold const hold(state_.busy);
    begin();
    double const dt = take_step(longest);
    components_.act(*this);
    return dt;
  }
  /// Runs until the given time (s), or until `stop`, which is called after each step, returns true; calls each observer
  /// at its times. If `asks` is given, `stop` is called only after steps for which `asks` returns true; on a GPU this
  /// saves a synchronization in each step. If the case has several ranks and one of these functions returns true on one
  /// rank, this holds for all ranks, so that all stop after the same step. Throws std::invalid_argument for a time that
  /// is negative or NaN, for an infinite time without `stop`, and if the steps have become so short that the run would
  /// not end. Throws std::logic_error if the solver is already advancing, either on another thread or in a run whose
  /// observer makes this call, and if the solver was moved from.
  void run(double until, Observers const& observers = {}, std::function<bool(Solver const&)> const& stop = {},
           std::function<bool()> const& asks = {}) {
    check_setting(until >= 0 && (stop || std::isfinite(until)), "the end of a run (s)", until,
                  "0 or more, and finite without a `stop`");
    detail::Busy::Hold const hold(state_.busy);
    if (time() < until) begin();
    RunEnds ends(until);
    if (steps() == 0 && !observers.empty()) detail::check_settings_once(state_), update_rates();
    Schedule<Solver> schedule(observers, *this);
    detail::Trials trials(state_);
    long const steps_before = steps();
    while (time() < until) {
      double const target = schedule.next(until);
      if (!trials.step([&] { take_step_towards(target); }, !state_.sorts_now())) continue;
      bool const may_stop = trials.ask([&] {
        ends.check_after_step(time(), state_.clock.control.deciding());
        return stop && (!asks || whole_case().anywhere(asks()));
      });
      bool const is_due = trials.ask([&] { return components_.due(*this); });
      if ((may_stop || is_due || has_come(target, time())) && !trials.become_certain()) continue;
      if (is_due) components_.act(*this);
      schedule.act(*this);
      if (may_stop && whole_case().anywhere(stop(*this))) break;
    }
    if (steps() > steps_before) check_validity();
  }

  // These overloads accept arguments of wrong types, and report the mistake at compile time.
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

  /// Returns everything that the next step needs; a solver made from the same settings and particles continues from it
  /// bit for bit. Throws as check_finite() does: no run can continue from a state that is not finite, and its snapshot
  /// must not overwrite a good one. If the case has several ranks, all ranks must call this function together, and each
  /// gets the snapshot of the whole case.
  Snapshot snapshot() const { return detail::snapshot_with(components_, state_); }
  /// Sets the solver to the state of a snapshot. Throws std::runtime_error, and leaves the solver unchanged, if the
  /// snapshot is of another formulation or number of particles, if the motion is given by group and the groups differ,
  /// or if the snapshot has other inlets, drains or components than the solver; these must be added to the solver
  /// before this call. The next step throws std::invalid_argument if the motion would put the walls elsewhere. If the
  /// case has several ranks, all ranks must restore the same snapshot, which may come from any number of ranks.
  void restore(Snapshot const& snapshot) { detail::restore_with(components_, *this, state_, snapshot); }

 private:
  friend State;

  /// Starts the components that have not started, and calls those that are due before the next step.
  void begin() {
    if (components_.empty()) return;
    detail::check_start_once(state_);
    components_.act(*this);
  }
  /// Takes one step, without the actions of components between steps.
  double take_step(double longest) {
    ProfilingRegion const region("scree::step");
    double const dt = detail::take_step(state_, longest);
    components_.after_step(*this);
    return dt;
  }
  void take_step_towards(double target) {
    double const dt = take_step(target - time());
    if (target - time() < 1e-6 * dt) state_.clock.time = target;
  }
  void particles_changed() {
    state_.particles_changed();
    evaluate_again();
  }
  /// Evaluates the rates again after the state was changed between steps, including rates that are otherwise computed
  /// only at certain steps.
  void evaluate_again() {
    if (state_.started && !state_.restoring) detail::update_rates(state_, true);
  }
  Openings& openings() {
    if (!openings_) attach(openings_ = std::make_shared<Openings>());
    components_.ask_again(*openings_);
    return *openings_;
  }

  State state_;
  detail::Components<Solver> components_;
  std::shared_ptr<Openings> openings_;
};

}  // namespace scree

#include "solver_of_mistake.hpp"  // a specialisation
