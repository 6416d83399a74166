// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../run/observer.hpp"
#include "../system/trials.hpp"
#include "population.hpp"
#include "refused.hpp"
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

/// Advances one formulation in time: makes it from particles, runs it, saves and restores its state. It only combines
/// parts that can be used on their own: passes, an integrator, a motion, components.
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
  static constexpr bool has_stress = OneOf<Stress, material_fields<P>>;  // of the material
  static constexpr bool has_rigid_bodies = detail::has_rigid_bodies<typename P::bodies>;
  static constexpr bool has_ranks = detail::DividesCase<typename P::template ghosts<Basis>>;

  /// Makes the solver from positions (m) of material and walls; every particle gets the volume spacing^dim. Everything
  /// runs on the given instance of the execution space.
  Solver(Space const& space, SolverSettings<P> const& settings, std::vector<vector> const& material,
         std::vector<vector> const& wall = {})
      : Solver(space, settings, particles_of<Material>(material), particles_of<Wall>(wall)) {}
  /// Makes the solver from named groups (fields/groups.hpp) of the material, the walls, or both. Bodies that carry
  /// `group` get the numbers of these groups. Throws std::invalid_argument if the motion is by group and does not know
  /// one of them. Points may also be shares (fields/shared_points.hpp), where each rank of a case gives its own, then
  /// for all bodies.
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::are_no_vectors<vector, A, B>)
      Solver(Space const& space, SolverSettings<P> const& settings, A const& material, B const& wall = {},
             detail::PointsFit<vector, A, B> = {})
      : Solver(space, settings, particles_of<Material>(material), particles_of<Wall>(wall)) {}
  /// Made from the particles of each body, in any order: `Solver<F>(settings, particles_of<Soil>(points), ...)`.
  template <class... Tags, class... Points>
  requires(sizeof...(Tags) > 0)
      Solver(Space const& space, SolverSettings<P> const& settings, ParticlesOf<Tags, Points> const&... particles)
      : state_(detail::state_at_start<Choices>(space, detail::starts<typename P::bodies, vector>(particles...),
                                               settings)) {}
  /// Makes the solver on the default instance of the execution space.
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
  /// Takes arguments that no other constructor takes, so that the compiler prints a sentence and not a list of
  /// constructors.
  template <Label mistake =
                "the settings or points do not fit: each name in the braces must be a member of SolverSettings, in the "
                "order of its members; with SolverSettings<F>{...} for {...} the compiler says which one is wrong">
  explicit Solver(...) = delete;  // SolverSettings<F>{...} for {...}: the compiler then says which name is wrong

  Solver(Solver&&) = default;
  Solver& operator=(Solver&& other) {
    if (this != &other)
      state_ = std::move(other.state_), components_ = std::move(other.components_),
      openings_ = std::move(other.openings_);
    return *this;
  }
  Solver(Solver const&) = delete;  // a copy would share the fields; another solver can restore() this one's snapshot()

  /// The particles of a body, of the material, of the walls.
  template <BodyTag Body>
  auto const& body() const {
    return state_.system.template body<Body>();
  }
  /// The body of grains, with the numbers and arrays of its fields.
  auto const& material() const { return body<Material>(); }
  /// The body of wall particles, in the same way.
  auto const& wall() const { return body<Wall>(); }
  /// A body of the whole case in the present state, wherever its particles are (fields/whole_body.hpp).
  template <BodyTag Body = Material>
  auto whole() const {
    return state_.system.template whole<Body>(time());
  }
  /// The execution space in which all loops of the solver run.
  Space const& space() const { return state_.system.space(); }
  /// The present time, s.
  double time() const { return state_.clock.time; }
  /// The number of steps since the start.
  long steps() const { return state_.clock.steps; }
  /// The number of builds of the neighbour lists.
  long neighbour_builds() const { return state_.system.neighbour_builds(); }
  /// What is true of the whole case: WholeCase (core/whole_case.hpp), or what ranks() is.
  auto const& whole_case() const { return state_.system.whole_case(); }
  /// The ranks of a case that may have several: OtherRanks of one body.
  auto const& ranks() const { return whole_case(); }
  /// The number of times that a run on a GPU repeated steps because neighbour lists expired earlier than expected.
  long failed_trials() const { return state_.system.failed_trials(); }
  /// The number of steps that each limit has set, as the smallest one.
  std::map<std::string, long> const& limits() const { return state_.clock.control.counts(); }
  /// A note if the motion, the rigid bodies or a component required steps below a tenth of those of the physics model:
  /// the first of them, with both steps (s); "" if there was none. Progress prints it once.
  std::string const& note_on_steps() const { return state_.note_on_steps; }
  /// The settings that the solver was made with, with the motion that set_motion() gave it last. Their class is that of
  /// the choices of P: `auto const&` follows set_motion(), a SolverSettings<P> made from them is a copy.
  SolverSettings<Choices> const& settings() const { return state_.settings; }
  /// Spacing, smoothing length and support of the kernel, m, and sums over the initial lattice.
  Resolution resolution() const { return state_.resolution(); }
  /// The number of particles that the solver was made with.
  long particles_at_start() const { return state_.at_start; }
  /// The numbers of particles that were added to and removed from the material, on all ranks: the number at the start +
  /// added - removed is the number now.
  Turnover const& turnover() const { return state_.system.template turnover<Material>(); }
  /// The number of particles farther than a support beyond walls and initial material, below or to a side of them, on
  /// all ranks together. Zero without walls and where positions are prescribed; directions along periods do not count.
  long lost() const {
    if constexpr (evolves_position) return detail::number_beyond(state_.system, state_.nothing_lost());
    return 0;
  }

  /// Sets a field of a body from a function of points, one per particle (host). The function must return a value: an
  /// Eigen expression would outlive the values it refers to. Throws std::invalid_argument for slip normals that
  /// SlipNormal::check_on_wall() refuses, for volumes that are not above 0 or, during a run, fit the distances between
  /// the particles less than before (see `start_checks`), for identities that are negative or given twice.
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
  /// Sets a field of a body from a function of the present positions.
  template <class Body = Material, Field F, class Function>
  void set(F field, Function const& function) {
    set<Body>(field, body<Body>().to_host(fields::position), function);
  }
  // With any other argument the compiler says what a field is.
  template <class Body = Material, class Name, class... Others>
  requires(!Field<Name>) void set(Name const&, Others const&...) {
    static_assert(sizeof(Name) == 0, "set() takes a field as an object: set(fields::velocity, function)");
  }
  /// Continues with another motion of the walls, which must give them their present positions; their velocity may jump.
  /// Call it between steps, as in Component::act(). Throws std::invalid_argument if a particle would jump; after
  /// restore() the next step throws it. Snapshots do not contain the motion: the code that changes it also restores it.
  void set_motion(typename P::motion const& motion) { detail::set_motion(state_, motion); }

  /// Adds particles to the material, with new identities:
  ///   solver.add(points, given(fields::velocity, u), given(fields::concentration, [](auto const& x) { return ...; }));
  /// Each gets the volume spacing^dim unless that is given; other fields that are not given are zero. Throws
  /// std::invalid_argument, and adds none, if they overlap with others or with walls, or if their distances or volumes
  /// do not fit the spacing (see `start_checks`). Call it between steps, in an observer for example. Rates are
  /// evaluated again.
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
  // With any other points the compiler says what is wrong with them.
  template <class Points, class... Others>
  requires(!std::is_convertible_v<Points const&, std::vector<vector> const&>) void add(Points const&,
                                                                                       Others const&...) {
    static_assert(!detail::explain_points<Points, vector>(), "add() takes plain points: give the points() of groups");
  }
  /// Removes the particles of the material for which `condition(i)` is true, a function of a particle with `reads`
  /// like a term. Returns the fields of a list of those removed (host); the number of them is its size. Call it between
  /// steps. Throws std::invalid_argument for a condition whose `check()` does: a plane without a normal, an empty
  /// block.
  template <class Condition, class... Fs>
  auto remove(Condition const& condition, Fields<Fs...> fields = {}) {
    if constexpr (detail::explain_population<P>()) {
      check_settings_of(condition);
      auto const removed = detail::remove_particles(state_, condition, fields);
      if (!removed.empty()) particles_changed();
      return removed;
    }
  }
  /// Reserves memory for a number of particles of the material, so that a lack of memory is reported before a run in
  /// which they enter. Throws std::invalid_argument with the needed and the available memory. Neighbour lists need
  /// more.
  void reserve(int particles) {
    if constexpr (detail::explain_population<P>()) state_.system.template body<Material>().reserve(particles);
  }
  /// Opens an inlet (openings/inlet.hpp) when the next step or run begins. `values` are given to the particles that
  /// enter, as for add(); the inlet gives their velocity. Throws std::invalid_argument for settings that are out of
  /// range. A run throws it if other particles are in the way of those that enter.
  template <class... Fs, class... Values>
  void feed(Inlet<P::dim> const& inlet, Given<Fs, Values> const&... values) {
    static_assert(evolves_position, "inlets need a physics model that evolves the position of the material");
    static_assert(!OneOf<Velocity, Fields<Fs...>>, "the velocity of particles that enter is that of the inlet");
    if constexpr (detail::explain_population<P>()) {
      detail::static_check_given<P, Fs...>();
      detail::add_inlet(openings(), state_, inlet, values...);
    }
  }
  /// Opens a drain: particles of the material for which `within(i)` is true are removed, as by remove(), and
  /// `receive(time, list)` is called with the time (s) and their identities, volumes and `fields`, unless there are
  /// none. A particle is removed before it has moved by `reach` in the drain, or by more than that in one step. Throws
  /// std::invalid_argument for settings that are out of range.
  template <class Condition, class... Fs, class Receive = detail::Ignore>
  void drain(Drain const& settings, Condition const& within, Fields<Fs...> = {}, Receive const& receive = {}) {
    if constexpr (detail::explain_population<P>()) {
      check_settings_of(within);
      using Handed = Merge<Fields<Identity, Volume>, Fields<Fs...>>;
      openings().add(settings, state_.support(), state_.system.half_skin(),
                     detail::emptied<Choices>(within, Handed{}, receive));
    }
  }
  /// Opens an end (openings/open_end.hpp) where particles leave with given fields: values, or functions of the position
  /// (m) that a device can call.
  template <class... Fs, class... Values>
  void open_end(OpenEnd<P::dim> const& end, Given<Fs, Values> const&... values) {
    static_assert(OneOf<Held, material_fields<P>>,
                  "an open end keeps the velocity of particles that leave: the formulation needs "
                  "`using carries = Fields<Held>`");
    if constexpr (detail::explain_population<P>()) detail::add_open_end(openings(), state_, end, values...);
  }
  /// The volume and number that entered through each inlet.
  std::vector<Passed> entered() const { return openings_ ? openings_->entered() : std::vector<Passed>(); }
  /// The volume and number that left through each drain.
  std::vector<Passed> left() const { return openings_ ? openings_->left() : std::vector<Passed>(); }
  /// Attaches a component (run/component.hpp), which takes part from the next step or run on. Throws
  /// std::invalid_argument if it is attached already.
  void attach(std::shared_ptr<Component<Solver>> component) {
    state_.busy.check_is_here();
    components_.attach(component);
    state_.limiters.push_back(std::move(component));
  }

  /// Evaluates all passes for the present state, as at the beginning of a step.
  void update_rates() { detail::update_rates(state_, false); }
  /// Evaluates the passes `diagnostics` of the formulation, which are only for output.
  void update_diagnostics() {
    ProfilingRegion const region("scree::diagnostics");
    run_passes(state_.system, detail::diagnostic_passes(settings().diagnostics, resolution(), settings().physics));
    if constexpr (has_rigid_bodies) state_.rigid.contact().add_to_walls(state_.system);
  }
  /// The packing of the grains that carry pressure: the median of the number density over that at rest, and the values
  /// of the loosest and the densest twentieth. It is about 1 in beds and flows whose pressure follows the packing
  /// (docs/checks.md). Needs the stress among the fields of the material. All ranks of a case call it together. It
  /// searches neighbours of its own: for output, not for each step.
  Packing packing() const {
    static_assert(has_stress, "packing() needs the stress of the material, which this formulation does not have");
    return detail::PositionChecks<Choices>::packing_under_pressure(state_.system, settings());
  }
  /// The operations that integrators are made of, for the present state.
  Stepper<Choices> stepper() { return Stepper<Choices>(state_); }

  /// Checks the present state like a run: throws std::runtime_error if a value is not finite, OutsideValidity if the
  /// state is outside the validity of the model. A run makes this check together with the limits of the step, at least
  /// every 256 steps, and at its end. One sweep over the particles.
  void check_validity() const { detail::limits_now(state_); }
  /// Makes the checks of the next step: settings, positions, fields, walls and limits of the step. Throws as the step
  /// would; components start, and act where they are due, as inlets do. Call it before a run to do what must not be
  /// done for a case that is refused, for instance before earlier results are replaced. The run makes the same checks
  /// again, and its results do not change.
  void check_start() {
    begin();
    if (steps() == 0) return detail::check_step(state_);
    Snapshot const before = snapshot();  // the next step reads what the last one left in fields that passes write
    detail::check_step(state_);
    restore(before);
  }
  /// Advances by one step of at most `longest` (s); returns its length. Throws std::invalid_argument unless `longest`
  /// is positive; it may be infinite if the physics model limits the step. Throws std::logic_error as run() does.
  double step(double longest) {
    check_setting(longest > 0, "the length of a step (s)", longest, "above 0");
    detail::Busy::Hold const hold(state_.busy);
    begin();
    double const dt = take_step(longest);
    components_.act(*this);
    return dt;
  }
  /// Runs until the given time (s), calling each observer at its times, or until `stop`, called after each step,
  /// returns true. If `asks` is given, `stop` is called only if `asks` returns true, which saves a wait in each step on
  /// a GPU. Several ranks of a case continue together: both hold for all if they hold for one. Throws
  /// std::invalid_argument for a time that is negative or NaN, for an infinite one without `stop`, and when steps have
  /// become so short that the run would not end. Throws std::logic_error if the solver is advancing already, in a run
  /// whose observer calls it or on another thread, and if it was moved from.
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
  /// snapshot. On several ranks all make it together, and get that of the whole case.
  Snapshot snapshot() const { return detail::snapshot_with(components_, state_); }
  /// Throws std::runtime_error, and leaves the solver unchanged, if the snapshot is of another formulation or number of
  /// particles, if the motion is by group and the groups differ, or if it has other inlets, drains and components,
  /// which this solver must have been given before. The next step throws std::invalid_argument if the motion would put
  /// the walls elsewhere. On several ranks all restore the same snapshot, which may come from any number of ranks.
  void restore(Snapshot const& snapshot) { detail::restore_with(components_, *this, state_, snapshot); }

 private:
  friend State;

  /// Starts components, and calls those that are due before the next step.
  void begin() {
    if (components_.empty()) return;
    detail::check_start_once(state_);
    components_.act(*this);
  }
  /// One step, without the actions of components between steps.
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
  /// For a state that was changed between steps. Rates that are due at certain steps only are of the former state.
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

/// The solver of a formulation with a mistake: the compiler has said which, and says little of the rest of the program.
template <class P>
requires(!detail::explain_formulation<P>()) class Solver<P> : public Solver<detail::StandIn<P>> {
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
