// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../integrators/update.hpp"
#include "body_at_start.hpp"
#include "confines.hpp"
#include "formulation.hpp"
#include "limit.hpp"
#include "observer.hpp"
#include "prescribe.hpp"
#include "settings.hpp"
#include "snapshot_of.hpp"
#include "start.hpp"
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

  using Space = typename P::space;
  /// Everything runs on this instance of the execution space. Positions in m; every particle gets the volume
  /// spacing^dim.
  Solver(Space const& space, SolverSettings<P> const& settings, std::vector<vector> const& material,
         std::vector<vector> const& wall = {})
      : Solver(space, {detail::at_start(material), detail::at_start(wall)}, settings) {}
  /// The same with named groups (setup/groups.hpp) for the material, the walls, or both. Bodies that carry `group` get
  /// the numbers of these groups. Throws std::invalid_argument if the motion is by group and does not know one of them.
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::is_groups<A> || detail::is_groups<B>)
      Solver(Space const& space, SolverSettings<P> const& settings, A const& material, B const& wall = {})
      : Solver(space, {detail::at_start<vector>(material), detail::at_start<vector>(wall)}, settings) {}
  /// Both on the default instance.
  Solver(SolverSettings<P> const& settings, std::vector<vector> const& material, std::vector<vector> const& wall = {})
      : Solver(Space(), settings, material, wall) {}
  template <class A = std::vector<vector>, class B = std::vector<vector>>
  requires(detail::is_groups<A> || detail::is_groups<B>)
      Solver(SolverSettings<P> const& settings, A const& material, B const& wall = {})
      : Solver(Space(), settings, material, wall) {}

  Solver(Solver&&) = default;
  Solver& operator=(Solver&&) = default;
  Solver(Solver const&) = delete;  // a copy would share the fields; another solver can restore() this one's snapshot()

  auto const& material() const { return system_.template body<Material>(); }
  auto const& wall() const { return system_.template body<Wall>(); }
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
  /// Eigen expression would outlive the values it refers to.
  template <class Body = Material, Field F, class Points, class Function>
  void set(F field, Points const& points, Function const& function) {
    static_assert(!detail::is_expression<std::remove_cvref_t<decltype(function(*points.begin()))>>,
                  "the function given to set() must return a value, not an expression of Eigen: add .eval() to it");
    std::vector<value_t<P, F>> values;
    values.reserve(points.size());
    for (auto const& x : points) values.push_back(function(x));
    static_assert(!OneOf<F, detail::fields_to_move<P, Body>>,
                  "the motion of this body is by group, so its groups are fixed: make the solver from `Groups`");
    system_.template body<Body>().from_host(field, values);
    if constexpr (std::is_same_v<F, Position>) system_.positions_changed();
    if constexpr (std::is_same_v<F, Position> && std::is_same_v<Body, Material>) confines_.add_material(values);
    if constexpr (std::is_same_v<F, RestPosition>)
      confines_.add_wall(detail::parts_that_move(settings_.motion, wall(), values));
  }
  /// The same with the present positions.
  template <class Body = Material, Field F, class Function>
  void set(F field, Function const& function) {
    set<Body>(field, system_.template body<Body>().to_host(position), function);
  }

  /// Evaluates all passes for the present state, as at the beginning of a step.
  void update_rates() {
    ProfilingRegion const region("scree::rates");
    run_passes(system_, rate_passes(settings_.physics, resolution()));
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
    ProfilingRegion const region("scree::step");
    double const dt = or_name([&] { return advance(longest); });
    time_ += dt;
    ++steps_;
    or_name([&] { filter(); });
    return dt;
  }

  /// Building blocks of integrators: the step that the present state and rates allow, at most `longest` (s);
  double choose_step(double longest) {
    static_assert(HasLimits<typename P::physics>,
                  "`physics` needs a function `limits(resolution)`: a tuple of limits of the step, which may be empty");
    if (control_.must_look(steps_)) {
      some_of_wall_.check(settings_.motion, time_);
      auto limits = limits_now();
      limits.push_back({"motion", settings_.motion.time_step(), TimeStepLimit::never});
      control_.look(limits, steps_);
    }
    return control_.choose(longest);
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
  }
  template <class... Stages>
  void evaluate(std::tuple<Stages...> const& all) {
    std::apply([&](Stages const&... each) { (evaluate(each), ...); }, all);
  }
  /// an update;
  template <class Function>
  void apply(Function const& function) {
    for_each_particle<Basis>("scree::update", system_.template body<Material>(), function);
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
    auto const function = staggered_update<Basis>(OfStage{}, dt);
    if constexpr (OneOf<Position, evolved_fields<OfStage>>) {
      evaluate(stage);
      update(function, stage.projections, 0, dt);
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
                               detail::Displace<typename P::motion>{settings_.motion, time_ + before, time_ + after});
    follow_motion(time_ + after);
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
    RunEnds ends(until);
    Schedule<Solver> schedule(observers, *this);
    long const steps_before = steps_;
    while (time_ < until) {
      double const target = schedule.next(until);
      if (!try_step(target)) continue;
      bool const may_stop = certain_if_thrown([&] {
        ends.check_after_step(time_, control_.deciding());
        return stop && (!asks || asks());
      });
      if ((may_stop || has_come(target, time_)) && !certain()) continue;
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
    result.time = time_;
    result.steps = steps_;
    add_counters(result, "step limits", control_.counts());
    result.counters["next look at step limits"] = control_.next_look();
    return result;
  }
  /// Throws std::runtime_error if the snapshot is of another formulation or number of particles, or if the motion is by
  /// group and the groups differ.
  void restore(Snapshot const& snapshot) {
    ProfilingRegion const region("scree::restore");
    detail::require_same_groups<P>(snapshot, material(), wall());
    restore_into(system_, snapshot);
    started_ = true;
    time_ = snapshot.time;
    steps_ = snapshot.steps;
    auto const next_look = snapshot.counters.find("next look at step limits");
    control_.restore(counters_of(snapshot, "step limits"),
                     next_look == snapshot.counters.end() ? 0 : next_look->second);
  }

 private:
  using AtStart = PerBody<detail::BodyAtStart<vector>>;
  Solver(Space const& space, AtStart const& start, SolverSettings<P> const& settings)
      : settings_(settings),
        system_(space, settings.checked().smoothing * settings.spacing, settings.periods),
        lattice_sum_(kernel_sum_of_lattice(system_.kernel(), settings.spacing)),
        surface_asymmetry_(surface_asymmetry(system_.kernel())),
        confines_(settings.periods) {
    auto const &grains = start.material.points, &points = start.wall.points;
    check_number(double(grains.size()) + double(points.size()));  // some loops run over both
    detail::check_groups<P>(settings.motion, start);
    detail::place(system_.template body<Material>(), start.material, settings.spacing);
    detail::place(system_.template body<Wall>(), start.wall, settings.spacing);
    auto const parts = detail::parts_that_move(settings.motion, wall(), points);
    confines_.add_material(grains);
    confines_.add_wall(parts);
    if constexpr (OneOf<VelocityGradient, wall_fields<P>>) some_of_wall_ = detail::SomeOfWall<P::dim>(parts);
    some_of_wall_.check(settings.motion, 0);
    follow_motion(0);
    system_.positions_changed();
  }
  /// One step of a run towards a time (s), possibly part of a trial. If the trial fails, the solver returns to the
  /// beginning of the trial, and the result is false.
  bool try_step(double target) {
    try {
      if (!sorts_now() && system_.begin_trial()) before_trial_ = {time_, steps_, control_};
      double const dt = step(target - time_);
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
      for_each_particle_of_two<Basis>("scree::update", material(), with_point_passes<Basis>(function, projections),
                                      wall(), place_at(time_ + after));
      system_.positions_changed();
    } else {
      apply(function);
      run_passes(system_, projections);
      move(before, after);
    }
  }
  [[gnu::cold]] void check_start_once() {
    require_all_set<P, Material, Fields<>>(material(), "material");
    require_all_set<P, Wall, Fields<Velocity, Acceleration, VelocityGradient>>(wall(), "wall");
    if (settings_.start_checks) check_start(material(), wall(), settings_.spacing, system_.periods());
    started_ = true;
  }
  double advance(double longest) {
    if (!started_) check_start_once();
    if (sorts_now())
      system_.begin_step_sorted();
    else
      system_.begin_step();
    return P::integrator::advance(*this, longest);
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
    return bound("distance beyond the walls (m)", confines_.at(settings_.motion, time_), support(),
                 "where grains may get lost, raise `lost_share` of the settings", settings_.lost_share);
  }
  auto bounds() const {
    auto const of_physics = validity_of(settings_.physics, resolution());
    if constexpr (evolves_position)
      return std::tuple_cat(of_physics, std::tuple(nothing_lost()));
    else
      return of_physics;
  }
  auto place_at(double time) const {
    using OfWall = Common<Fields<Velocity, Acceleration, VelocityGradient>, wall_fields<P>>;
    return detail::Place<typename P::motion, OfWall>{settings_.motion, time};
  }
  void follow_motion(double to) {
    using Motion = typename P::motion;
    using OfMaterial = Common<Fields<Velocity>, material_fields<P>>;
    auto& wall = system_.template body<Wall>();
    if (wall.size() > 0) for_each_particle<Basis>("scree::move_wall", wall, place_at(to));
    if constexpr (!evolves_position && !std::is_same_v<OfMaterial, Fields<>>)
      for_each_particle<Basis>("scree::prescribe", system_.template body<Material>(),
                               detail::Kinematics<Motion, OfMaterial>{settings_.motion, to});
  }
  void filter() {
    if constexpr (requires { settings_.physics.filter_period(); }) {
      // The phase follows from the step count, which checkpoints contain.
      if (steps_ % every_so_many(settings_.physics.filter_period()) != 0) return;
      ProfilingRegion const region("scree::filters");
      run_passes(system_, detail::filters_of(settings_.physics, resolution()));
    }
  }

  SolverSettings<P> settings_;
  system_of<P> system_;
  double lattice_sum_, surface_asymmetry_;
  Confines<Basis> confines_;
  detail::SomeOfWall<P::dim> some_of_wall_;  // if walls need the gradient of the motion
  TimeStepControl control_;
  double time_ = 0;
  long steps_ = 0;
  bool started_ = false;  // the start has been checked
  std::tuple<double, long, TimeStepControl> before_trial_;
};

}  // namespace scree
