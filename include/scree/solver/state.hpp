// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/limit.hpp"
#include "../run/busy.hpp"
#include "../run/component.hpp"
#include "../system/system.hpp"
#include "body_at_start.hpp"
#include "checks.hpp"
#include "engine.hpp"
#include "followers.hpp"
#include "rigid_dynamics.hpp"
#include "settings.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace scree::detail {

/// The state that a run returns to when it repeats steps, apart from the fields of particles.
struct Clock {
  double time = 0;  // s
  long steps = 0;
  TimeStepControl control;  // control of the time step
};

/// The findings of a model about whether it is suited for the state.
struct Doubt {
  bool now = false;   // the last check found the state unsuitable
  bool said = false;  // the warning was given
};

/// The state of a solver without its components. The member functions construct the state and return values that follow
/// from it alone; the functions that advance the state, change its particles or check it are in other headers of this
/// folder.
template <class P>
struct SolverState {
  using Space = typename P::space;
  using Basis = basis_of<P>;
  using vector = Vec<P::dim, typename P::real>;
  using AllBodies = typename P::bodies;
  using AtStart = ParticlesAtStart<P>;
  static constexpr bool has_rigid_bodies = detail::has_rigid_bodies<AllBodies>;

  SolverState(Space const& space, AtStart const& start, SolverSettings<P> const& of_case)
      : settings(of_case),
        system(space, of_case.checked().smoothing * of_case.spacing, ghost_settings(of_case)),
        lattice_sum(kernel_sum_of_lattice(system.kernel(), of_case.spacing)),
        surface_asymmetry(scree::surface_asymmetry(system.kernel())),
        followers(of_case.periods),
        rigid(begun(system, start), of_case, start) {
    check_points(start);
    for_each_body(AllBodies{}, [&]<class Body>() { add<Body>(start.template of<Body>()); });
    for_each_body(evolving_bodies<P>{}, [&]<class Body>() { at_start += system.template whole<Body>().size(); });
    rigid.prepare(system, settings);
    followers.check(settings.motion, 0);
    place_followers(0);
  }

  /// Returns the state of a solver, for components of the library.
  template <class S>
  static SolverState& of(S& solver) {
    return solver.state_;
  }
  double support() const { return P::kernel::support * settings.smoothing * settings.spacing; }
  Resolution resolution() const {
    return {.dimensions = P::dim,
            .spacing = settings.spacing,
            .smoothing_length = settings.smoothing * settings.spacing,
            .support = support(),
            .lattice_sum = lattice_sum,
            .surface_asymmetry = surface_asymmetry,
            .steps = clock.steps};
  }
  /// Whether the next step begins with sorting.
  bool sorts_now() const { return settings.sort_period > 0 && clock.steps % settings.sort_period == 0; }
  /// Returns the bound beyond which particles are lost.
  auto nothing_lost() const {
    return detail::nothing_lost(followers.box(settings.motion, clock.time), support(), settings);
  }
  /// Returns the largest absolute coordinate of all particles, m.
  double farthest() const { return std::max(farthest_of_rigid, followers.farthest(settings.motion, clock.time)); }
  /// Moves walls and the particles of rigid bodies to their positions at a time (s).
  void place_followers(double time) {
    Followers<P>::move(system, settings.motion, time);
    rigid.place(system, settings.motion, time);
    system.positions_changed();
  }
  /// Updates the state after particles were added or removed.
  void particles_changed() {
    system.particles_changed();
    clock.control.look_before(clock.steps);
  }
  /// Returns the identity of the next particle that is added.
  long next_identity() const { return at_start + system.template turnover<Material>().added; }

  Busy busy;
  SolverSettings<P> settings;
  scree::system_of<P> system;
  double lattice_sum, surface_asymmetry;
  Followers<P> followers;
  PositionChecks<P> checks;
  typename rigid_dynamics<P>::type rigid;
  std::vector<std::shared_ptr<StepLimiter const>> limiters;  // the components of the solver
  Clock clock;
  long at_start = 0;             // particles of the evolving bodies in the whole case
  double farthest_of_rigid = 0;  // largest absolute coordinate of rigid bodies at the start, m
  std::string note_on_steps;
  double paths_until = std::numeric_limits<double>::infinity();  // s, the motion was checked up to this time
  long paths_due = 0;                                            // the step of the next check of the motion
  long models_due = 1024;                                        // the step of the next check by the models
  std::vector<Doubt> doubts;                                     // findings of each model
  bool settings_checked = false;
  bool started = false;        // the start has been checked
  bool places_checked = true;  // bodies are at the positions of their motion
  bool moves_anew = false;     // the motion was set after a restore and has not moved the walls yet
  bool restoring = false;      // the components are being restored

 private:
  static scree::system_of<P>& begun(scree::system_of<P>& system, AtStart const& start) {
    system.begin(start);
    return system;
  }
  void check_points(AtStart const& start) {
    double all = 0;
    for (auto const& body : start.all) all += double(body.points.size());
    check_number(all);  // some loops run over several bodies
    check_groups<P>(settings.motion, start);
  }
  template <class Body>
  void add(BodyAtStart<vector> const& particles) {
    detail::place(system.template body<Body>(), particles, settings.spacing);
    if constexpr (EvolvingBody<Body>) {
      followers.confines().add_material(system.template whole<Body>().all_of(corners_of(particles.points)));
      followers.add_material(system, settings.motion, particles.points);
    } else if constexpr (!RigidTag<Body>) {
      followers.template add<Body>(system, settings.motion, particles.points);
    } else {
      for (auto const& x : corners_of(particles.points))
        farthest_of_rigid = std::max(farthest_of_rigid, double(x.cwiseAbs().maxCoeff()));
    }
  }
};

/// Returns the state of a solver before its first step.
template <class P>
SolverState<P> state_at_start(typename P::space const& space, ParticlesAtStart<P> const& start,
                              SolverSettings<P> const& settings) {
  return SolverState<P>(space, start, settings);
}

}  // namespace scree::detail
