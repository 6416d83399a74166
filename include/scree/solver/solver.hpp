// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/records.hpp"
#include "../integrators/update.hpp"
#include "../openings/openings.hpp"
#include "../rigid/rigid_part.hpp"
#include "added.hpp"
#include "body_at_start.hpp"
#include "followers.hpp"
#include "limit.hpp"
#include "observer.hpp"
#include "pick.hpp"
#include "settings.hpp"
#include "snapshot_of.hpp"
#include "unset_fields.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace scree {
/// Advances one formulation in time. It only combines parts that can be used on their own: passes, an integrator, a
/// motion.
template <class P>
class Solver {
  static_assert(detail::explain_formulation<P>());

 public:
  using policy = P;
  using Basis = basis_of<P>;
  using vector = Vec<P::dim, typename P::real>;
  using Observers = std::vector<Observer<Solver>>;
  using Evolved = evolved_fields<typename P::physics::evolves>;
  static constexpr bool evolves_position = detail::evolves_position<P>;
  static constexpr bool has_rigid_bodies = detail::has_rigid_bodies<typename P::bodies>;

  using Space = typename P::space;
  /// Everything runs on this instance of the execution space. Positions in m; every particle gets the volume
  /// spacing^dim.
  Solver(Space const& space, SolverSettings<P> const& settings, std::vector<vector> const& material,
         std::vector<vector> const& wall = {})
      : Solver(space, settings, particles_of<Material>(material), particles_of<Wall>(wall)) {}
  /// The same with named groups (setup/groups.hpp) for the material, the walls, or both. Bodies that carry `group` get
  /// the numbers of these groups. Throws std::invalid_argument if the motion is by group and does not know one of them.
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::is_groups<A> || detail::is_groups<B>)
      Solver(Space const& space, SolverSettings<P> const& settings, A const& material, B const& wall = {})
      : Solver(space, settings, particles_of<Material>(material), particles_of<Wall>(wall)) {}
  /// Made from the particles of each body, in any order: `Solver<F>(settings, particles_of<Soil>(points), ...)`.
  template <class... Tags, class... Points>
  requires(sizeof...(Tags) > 0)
      Solver(Space const& space, SolverSettings<P> const& settings, ParticlesOf<Tags, Points> const&... particles)
      : Solver(space, detail::starts<typename P::bodies, vector>(particles...), settings) {}
  /// All these on the default instance.
  Solver(SolverSettings<P> const& settings, std::vector<vector> const& material, std::vector<vector> const& wall = {})
      : Solver(Space(), settings, material, wall) {}
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::is_groups<A> || detail::is_groups<B>)
      Solver(SolverSettings<P> const& settings, A const& material, B const& wall = {})
      : Solver(Space(), settings, material, wall) {}
  template <class... Tags, class... Points>
  requires(sizeof...(Tags) > 0) explicit Solver(SolverSettings<P> const& settings,
                                                ParticlesOf<Tags, Points> const&... particles)
      : Solver(Space(), settings, particles...) {}

  Solver(Solver&&) = default;
  Solver& operator=(Solver&&) = default;
  Solver(Solver const&) = delete;  // a copy would share the fields; another solver can restore() this one's snapshot()

  template <BodyTag Body>
  auto const& body() const {
    return system_.template body<Body>();
  }
  auto const& material() const { return body<Material>(); }
  auto const& wall() const { return body<Wall>(); }
  Space const& space() const { return system_.space(); }
  double time() const { return time_; }
  long steps() const { return steps_; }
  long neighbour_builds() const { return system_.neighbour_builds(); }
  /// How often a run on a GPU repeated steps because neighbour lists expired earlier than expected.
  long failed_trials() const { return system_.failed_trials(); }
  std::map<std::string, long> const& limits() const { return control_.counts(); }
  SolverSettings<P> const& settings() const { return settings_; }
  Resolution resolution() const {
    double const h = settings_.smoothing * settings_.spacing;
    return {.dimensions = P::dim,
            .spacing = settings_.spacing,
            .smoothing_length = h,
            .support = support(),
            .lattice_sum = lattice_sum_,
            .surface_asymmetry = surface_asymmetry_,
            .steps = steps_};
  }

  /// Sets a field of a body from a function of points, one per particle (host). The function must return a value: an
  /// Eigen expression would outlive the values it refers to. Throws std::invalid_argument for slip normals that
  /// SlipNormal::check_on_wall() refuses.
  template <class Body = Material, Field F, class Points, class Function>
  void set(F field, Points const& points, Function const& function) {
    static_assert(!detail::is_expression<std::remove_cvref_t<decltype(function(*points.begin()))>>,
                  "the function given to set() must return a value, not an expression of Eigen: add .eval() to it");
    std::vector<value_t<P, F>> values;
    values.reserve(points.size());
    for (auto const& x : points) values.push_back(function(x));
    static_assert(!OneOf<F, detail::fields_to_move<P, Body>>,
                  "the motion of this body is by group, so its groups are fixed: make the solver from `Groups`");
    static_assert(EvolvingBody<Body> || !OneOf<F, detail::GivenByMotion>,
                  "the motion gives this field of a wall, so that a value would be overwritten: change the motion, or "
                  "set `rest_position`");
    static_assert(!RigidTag<Body> || (!detail::is_checked_on_wall<F> && !std::is_same_v<F, RestPosition>),
                  "a rigid body turns, so its particles can neither slip along a direction fixed in space nor get "
                  "other rest positions");
    if constexpr (FollowingBody<Body> && !RigidTag<Body> && detail::is_checked_on_wall<F>)
      detail::check_on_wall<F>(motion_of_body<Body>(settings_.motion), body<Body>(), values);
    system_.template body<Body>().from_host(field, values);
    control_.look_before(steps_);
    if constexpr (std::is_same_v<F, Position>) system_.positions_changed();
    if constexpr (std::is_same_v<F, Position> && EvolvingBody<Body>) followers_.confines().add_material(values);
    if constexpr (std::is_same_v<F, RestPosition> && !RigidTag<Body>)
      followers_.template add<Body>(system_, settings_.motion, values);
  }
  /// The same with the present positions.
  template <class Body = Material, Field F, class Function>
  void set(F field, Function const& function) {
    set<Body>(field, system_.template body<Body>().to_host(position), function);
  }

  /// Adds particles to the material, with new identities:
  ///   solver.add(points, given(velocity, u), given(concentration, [](auto const& x) { return ...; }));
  /// Each gets the volume spacing^dim unless that is given; other fields that are not given are zero. Throws
  /// std::invalid_argument, and adds none, if they overlap with others or with walls (see `start_checks`). Call it
  /// between steps, in an observer for example. Rates are evaluated again.
  template <class... Fs, class... Values>
  void add(std::vector<vector> const& points, Given<Fs, Values> const&... values) {
    detail::static_check_given<P, Fs...>();
    if (points.empty()) return;
    place(points, {"among those to be added,", " of those that are there"}, values...);
    particles_changed();
  }
  /// Removes the particles of the material for which `condition(i)` is true, a function of a particle with `reads`
  /// like a term. Returns the fields of a list of those removed (host); the number of them is its size. Call it between
  /// steps.
  template <class Condition, class... Fs>
  auto remove(Condition const& condition, Fields<Fs...> fields = {}) {
    auto const removed = take_out(condition, fields);
    if (!removed.empty()) particles_changed();
    return removed;
  }
  /// Makes room for so many particles of the material, so that a lack of memory shows before a run in which they enter.
  /// Throws std::invalid_argument with the memory that they need and what is there. Neighbour lists need more.
  void reserve(int particles) { system_.template body<Material>().reserve(particles); }
  /// Opens an inlet (openings/inlet.hpp) when the next step or run begins. `values` are those of the particles that
  /// enter, as for add(); the inlet gives their velocity. Throws std::invalid_argument for settings that are out of
  /// range; a run throws it if particles are in the way of those that enter.
  template <class... Fs, class... Values>
  void feed(Inlet<P::dim> const& inlet, Given<Fs, Values> const&... values) {
    static_assert(evolves_position, "inlets need a physics model that evolves the position of the material");
    static_assert(!OneOf<Velocity, Fields<Fs...>>, "the velocity of particles that enter is that of the inlet");
    detail::static_check_given<P, Fs...>();
    static constexpr bool can_hold = OneOf<Held, material_fields<P>>;
    if (inlet.pushes && !can_hold)
      throw std::invalid_argument("scree: inlet '" + inlet.name +
                                  "' pushes, so the formulation needs `using carries = Fields<Held>`; without it set "
                                  "`.pushes = false`");
    vector const u = inlet.velocity.template cast<typename P::real>();
    openings_.add(
        inlet, settings_.spacing, support(),
        [=](Solver& now, std::vector<Vec<P::dim, double>> const& layer, int number) {
          std::vector<vector> points;
          for (auto const& x : layer) points.push_back(x.template cast<typename P::real>());
          StartWords const words{"among those that enter,", " of those that are there", true};
          if constexpr (can_hold)
            return now.place(points, words, given(velocity, u), given(held, number), values...);
          else
            return now.place(points, words, given(velocity, u), values...);
        },
        [](Solver& now, int number, Vec<P::dim, double> const& direction, double beyond) {
          if constexpr (can_hold)
            for_each_particle<Basis>(
                "scree::let_go", now.system_.template body<Material>(),
                detail::Release<vector>{number, direction.template cast<typename P::real>(), typename P::real(beyond)});
        });
  }
  /// Opens a drain: particles of the material for which `within(i)` is true are removed, as by remove(), and
  /// `receive(time, list)` is called with the time (s) and their identities, volumes and `fields`, unless there are
  /// none. A particle is removed before it has moved by `reach` in the drain, or by more than that in one step.
  template <class Condition, class... Fs, class Receive = detail::Ignore>
  void drain(Drain const& settings, Condition const& within, Fields<Fs...> = {}, Receive const& receive = {}) {
    using Handed = Merge<Fields<Identity, Volume>, Fields<Fs...>>;
    openings_.add(settings, support(), system_.half_skin(), [=](Solver& now, Passed& passed) {
      auto const gone = now.take_out(within, Handed{});
      for (auto const& each : gone) passed.volume += double(each[volume]);
      passed.particles += long(gone.size());
      if (!gone.empty()) receive(now.time(), gone);
    });
  }
  /// What has come through each inlet, and gone through each drain.
  std::vector<Passed> entered() const { return openings_.entered(); }
  std::vector<Passed> left() const { return openings_.left(); }
  /// The number of particles that the solver was made with.
  long particles_at_start() const { return at_start_; }
  /// How many particles of the material came and went: the number at the start + added - removed = material().size().
  Turnover const& turnover() const { return system_.template turnover<Material>(); }

  /// Evaluates all passes for the present state, as at the beginning of a step.
  void update_rates() {
    ProfilingRegion const region("scree::rates");
    run_passes(system_, rate_passes(settings_.physics, resolution()));
    update_rigid_forces();
  }

  /// Evaluates the passes that are only for output.
  void update_diagnostics() {
    ProfilingRegion const region("scree::diagnostics");
    run_passes(system_, detail::diagnostic_passes(settings_.diagnostics, resolution(), settings_.physics));
  }

  /// Checks the present state like a run: throws std::runtime_error if a value is not finite, OutsideValidity if the
  /// state is outside the validity of the model. A run makes this check together with the limits of the step, at least
  /// every 256 steps, and at its end. One sweep over the particles.
  void check_validity() const { limits_now(); }
  /// The number of particles farther than a support beyond walls and initial material, below or to a side of them. Zero
  /// without walls; directions along periods do not count.
  long lost() const { return static_cast<long>(survey(material(), Fields<>{}, nothing_lost()).largest[0].beyond); }

  /// Advances by one step of at most `longest` (s); returns its length. Throws std::invalid_argument unless `longest`
  /// is positive; it may be infinite if the physics model limits the step.
  double step(double longest) {
    check_setting(longest > 0, "the length of a step (s)", longest, "above 0");
    open();
    double const dt = step_closed(longest);
    if (openings_.due(time_, neighbour_builds())) serve_openings();
    return dt;
  }

  /// Building blocks of integrators: the step that the present state and rates allow, at most `longest` (s);
  double choose_step(double longest) {
    static_assert(HasLimits<typename P::physics>,
                  "`physics` needs a function `limits(resolution)`: a tuple of limits of the step, which may be empty");
    static_assert(detail::are_limits<decltype(settings_.physics.limits(resolution()))>,
                  "`limits(resolution)` of `physics` returns a tuple of what limit() returns");
    if (control_.must_look(steps_)) {
      followers_.check(settings_.motion, time_);
      auto limits = limits_now();
      limits.push_back({"motion", settings_.motion.time_step(), TimeStepLimit::never});
      if constexpr (has_rigid_bodies) limits.push_back(rigid_.limit(system_, settings_.spacing));
      control_.look(limits, steps_);
    }
    return control_.choose(longest);
  }
  /// an update of the rigid bodies, if there are any, by the forces of the rates that were evaluated last; their
  /// particles follow with the next update of the material;
  void advance_rigid([[maybe_unused]] RigidStep const& step) {
    if constexpr (has_rigid_bodies) rigid_.advance(system_, settings_.physics, step);
  }
  /// and an update of the material, a function of one particle, to the time `after` the beginning of the step (s).
  template <class Function>
  void update(Function const& function, double before, double after) {
    update(function, detail::projections_of(settings_.physics, resolution()), before, after);
  }
  /// The same separately, for staggered integrators: the stages of the physics model, in order;
  auto stages() const { return settings_.physics.stages(resolution()); }
  /// the rates of one of them or of all;
  template <class Stage>
  void evaluate(Stage const& stage) {
    run_passes(system_, stage.passes);
    if constexpr (OneOf<Velocity, evolved_fields<typename Stage::evolves>>) update_rigid_forces();
  }
  template <class... Stages>
  void evaluate(std::tuple<Stages...> const& all) {
    std::apply([&](Stages const&... each) { (evaluate(each), ...); }, all);
  }
  /// an update;
  template <class Function>
  void apply(Function const& function) {
    for_each_particle<Basis>("scree::update", system_.template body<Material>(), detail::holding<Carried>(function));
    if constexpr (OneOf<Position, writes_of<Function>>) system_.positions_changed();
  }
  /// the projections, which return the updated state to the admissible set;
  template <class Stage>
  void project(Stage const& stage) {
    run_passes(system_, stage.projections);
  }
  /// these three over a time (s), in one sweep if no neighbour reads the updated fields; walls move with the positions;
  template <class Stage>
  void advance(Stage const& stage, double dt) {
    ProfilingRegion const region("scree::stage");
    using OfStage = typename Stage::evolves;
    auto const function = detail::holding<Carried>(staggered_update<Basis>(OfStage{}, dt));
    constexpr bool kicks = has_rigid_bodies && OneOf<Velocity, evolved_fields<OfStage>>;
    if constexpr (OneOf<Position, evolved_fields<OfStage>>) {
      evaluate(stage);
      if constexpr (kicks) advance_rigid({.kick = dt, .drift = dt});
      update(function, stage.projections, 0, dt);
    } else if constexpr (kicks) {  // the reactions need the velocities before the update
      evaluate(stage);
      advance_rigid({.kick = dt, .drift = dt});
      apply(function);
      project(stage);
    } else if constexpr (detail::are_point_passes<Material, decltype(stage.projections)>) {
      run_passes_and<Material>(system_, stage.passes, with_point_passes<Basis>(function, stage.projections));
    } else {
      run_passes_and<Material>(system_, stage.passes, function);
      project(stage);
    }
  }
  /// and the motion between two times since the beginning of the step (s). Walls follow it; so does the material unless
  /// its position evolves.
  void move(double before, double after) {
    if constexpr (!evolves_position)
      for_each_particle<Basis>("scree::move_material", system_.template body<Material>(),
                               detail::Displace<body_motion<P, Material>>{motion_of_body<Material>(settings_.motion),
                                                                          time_ + before, time_ + after});
    detail::Followers<P>::move(system_, settings_.motion, time_ + after);
    place_rigid();
    system_.positions_changed();
  }

  /// Runs until the given time (s), calling each observer at its times, or until `stop`, called after each step,
  /// returns true. `asks` saves a GPU a wait in each step: `stop` is called only if `asks`, where given, returns true.
  /// Throws std::invalid_argument for a time that is negative or NaN, for an infinite one without `stop`, and when
  /// steps have become so short that the run would not end.
  void run(double until, Observers const& observers = {}, std::function<bool(Solver const&)> const& stop = {},
           std::function<bool()> const& asks = {}) {
    check_setting(until >= 0 && (stop || std::isfinite(until)), "the end of a run (s)", until,
                  "0 or more, and finite without a `stop`");
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
        return stop && (!asks || asks());
      });
      bool const serves = openings_.due(time_, neighbour_builds());
      if ((may_stop || serves || has_come(target, time_)) && !certain()) continue;
      if (serves) serve_openings();
      schedule.act(*this);
      if (may_stop && stop(*this)) break;
    }
    if (steps_ > steps_before) check_validity();
  }

  /// Everything that the next step needs; a solver made from the same settings and particles continues from it bit for
  /// bit. Throws as check_finite() does: no run can continue from such a state, and it must not overwrite a good
  /// snapshot.
  Snapshot snapshot() const {
    ProfilingRegion const region("scree::snapshot");
    check_finite(material(), Evolved{}, steps_);
    Snapshot result = snapshot_of(system_);
    result.signature += openings_.signature();
    openings_.add_to(result);
    result.time = time_;
    result.steps = steps_;
    if (turnover().added > 0)
      result.arrays.push_back(
          detail::filled(detail::head_of<vector>("confines/material", "m"), followers_.confines().material()));
    add_counters(result, "step limits", control_.counts());
    result.counters["next look at step limits"] = control_.next_look();
    return result;
  }
  /// Throws std::runtime_error if the snapshot is of another formulation or number of particles, if the motion is by
  /// group and the groups differ, or if it has other inlets and drains, which this solver must have been given before.
  void restore(Snapshot const& snapshot) {
    ProfilingRegion const region("scree::restore");
    detail::require_same_groups_in<P>(snapshot, system_);
    restore_into(system_, snapshot, openings_.signature());
    openings_.restore(snapshot);
    if (turnover().added > 0)
      followers_.confines().add_material(detail::values_of<vector>(
          detail::matching_array(snapshot, detail::head_of<vector>("confines/material", "m"))));
    started_ = true;
    time_ = snapshot.time;
    steps_ = snapshot.steps;
    auto const next_look = snapshot.counters.find("next look at step limits");
    control_.restore(counters_of(snapshot, "step limits"),
                     next_look == snapshot.counters.end() ? 0 : next_look->second);
  }

 private:
  using AllBodies = typename P::bodies;
  using Carried = material_fields<P>;
  using AtStart = PerBody<detail::BodyAtStart<vector>, AllBodies>;
  Solver(Space const& space, AtStart const& start, SolverSettings<P> const& settings)
      : settings_(settings),
        system_(space, settings.checked().smoothing * settings.spacing, settings.periods),
        lattice_sum_(kernel_sum_of_lattice(system_.kernel(), settings.spacing)),
        surface_asymmetry_(surface_asymmetry(system_.kernel())),
        followers_(settings.periods),
        rigid_(rigid_of(system_, settings, start)) {
    double all = 0;
    for (auto const& body : start.all) all += double(body.points.size());
    check_number(all);  // some loops run over several bodies
    detail::check_groups<P>(settings.motion, start);
    detail::for_each_body(AllBodies{}, [&]<class Body>() {
      auto const& particles = start.template of<Body>();
      detail::place(system_.template body<Body>(), particles, settings.spacing);
      if constexpr (EvolvingBody<Body>)
        followers_.confines().add_material(particles.points);
      else if constexpr (!RigidTag<Body>)
        followers_.template add<Body>(system_, settings_.motion, particles.points);
    });
    at_start_ = material().size();
    followers_.check(settings_.motion, 0);
    detail::Followers<P>::move(system_, settings_.motion, 0);
    place_rigid();
    system_.positions_changed();
  }
  using RigidPart = typename detail::rigid_part<P>::type;
  static RigidPart rigid_of(system_of<P>& system, SolverSettings<P> const& settings, AtStart const& start) {
    if constexpr (has_rigid_bodies)
      return RigidPart(system, settings, start.template of<detail::rigid_body_of<AllBodies>>());
    else
      return RigidPart();
  }
  void update_rigid_forces() {
    if constexpr (has_rigid_bodies) rigid_.update_forces(system_, settings_.physics, resolution());
  }
  void place_rigid() {
    if constexpr (has_rigid_bodies) rigid_.place(system_);
  }
  long next_identity() const { return turnover().at_start(material().size()) + turnover().added; }
  void particles_changed() {
    system_.particles_changed();
    control_.look_before(steps_);
    if (started_) update_rates();
  }
  /// Adds particles without neighbours; returns their volume, m^dim.
  template <class... Fs, class... Values>
  double place(std::vector<vector> const& points, StartWords const& words, Given<Fs, Values> const&... values) {
    ProfilingRegion const region("scree::add");
    check_number(double(points.size()) + double(next_identity()));
    if (settings_.start_checks) detail::check_added(system_, settings_, points, words);
    double const added = detail::append(system_, settings_, static_cast<int>(next_identity()), points, values...);
    followers_.confines().add_material(points);
    return added;
  }
  /// Removes particles; those that are left have no neighbours until particles_changed().
  template <class Condition, class List>
  auto take_out(Condition const& condition, List fields) {
    ProfilingRegion const region("scree::remove");
    auto const gone = pick(material(), condition);
    auto const removed = records_of(material(), fields, gone);
    if (gone.size() > 0) system_.template keep<Material>(pick(material(), condition, false));
    return removed;
  }
  void open() {
    if (openings_.none() || !openings_.due(time_, neighbour_builds())) return;
    if (!started_) check_start_once();
    serve_openings();
  }
  /// Feeds inlets and empties drains. Rates of those who enter are zero until they are evaluated in the next step.
  void serve_openings() {
    ProfilingRegion const region("scree::openings");
    Turnover const before = turnover();
    openings_.serve(*this, time_, neighbour_builds());
    if (before == turnover()) return;
    system_.particles_changed();
    control_.look_before(steps_);
  }
  /// One step, without what comes and goes after it.
  double step_closed(double longest) {
    ProfilingRegion const region("scree::step");
    double const dt = or_name([&] { return advance(longest); });
    time_ += dt;
    ++steps_;
    or_name([&] { filter(); });
    return dt;
  }
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
      if (certain()) throw;
    }
    return false;
  }
  template <class Question>
  bool certain_if_thrown(Question const& question) {
    try {
      return question();
    } catch (...) {
      certain();
      throw;
    }
  }
  bool sorts_now() const { return settings_.sort_period > 0 && steps_ % settings_.sort_period == 0; }
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
  template <class Function, class Projections>
  void update(Function const& function, Projections const& projections, double before, double after) {
    ProfilingRegion const region("scree::update");
    if constexpr (evolves_position && detail::are_point_passes<Material, Projections>) {
      detail::Followers<P>::update_and_move(system_,
                                            with_point_passes<Basis>(detail::holding<Carried>(function), projections),
                                            settings_.motion, time_ + after);
      place_rigid();
      system_.positions_changed();
    } else {
      apply(function);
      run_passes(system_, projections);
      move(before, after);
    }
  }
  void check_settings_once() {
    if (!settings_checked_) check_settings_of(settings_.physics), settings_checked_ = true;
  }
  [[gnu::cold]] void check_start_once() {
    PlacedParticles placed;
    detail::for_each_body(AllBodies{}, [&]<class Body>() { require_all_set<P, Body>(body<Body>()); });
    if (settings_.start_checks) {
      placed.add(material());
      std::size_t const owned = placed.places.size();
      detail::for_each_body(following_bodies<P>{}, [&]<class Body>() { placed.add(body<Body>()); });
      check_start(placed, owned, settings_.spacing, P::dim, settings_.periods);
    }
    started_ = true;
  }
  double advance(double longest) {
    using Integrator = typename P::integrator;
    static_assert(
        requires(Solver & solver) {
          { Integrator::advance(solver, longest) } -> std::convertible_to<double>;
        },
        "`integrator` is not a TimeIntegrator: it needs static double advance(solver, longest)");
    check_settings_once();
    if (!started_) check_start_once();
    if (sorts_now())
      system_.begin_step_sorted();
    else
      system_.begin_step();
    return Integrator::advance(*this, longest);
  }
  /// A value that is not finite is usually the cause of an error in a step, so it is reported first.
  template <class Action>
  auto or_name(Action const& action) {
    try {
      return action();
    } catch (std::runtime_error const&) {
      check_finite(material(), Merge<Evolved, Fields<Volume>>{}, steps_);  // volumes weight all sums
      throw;
    }
  }
  double support() const { return P::kernel::support * settings_.smoothing * settings_.spacing; }
  [[gnu::noinline]] std::vector<TimeStepLimit> limits_now() const {
    return limits_of(material(), Evolved{}, settings_.physics.limits(resolution()), steps_, bounds());
  }
  Bound<DistanceBeyond<vector>> nothing_lost() const {
    return bound("distance beyond the walls (m)", followers_.box(settings_.motion, time_), support(),
                 "where grains may get lost, raise `lost_share` of the settings", settings_.lost_share);
  }
  auto bounds() const {
    auto const of_physics = validity_of(settings_.physics, resolution());
    if constexpr (evolves_position)
      return std::tuple_cat(of_physics, std::tuple(nothing_lost()));
    else
      return of_physics;
  }
  void filter() {
    using Filters = decltype(detail::filters_of(settings_.physics, resolution()));
    static constexpr bool has_filters = !std::is_same_v<Filters, std::tuple<>>;
    if constexpr (has_filters) {
      // The phase follows from the step count, which checkpoints contain.
      if (steps_ % every_so_many(settings_.physics.filter_period()) != 0) return;
      ProfilingRegion const region("scree::filters");
      run_passes(system_, detail::filters_of(settings_.physics, resolution()));
    }
  }

  SolverSettings<P> settings_;
  system_of<P> system_;
  double lattice_sum_, surface_asymmetry_;
  detail::Followers<P> followers_;
  RigidPart rigid_;
  TimeStepControl control_;
  detail::Openings<Solver> openings_;
  long at_start_ = 0;
  double time_ = 0;
  long steps_ = 0;
  bool settings_checked_ = false;
  bool started_ = false;  // the start has been checked
  std::tuple<double, long, TimeStepControl> before_trial_;
};

}  // namespace scree
