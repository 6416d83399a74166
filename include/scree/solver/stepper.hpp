// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../integrators/largest_cfl.hpp"
#include "../integrators/update.hpp"
#include "../passes/limit.hpp"
#include "../system/system.hpp"
#include "body_at_start.hpp"
#include "busy.hpp"
#include "checks.hpp"
#include "explain.hpp"
#include "explain_set.hpp"
#include "followers.hpp"
#include "rigid_part.hpp"
#include "settings.hpp"
#include "shares_at_start.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace scree {

/// The bodies of one formulation and what advances them by one step: the rates, the updates that an integrator is made
/// of, the limits of the step and the checks of the state.
template <class P>
class Stepper {
  static_assert(detail::explain_formulation<P>());

 public:
  using policy = P;
  using Basis = basis_of<P>;
  using vector = Vec<P::dim, typename P::real>;
  using Evolved = evolved_fields<typename P::physics::evolves>;
  static constexpr bool evolves_position = detail::evolves_position<P>;
  static constexpr bool has_rigid_bodies = detail::has_rigid_bodies<typename P::bodies>;

  static constexpr bool has_parts = detail::on_parts<typename P::template ghosts<Basis>>;

  using Space = typename P::space;

  template <BodyTag Body>
  auto const& body() const {
    return system_.template body<Body>();
  }
  /// The particles of the material.
  auto const& material() const { return body<Material>(); }
  /// The particles of the walls.
  auto const& wall() const { return body<Wall>(); }
  Space const& space() const { return system_.space(); }
  /// The present time, s.
  double time() const { return time_; }
  /// The number of steps since the start.
  long steps() const { return steps_; }
  /// How often neighbour lists were built.
  long neighbour_builds() const { return system_.neighbour_builds(); }
  /// Agreement of all parts of the case: OnePart, or OtherParts of one body.
  decltype(auto) parts() const { return system_.parts(); }
  /// How often a run on a GPU repeated steps because neighbour lists expired earlier than expected.
  long failed_trials() const { return system_.failed_trials(); }
  /// How often each limit was the smallest and set the step.
  std::map<std::string, long> const& limits() const { return control_.counts(); }
  /// Which of the motion and the rigid bodies first asked for steps below a tenth of those of the physics model, with
  /// both steps (s); "" if none has. Progress prints it once.
  std::string const& note_on_steps() const { return note_on_steps_; }
  /// The settings that the solver was made with.
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
  /// SlipNormal::check_on_wall() refuses, for volumes that are not above 0 or, during a run, fit the distances between
  /// the particles less than before (see `start_checks`), for identities that are
  /// negative or given twice.
  template <class Body = Material, Field F, class Points, class Function>
  void set(F field, Points const& points, Function const& function) {
    using List = typename std::remove_cvref_t<decltype(body<Body>())>::fields;
    using X = std::remove_cvref_t<decltype(*points.begin())>;
    if constexpr (detail::explain_set<P, Body, F, List, X, Function>()) {
      busy_.check_is_here();
      std::vector<value_t<P, F>> values;
      values.reserve(points.size());
      for (auto const& x : points) values.push_back(static_cast<value_t<P, F>>(function(x)));
      if constexpr (FollowingBody<Body> && !RigidTag<Body> && detail::is_checked_on_wall<F>)
        detail::check_on_wall<F>(motion_of_body<Body>(settings_.motion), body<Body>(), values);
      if constexpr (std::is_same_v<F, Volume>) detail::check_volumes(values, "the " + std::string(Body::name));
      if constexpr (std::is_same_v<F, Identity>) detail::check_identities(values, "the " + std::string(Body::name));
      if constexpr (std::is_same_v<F, Volume> && EvolvingBody<Body>)
        if (started_ && settings_.start_checks) detail::PositionChecks<P>::set_volumes(system_, settings_, values);
      system_.template body<Body>().from_host(field, values);
      if constexpr (OneOf<Remainder<F>, carried_fields<P, Body>>)
        system_.template body<Body>().fill(Remainder<F>{}, zero<value_t<P, F>>());
      control_.look_before(steps_);
      if constexpr (std::is_same_v<F, Position>) system_.positions_changed();
      if constexpr (std::is_same_v<F, Position> && EvolvingBody<Body>)
        followers_.confines().add_material(parts().of_all(detail::corners_of(values)));
      if constexpr (std::is_same_v<F, RestPosition> && !RigidTag<Body>)
        followers_.template add<Body>(system_, settings_.motion, values), rigid_.prepare(system_, settings_);
    }
  }
  /// The same with the present positions.
  template <class Body = Material, Field F, class Function>
  void set(F field, Function const& function) {
    set<Body>(field, system_.template body<Body>().to_host(fields::position), function);
  }
  // Called with something else, the compiler says what a field is.
  template <class Body = Material, class Name, class... Others>
  requires(!Field<Name>) void set(Name const&, Others const&...) {
    static_assert(sizeof(Name) == 0, "set() takes a field as an object: set(fields::velocity, function)");
  }
  /// Evaluates all passes for the present state, as at the beginning of a step.
  void update_rates() {
    ProfilingRegion const region("scree::rates");
    run_passes(system_, rate_passes(settings_.physics, resolution()));
    rigid_.update_forces(system_, settings_.physics, resolution());
  }

  /// Evaluates the passes that are only for output.
  void update_diagnostics() {
    ProfilingRegion const region("scree::diagnostics");
    run_passes(system_, detail::diagnostic_passes(settings_.diagnostics, resolution(), settings_.physics));
    if constexpr (has_rigid_bodies) rigid_.contact().add_to_walls(system_);
  }

  /// Checks the present state like a run: throws std::runtime_error if a value is not finite, OutsideValidity if the
  /// state is outside the validity of the model. A run makes this check together with the limits of the step, at least
  /// every 256 steps, and at its end. One sweep over the particles.
  void check_validity() const { limits_now(); }
  /// The number of particles farther than a support beyond walls and initial material, below or to a side of them, on
  /// all parts together. Zero without walls and where positions are prescribed; directions along periods do not count.
  long lost() const {
    if constexpr (evolves_position) return detail::number_beyond(system_, nothing_lost());
    return 0;
  }
  /// Building blocks of integrators: the step that the present state and rates allow, at most `longest` (s);
  double choose_step(double longest) {
    static_assert(HasLimits<typename P::physics>,
                  "`physics` needs a function `limits(resolution)`: a tuple of limits of the step, which may be empty");
    static_assert(detail::are_limits<decltype(settings_.physics.limits(resolution()))>,
                  "`limits(resolution)` of `physics` returns a tuple of what limit() returns");
    if (control_.must_look(steps_)) {
      auto const limits = look(control_, checks_);
      checks_.packing_now_and_then(system_, settings_, time_, steps_);
      if (note_on_steps_.empty()) note_on_steps_ = note_on(limits.all, limits.of_physics);
    }
    double const dt = control_.choose(longest);
    if (steps_ >= paths_due_) check_paths(time_ + dt);
    return dt;
  }
  /// an update of the rigid bodies, if there are any, by the forces of the rates that were evaluated last; their
  /// particles follow with the next update of the material;
  void advance_rigid(RigidStep const& step) { rigid_.advance(system_, settings_.physics, step); }
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
    if constexpr (OneOf<Velocity, evolved_fields<typename Stage::evolves>>)
      rigid_.update_forces(system_, settings_.physics, resolution());
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
    if constexpr (!evolves_position && !std::is_same_v<body_motion<P, Material>, AtRest>)
      for_each_particle<Basis>("scree::move_material", system_.template body<Material>(),
                               detail::Displace<Basis, body_motion<P, Material>>{
                                   motion_of_body<Material>(settings_.motion), time_ + before, time_ + after});
    detail::Followers<P>::move(system_, settings_.motion, time_ + after);
    rigid_.place(system_, settings_.motion, time_ + after);
    system_.positions_changed();
  }

 protected:
  /// Compares the functions of the motion since the last comparison, and to a time (s).
  [[gnu::cold]] void check_paths(double until) {
    bool const went_back = !(paths_until_ <= time_);
    followers_.check_paths(settings_.motion, went_back ? time_ : paths_until_, until);
    paths_until_ = until, paths_due_ = steps_ + 32;
  }
  using AllBodies = typename P::bodies;
  using Carried = material_fields<P>;
  using AtStart = PerBody<detail::BodyAtStart<vector>, AllBodies>;
  Stepper(Space const& space, AtStart const& start, SolverSettings<P> const& settings)
      : settings_(settings),
        system_(space, settings.checked().smoothing * settings.spacing, detail::ghost_settings(settings)),
        lattice_sum_(kernel_sum_of_lattice(system_.kernel(), settings.spacing)),
        surface_asymmetry_(surface_asymmetry(system_.kernel())),
        followers_(settings.periods),
        rigid_(system_, settings, start) {
    double all = 0;
    for (auto const& body : start.all) all += double(body.points.size());
    check_number(all);  // some loops run over several bodies
    if constexpr (!has_parts) {
      for (auto const& body : start.all) detail::check_whole(body.ranges);
    } else if (parts().on_any(detail::begins_from_shares(start))) {
      system_.begin_with_shares();
      detail::check_shares(start, parts());
    }
    detail::check_groups<P>(settings.motion, start);
    detail::for_each_body(AllBodies{}, [&]<class Body>() {
      auto const& particles = start.template of<Body>();
      detail::place(system_.template body<Body>(), particles, settings.spacing);
      if constexpr (EvolvingBody<Body>) {
        followers_.confines().add_material(parts().of_all(detail::corners_of(particles.points)));
        followers_.add_material(system_, settings_.motion, particles.points);
      } else if constexpr (!RigidTag<Body>)
        followers_.template add<Body>(system_, settings_.motion, particles.points);
      else
        for (auto const& x : detail::corners_of(particles.points))
          farthest_of_rigid_ = std::max(farthest_of_rigid_, double(x.cwiseAbs().maxCoeff()));
    });
    at_start_ = parts().count(material());
    rigid_.prepare(system_, settings_);
    followers_.check(settings_.motion, 0);
    detail::Followers<P>::move(system_, settings_.motion, 0);
    rigid_.place(system_, settings_.motion, 0);
    system_.positions_changed();
  }
  Stepper(Stepper&&) = default;
  Stepper& operator=(Stepper&&) = default;
  /// One step of at most `longest` (s); returns its length.
  double take_step(double longest) {
    double const dt = or_name([&] { return advance(longest); });
    time_ += dt;
    ++steps_;
    or_name([&] { filter(); });
    return dt;
  }
  template <class Function, class Projections>
  void update(Function const& function, Projections const& projections, double before, double after) {
    ProfilingRegion const region("scree::update");
    if constexpr (evolves_position && detail::are_point_passes<Material, Projections>) {
      detail::Followers<P>::update_and_move(system_,
                                            with_point_passes<Basis>(detail::holding<Carried>(function), projections),
                                            settings_.motion, time_ + after);
      rigid_.place(system_, settings_.motion, time_ + after);
      system_.positions_changed();
    } else {
      apply(function);
      run_passes(system_, projections);
      move(before, after);
    }
  }
  void check_settings_once() {
    if (settings_checked_) return;
    check_settings_of(settings_.physics);
    detail::check_cfl_of<typename P::integrator>(settings_.physics);
    settings_checked_ = true;
    warn_of_models();
  }
  void warn_of_models() const {
    if constexpr (requires { settings_.physics.warning(); }) {
      if (!settings_.start_checks || !settings_.warn || !parts().reports()) return;
      std::string const text = settings_.physics.warning();
      if (!text.empty()) settings_.warn(text);
    }
  }
  void check_start_once() {
    system_.settle_shares();
    check_precision();
    check_rigid_start();
    checks_.start(system_, settings_), started_ = true;
  }
  /// Makes the checks of the next step, and evaluates the rates for them. What the step finds is the same as without.
  void check_step() {
    check_settings_once();
    or_name([&] {
      system_.settle_shares();
      check_precision();
      if (!started_) check_rigid_start(), checks_.start(system_, settings_);
      if (steps_ == 0 || !sorts_now()) {  // sorting builds lists of its own
        if (steps_ > 0) system_.begin_step();
        update_rates();
      }
      auto control = control_;
      auto checks = checks_;
      look(control, checks);
    });
  }
  void check_rigid_start() {
    if constexpr (has_rigid_bodies)
      if (settings_.start_checks) rigid_.check_start(settings_.spacing);
  }
  /// The limits of a step; the first of them are those of the physics.
  struct LimitsOfStep {
    std::vector<TimeStepLimit> all;
    std::size_t of_physics = 0;
  };
  /// Checks the state and finds the limits of the step.
  LimitsOfStep look(TimeStepControl& control, detail::PositionChecks<P>& checks) {
    if (parts().several()) system_.stop_if_trial_failed();  // what is found now is no effect of outdated lists
    followers_.check(settings_.motion, time_);
    checks.walls_now_and_then(system_, settings_, steps_);
    auto limits = limits_now();
    std::size_t const of_physics = limits.size();
    limits.push_back({"motion", settings_.motion.time_step(), TimeStepLimit::never});
    if constexpr (has_rigid_bodies)
      for (auto const& limit : rigid_.limits(system_, settings_.physics, settings_.spacing)) limits.push_back(limit);
    control.look(limits, steps_);
    return {std::move(limits), of_physics};
  }
  void check_precision() const {
    checks_.precision(std::max(farthest_of_rigid_, followers_.farthest(settings_.motion, time_)), settings_, steps_);
  }
  double advance(double longest) {
    using Integrator = typename P::integrator;
    static_assert(
        requires(Stepper & solver) {
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
    check_precision();
    if constexpr (has_rigid_bodies) {
      rigid_.contact().check(system_, steps_);
      if (settings_.lost_share < 1) rigid_.check_inside(system_, followers_.box(settings_.motion, time_), support());
    }
    return limits_of(material(), Evolved{}, settings_.physics.limits(resolution()), steps_,
                     detail::bounds_of(settings_, resolution(), [&] { return nothing_lost(); }), system_.parts());
  }
  auto nothing_lost() const {
    return detail::nothing_lost(followers_.box(settings_.motion, time_), support(), settings_);
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
  bool sorts_now() const { return settings_.sort_period > 0 && steps_ % settings_.sort_period == 0; }

  detail::Busy busy_;
  SolverSettings<P> settings_;
  system_of<P> system_;
  double lattice_sum_, surface_asymmetry_;
  detail::Followers<P> followers_;
  detail::PositionChecks<P> checks_;
  typename detail::rigid_part<P>::type rigid_;
  TimeStepControl control_;
  long at_start_ = 0;
  double farthest_of_rigid_ = 0;  // coordinate of rigid bodies at the start, in magnitude, m
  double time_ = 0;
  long steps_ = 0;
  std::string note_on_steps_;
  double paths_until_ = std::numeric_limits<double>::infinity();  // s, of the motion
  long paths_due_ = 0;                                            // the step at which they are compared next
  bool settings_checked_ = false;
  bool started_ = false;  // the start has been checked
};

}  // namespace scree
