// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../integrators/update.hpp"
#include "looks.hpp"

#include <concepts>
#include <type_traits>

namespace scree {

/// The building blocks of time integrators: rates, limits and updates of the bodies of a solver, for one step. A
/// stepper refers to the state of the solver and is the first argument of `Integrator::advance(stepper, longest)`.
template <class P>
class Stepper {
  using State = detail::SolverState<P>;

 public:
  using policy = P;
  using Basis = basis_of<P>;
  static constexpr bool evolves_position = detail::evolves_position<P>;
  static constexpr bool has_rigid_bodies = State::has_rigid_bodies;

  /// Refers to a state, which must outlive the stepper.
  explicit Stepper(State& state) : state_(state) {}

  /// Returns the number of steps since the start.
  long steps() const { return state_.clock.steps; }
  /// Returns the time at the beginning of the step, s.
  double time() const { return state_.clock.time; }
  /// Returns the spacing, smoothing length and support of the kernel, m, and sums over the initial lattice.
  Resolution resolution() const { return state_.resolution(); }
  /// Returns the particles of a body.
  template <BodyTag Body>
  auto const& body() const {
    return state_.system.template body<Body>();
  }
  /// Returns the particles of the material.
  auto const& material() const { return body<Material>(); }
  /// Returns the particles of the walls.
  auto const& wall() const { return body<Wall>(); }
  /// Returns the instance of the execution space in which all loops run.
  typename P::space const& space() const { return state_.system.space(); }
  /// Returns the settings of the solver.
  SolverSettings<P> const& settings() const { return state_.settings; }

  /// Computes the rates of the present state: runs all rate passes of the physics model and updates the forces on rigid
  /// bodies. With `afresh`, also runs the passes that otherwise run only at certain steps.
  void update_rates(bool afresh = false) {
    ProfilingRegion const region("scree::rates");
    Resolution of_passes = resolution();
    of_passes.afresh = afresh;
    run_passes(state_.system, detail::rates_of(physics(), of_passes));
    update_rigid_forces();
  }
  /// Returns the length (s) of the step that the present state and rates allow, at most `longest` (s). If the limits of
  /// the time step are due, evaluates them and checks the state.
  double choose_step(double longest) {
    auto& [time, steps, control] = state_.clock;
    if (control.must_look(steps)) {
      auto const limits = detail::look(state_, control, state_.checks);
      state_.checks.packing_now_and_then(state_.system, state_.settings, time, steps);
      detail::warn_of_state(state_);
      if (state_.note_on_steps.empty()) state_.note_on_steps = note_on(limits.all, limits.of_physics);
    }
    double const dt = control.choose(longest);
    if (steps >= state_.paths_due) detail::check_paths(state_, time + dt);
    return dt;
  }
  /// Updates the bodies that evolve to the time `after` (s), counted from the beginning of the step, and runs the
  /// projections. `function` takes the list of fields that evolve in a body and returns a function of one particle;
  /// without rigid bodies it may itself be a function of one particle. Bodies that follow the motion are moved to the
  /// same time.
  template <class Function>
  void update(Function const& function, double before, double after) {
    update(function, detail::projections_of(physics(), resolution()), before, after);
  }

  /// Returns the stages of the physics model, in order, for staggered integrators that advance them by dt (s). With dt
  /// = 0, the passes of the stages compute the rates of the present state; an update with these rates rotates the
  /// stress to first order in the time step.
  auto stages(double dt = 0) const {
    Resolution of_step = resolution();
    of_step.step = dt;
    return physics().stages(of_step);
  }
  /// Computes the rates of a stage, or of all stages.
  template <class Stage>
  void evaluate(Stage const& stage) {
    run_passes(state_.system, stage.passes);
    if constexpr (OneOf<Velocity, evolved_fields<typename Stage::evolves>>) update_rigid_forces();
  }
  template <detail::AnyTuple Stages>
  void evaluate(Stages const& all) {
    detail::with_values([&](auto const&... each) { (evaluate(each), ...); }, all);
  }
  /// Updates the bodies that evolve, as update() does, but runs no projections and moves no other body. The other
  /// bodies and the particles of rigid bodies are moved by move().
  template <class Function>
  void apply(Function const& function) {
    advance_rigid(function);
    detail::for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
      auto const of_particle = of_body<Body>(function);
      for_each_particle<Basis>("scree::update", body<Body>(), of_particle);
      if constexpr (OneOf<Position, writes_of<decltype(of_particle)>>) state_.system.positions_changed();
    });
  }
  /// Advances some fields of each body that evolves by their rates times dt (s), in the order of the list. A rate that
  /// is itself in the list is used after its own update. Like apply(), this function moves no body that follows the
  /// motion.
  template <class Some>
  void add_rates(Some some, double dt) {
    apply(adding_rates(some, dt));
  }
  /// Runs the projections of a stage, which return the updated state to the admissible set.
  template <class Stage>
  void project(Stage const& stage) {
    run_passes(state_.system, stage.projections);
  }
  /// Computes the rates of a stage, advances its fields by dt (s) and runs its projections, in one sweep if no
  /// neighbour reads the updated fields. If the stage evolves positions, the walls are moved, too.
  template <class Stage>
  void advance(Stage const& stage, double dt) {
    ProfilingRegion const region("scree::stage");
    using OfStage = typename Stage::evolves;
    auto const function = adding_rates(OfStage{}, dt);
    if constexpr (OneOf<Position, evolved_fields<OfStage>>) {
      evaluate(stage);
      update(function, stage.projections, 0, dt);
    } else if constexpr (detail::several_evolve<P> || (has_rigid_bodies && OneOf<Velocity, evolved_fields<OfStage>>)) {
      evaluate(stage);  // reactions and other bodies need the fields before the update
      apply(function);
      project(stage);
    } else if constexpr (detail::are_point_passes<Material, decltype(stage.projections)>) {
      run_passes_and<Material>(state_.system, stage.passes,
                               with_point_passes<Basis>(of_body<Material>(function), stage.projections));
    } else {
      run_passes_and<Material>(state_.system, stage.passes, of_body<Material>(function));
      project(stage);
    }
  }
  /// Moves the bodies that follow the motion from one time to another (s), both counted from the beginning of the step:
  /// the walls, and the material unless its position evolves.
  void move(double before, double after) {
    using OfMaterial = body_motion<P, Material>;
    auto const& motion = state_.settings.motion;
    if constexpr (!evolves_position && !std::is_same_v<OfMaterial, AtRest>)
      for_each_particle<Basis>(
          "scree::move_material", material(),
          detail::Displace<Basis, OfMaterial>{motion_of_body<Material>(motion), time() + before, time() + after});
    state_.place_followers(time() + after);
  }

  /// Takes one step of at most `longest` (s) with the integrator; returns its length.
  double take(double longest) {
    double const dt = detail::or_name(state_, [&] { return advance_by_integrator(longest); });
    state_.clock.time += dt;
    ++state_.clock.steps;
    detail::or_name(state_, [&] { filter(); });
    return dt;
  }
  /// Runs the checks of the next step, for which it computes the rates. The checks do not change the results of that
  /// step.
  void check() {
    detail::check_settings_once(state_);
    detail::or_name(state_, [&] {
      if (!state_.started) detail::check_particles(state_);
      detail::check_places_once(state_);
      if (steps() == 0 || !state_.sorts_now()) {  // sorting builds its own neighbour lists
        if (steps() > 0) state_.system.begin_step();
        update_rates();
      }
      auto control = state_.clock.control;
      auto checks = state_.checks;
      detail::look(state_, control, checks);
    });
  }

 private:
  /// Returns the update of one particle of a body. The update keeps the velocity of held particles.
  template <class Body, class Function>
  static auto of_body(Function const& function) {
    using Carried = carried_fields<P, Body>;
    if constexpr (std::is_invocable_v<Function const&, evolves_of<P, Body>>)
      return detail::holding<Carried>(function(evolves_of<P, Body>{}));
    else
      return detail::holding<Carried>(function);
  }
  /// Returns a function that takes the list of evolving fields of a body and returns an update. The update adds the
  /// rates times dt (s) of those fields that evolve together with the fields `Some` of the material.
  template <class Some>
  static auto adding_rates(Some, double dt) {
    return
        [dt]<class Evolved>(Evolved) { return staggered_update<Basis>(detail::evolved_with<P, Some, Evolved>{}, dt); };
  }
  template <class Function>
  void advance_rigid([[maybe_unused]] Function const& function) {
    if constexpr (has_rigid_bodies) {
      constexpr bool takes_lists = std::is_invocable_v<Function const&, detail::RigidEvolves>;
      static_assert(
          takes_lists,
          "rigid bodies evolve with the material, so that an integrator gives update() and apply() a function "
          "of a list of fields: [dt](auto evolved) { return staggered_update<Basis>(evolved, dt); }");
      if constexpr (takes_lists) state_.rigid.advance(state_.system, physics(), function);
    }
  }
  typename P::physics const& physics() const { return state_.settings.physics; }
  void update_rigid_forces() { state_.rigid.update_forces(state_.system, physics(), resolution()); }
  template <class Function, class Projections>
  void update(Function const& function, Projections const& projections, double before, double after) {
    ProfilingRegion const region("scree::update");
    if constexpr (evolves_position && !detail::several_evolve<P> && detail::are_point_passes<Material, Projections>) {
      advance_rigid(function);
      detail::Followers<P>::update_and_move(state_.system,
                                            with_point_passes<Basis>(of_body<Material>(function), projections),
                                            state_.settings.motion, time() + after);
      state_.rigid.place(state_.system, state_.settings.motion, time() + after);
      state_.system.positions_changed();
    } else {
      apply(function);
      run_passes(state_.system, projections);
      move(before, after);
    }
  }
  double advance_by_integrator(double longest) {
    using Integrator = typename P::integrator;
    static_assert(
        requires(Stepper & stepper) {
          { Integrator::advance(stepper, longest) } -> std::convertible_to<double>;
        },
        "`integrator` is not a TimeIntegrator: it needs static double advance(stepper, longest)");
    detail::check_settings_once(state_);
    detail::check_start_once(state_);
    detail::check_places_once(state_);
    if (state_.sorts_now())
      state_.system.begin_step_sorted();
    else
      state_.system.begin_step();
    return Integrator::advance(*this, longest);
  }
  void filter() {
    using Filters = decltype(detail::filters_of(physics(), resolution()));
    if constexpr (!std::is_same_v<Filters, detail::Tuple<>>) {
      // The phase follows from the number of steps, which snapshots contain.
      if (steps() % every_so_many(physics().filter_period()) != 0) return;
      ProfilingRegion const region("scree::filters");
      run_passes(state_.system, detail::filters_of(physics(), resolution()));
    }
  }

  State& state_;
};

namespace detail {

/// Computes the rates of the present state.
template <class P>
void update_rates(SolverState<P>& state, bool afresh) {
  Stepper<P>(state).update_rates(afresh);
}
/// Takes a step of at most `longest` (s); returns its length.
template <class P>
double take_step(SolverState<P>& state, double longest) {
  return Stepper<P>(state).take(longest);
}
/// Runs the checks of the next step.
template <class P>
void check_step(SolverState<P>& state) {
  Stepper<P>(state).check();
}

}  // namespace detail
}  // namespace scree
