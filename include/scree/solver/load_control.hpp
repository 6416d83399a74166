// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/law.hpp"
#include "../motion/steered.hpp"
#include "../run/component.hpp"
#include "../run/observer.hpp"
#include "../snapshots/snapshot.hpp"
#include "wall_loads.hpp"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// The settings of LoadControl.
template <int Dim>
struct ControlledLoad {
  std::string group;                                      ///< the group of the wall that is moved
  Vec<Dim, double> direction = Vec<Dim, double>::Zero();  ///< in which the group presses the material, of any length
  double area = 0;                                        ///< of the pressing surface, m^(dim - 1)
  std::function<double(double time)> pressure;            ///< wanted pressure at a time (s), 0 or more, Pa
  double sound_speed = 0;                                 ///< of the material, m/s; 0: taken from the law
};

namespace detail {
/// Returns the law of a physics model; for combined models, the law of the mechanics.
template <class Physics>
auto const& law_of(Physics const& physics) {
  if constexpr (requires { physics.mechanics; })
    return law_of(physics.mechanics);
  else
    return physics.law;
}
}  // namespace detail

/// A component that moves a group of the walls along a direction so that the pressure of the group on the material
/// follows a given function of time, like the plate of an oedometer or the lid of a shear cell. The `motion` of the
/// formulation must be `Steered<dim>` or a `MotionOfGroups` with it, and `diagnostics` must contain WallForces.
///
/// The material responds to a plate velocity v with the pressure $p = Z v + f$, where Z = rho c is the impedance of the
/// material and f is the pressure of waves that arrive from within the material. A plate that follows $p = T - Z v$
/// absorbs every arriving wave, and its pressure tends to the given T. Eliminating f gives the new velocity $v' = v/2 +
/// (T - p)/(2 Z)$ from the present velocity and pressure. The velocity is changed at intervals of a fifth of the time
/// that sound takes to travel a smoothing length, or in each step if the step is longer; with the delay of a wave
/// through several particles, the plate would oscillate. A speed of sound up to three times too small is stable. A
/// plate without contact moves at T/Z.
template <class S>
class LoadControl : public Component<S> {
 public:
  static constexpr int dim = S::policy::dim;
  using X = Vec<dim, double>;

  /// Checks the settings. Throws std::invalid_argument if one is out of range, or if the walls do not have the group.
  LoadControl(S const& solver, Groups<dim> const& walls, ControlledLoad<dim> const& settings)
      : settings_(settings), walls_(walls), number_(walls.number(settings.group)) {
    auto const& law = detail::law_of(solver.settings().physics);
    if constexpr (requires { law.sound_speed(); })
      if (settings_.sound_speed == 0) settings_.sound_speed = law.sound_speed();
    check_setting(settings_.sound_speed > 0, "sound_speed (m/s) of a controlled load", settings_.sound_speed,
                  "above 0; it must be given where that of the law depends on the state");
    constexpr bool has_one_density = detail::GivesDensity<std::remove_cvref_t<decltype(law)>>;
    static_assert(has_one_density,
                  "a controlled load needs a law with one density, density(), for the impedance of the material");
    if constexpr (has_one_density) impedance_ = law.density() * settings_.sound_speed;
    interval_ = 0.2 * solver.resolution().smoothing_length / settings_.sound_speed;
    double const length = settings.direction.norm();
    check_setting(length > 0 && std::isfinite(length), "length of the direction of a controlled load", length,
                  "above 0");
    check_setting(settings.area > 0, "area (m^(dim-1)) of a controlled load", settings.area, "above 0");
    check_setting(bool(settings.pressure), "functions `pressure` of a controlled load", 0, "1");
    settings_.direction /= length;
    auto const& motion = solver.settings().motion;
    if constexpr (!requires(typename S::policy::motion all) { all.set(number_, motion_); })
      check_setting(walls.count() == 1, "groups of walls with a controlled load and one motion for all", walls.count(),
                    "1; several need `MotionOfGroups`");
    else
      check_setting(walls.count() == motion.groups(), "groups of walls with a controlled load", walls.count(),
                    detail::formatted("%d, as the motion has", motion.groups()).c_str());
  }

  /// Takes over the present displacement and velocity of the wall.
  void start(S& solver) override {
    double const now = solver.time();
    auto const of_all = motion_of_body<Wall>(solver.settings().motion);
    auto const& of_group = motion_of_group(of_all, number_);
    X const origin = X::Zero();
    motion_.velocity_now = of_group.velocity(origin, now);
    motion_.way = of_group.displaced(origin, 0.0, now);
    motion_.since = now;
  }
  /// Whether a change of the velocity of the wall is due.
  bool is_due(S const& solver) const override {
    return solver.steps() == 0 || has_come(motion_.since + interval_, solver.time());
  }
  /// Measures the pressure on the wall and gives the wall a new velocity. Throws std::invalid_argument if the wanted
  /// pressure is negative or not finite.
  void act(S& solver) override {
    double const wanted = settings_.pressure(solver.time());
    check_setting(wanted >= 0 && std::isfinite(wanted), "pressure (Pa) of a controlled load", wanted, "0 or more");
    pressure_ = -wall_load(solver, walls_, settings_.group).force.dot(settings_.direction) / settings_.area;
    double const v = motion_.velocity_now.dot(settings_.direction);
    double const next = v / 2 + (wanted - pressure_) / (2 * impedance_);
    motion_ = motion_.turned_to(next * settings_.direction, solver.time());
    give_motion_to(solver);
  }
  /// Returns the pressure at the last change of the velocity, Pa.
  double pressure() const { return pressure_; }
  /// Returns the displacement of the wall along the direction (m) at a time (s) not before the last change of the
  /// velocity.
  double way(double time) const { return motion_.displaced(X(X::Zero()), 0.0, time).dot(settings_.direction); }

  /// Returns the settings that a continued run must share: group, direction, area and speed of sound.
  std::string signature() const override {
    std::string text = "load on " + settings_.group + ": along";
    for (int axis = 0; axis < dim; ++axis) (text += ' ') += detail::formatted("%.17g", settings_.direction[axis]);
    return text + detail::formatted(", area %.17g, speed of sound %.17g\n", settings_.area, settings_.sound_speed);
  }
  void save(Snapshot& snapshot) const override {
    auto numbers = motion_.numbers();
    numbers.push_back(pressure_);
    add_numbers(snapshot, "load on " + settings_.group, unit, numbers);
  }
  std::function<void(S&)> read(Snapshot const& snapshot) override {
    auto const numbers = numbers_of(snapshot, "load on " + settings_.group, unit, Steered<dim>::number_count + 1);
    Steered<dim> motion;
    try {
      motion = Steered<dim>::from_numbers(numbers);
    } catch (std::invalid_argument const& error) {
      throw std::runtime_error(std::string(error.what()) + " in a snapshot");
    }
    if (motion.since > snapshot.time)
      throw std::runtime_error(detail::formatted("scree: a snapshot of %g s has a load on %s that changed at %g s",
                                                 snapshot.time, settings_.group.c_str(), motion.since));
    return [this, motion, pressure = numbers.back()](S& solver) {
      motion_ = motion, pressure_ = pressure;
      give_motion_to(solver);
    };
  }

 private:
  static constexpr char const* unit = "s, m, m/s, Pa";
  void give_motion_to(S& solver) const {
    auto all = solver.settings().motion;
    if constexpr (requires { all.set(number_, motion_); })
      all.set(number_, motion_);
    else
      all = motion_;
    solver.set_motion(all);
  }

  ControlledLoad<dim> settings_;
  double impedance_ = 0, interval_ = 0;  // kg/(m^2 s), s
  Groups<dim> walls_;
  int number_;
  Steered<dim> motion_;
  double pressure_ = 0;  // Pa
};

}  // namespace scree
