// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "formulation.hpp"

#include <algorithm>
#include <functional>
#include <string>

namespace scree {

/// What a solver is built from, besides its particles.
template <class P>
struct SolverSettings {
  double spacing = 0;      ///< initial distance of the particles, m
  double smoothing = 1.5;  ///< smoothing length / spacing, 1.1 to 3
  typename P::physics physics = {};
  typename P::motion motion = {};
  typename P::diagnostics diagnostics = {};
  std::vector<Period> periods = {};
};

namespace detail {

template <class Motion>
struct Prescribe {
  using reads = Fields<Position>;
  using writes = Fields<Position>;
  Motion motion;
  double from, to;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[position] = motion.displaced(i[position], from, to);
  }
};
template <class Motion>
struct PrescribeVelocity {
  using reads = Fields<Position>;
  using writes = Fields<Velocity>;
  Motion motion;
  double time;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[velocity] = motion.velocity(i[position], time);
  }
};

}  // namespace detail

/// Something to be done at given times.
template <class S>
struct Observer {
  std::function<double(double now)> next;  // next time after `now`, s
  std::function<void(S&)> act;
};

/// Advances one formulation in time. It only puts together what can be used on its own: passes, an integrator, a
/// motion.
template <class P>
class Solver {
  static_assert(detail::explain_formulation<P>());

 public:
  using policy = P;
  using Basis = basis_of<P>;
  using vector = Vec<P::dim, typename P::real>;
  using Observers = std::vector<Observer<Solver>>;

  /// Positions in m; every particle gets the volume spacing^dim.
  Solver(SolverSettings<P> const& settings, std::vector<vector> const& material, std::vector<vector> const& wall = {})
      : settings_(settings), system_(checked(settings).smoothing * settings.spacing, settings.periods) {
    place(system_.template body<Material>(), material);
    place(system_.template body<Wall>(), wall);
    system_.positions_changed();
    set_velocities();
  }

  auto const& material() const { return system_.template body<Material>(); }
  auto const& wall() const { return system_.template body<Wall>(); }
  double time() const { return time_; }
  long steps() const { return steps_; }
  long neighbour_builds() const { return system_.neighbour_builds(); }
  std::map<std::string, long> const& limits() const { return control_.counts(); }
  SolverSettings<P> const& settings() const { return settings_; }
  Resolution resolution() const {
    double const h = settings_.smoothing * settings_.spacing;
    return {.spacing = settings_.spacing, .smoothing_length = h, .support = P::kernel::support * h};
  }

  /// Sets a field of the material from a function of points, one per particle (host).
  template <Field F, class Points, class Function>
  void set(F field, Points const& points, Function const& function) {
    std::vector<value_t<P, F>> values;
    values.reserve(points.size());
    for (auto const& x : points) values.push_back(function(x));
    system_.template body<Material>().from_host(field, values);
  }
  /// The same with the present positions.
  template <Field F, class Function>
  void set(F field, Function const& function) {
    set(field, material().to_host(position), function);
  }

  /// Evaluates all passes for the present state, as at the beginning of a step.
  void update_rates() { run_passes(system_, settings_.physics.passes(resolution())); }

  /// Evaluates the passes that are for output only.
  void update_diagnostics() { run_passes(system_, settings_.diagnostics.passes(resolution())); }

  /// Advances by one step of at most `longest` (s); returns its length.
  double step(double longest) {
    using Evolved = typename P::physics::evolves;
    auto& material = system_.template body<Material>();
    system_.wrap_periods();
    system_.positions_changed();
    update_rates();
    auto limits = settings_.physics.limits(system_);
    limits.push_back({"motion", settings_.motion.time_step()});
    double const dt = control_.choose(limits, longest);
    P::integrator::template predict<Basis>(material, Evolved{}, dt);
    move(time_, time_ + dt / 2);
    update_rates();
    P::integrator::template correct<Basis>(material, Evolved{}, dt);
    move(time_ + dt / 2, time_ + dt);
    time_ += dt;
    ++steps_;
    return dt;
  }

  /// Runs until the given time (s), calling each observer at its times.
  void run(double until, Observers const& observers = {}) {
    std::vector<double> due;
    for (auto const& observer : observers) {
      if (time_ == 0) observer.act(*this);
      due.push_back(observer.next(time_));
    }
    while (time_ < until) {
      double const target = due.empty() ? until : std::min(until, *std::min_element(due.begin(), due.end()));
      while (time_ < target) {
        double const dt = step(target - time_);
        if (target - time_ < 1e-6 * dt) time_ = target;
      }
      for (std::size_t k = 0; k < due.size(); ++k) {
        if (due[k] > time_) continue;
        observers[k].act(*this);
        due[k] = observers[k].next(time_);
      }
    }
  }

 private:
  static SolverSettings<P> const& checked(SolverSettings<P> const& settings) {
    if (!(settings.spacing > 0)) throw std::invalid_argument("scree: spacing must be positive (m)");
    if (!(settings.smoothing >= 1.1 && settings.smoothing <= 3))
      throw std::invalid_argument("scree: smoothing (h/spacing) must lie between 1.1 and 3");
    return settings;
  }
  template <class Body>
  void place(Body& body, std::vector<vector> const& points) {
    body.resize(static_cast<int>(points.size()));
    std::vector<int> numbers(points.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<int>(k);
    body.from_host(position, points);
    body.from_host(identity, numbers);
    body.fill(volume, typename P::real(std::pow(settings_.spacing, P::dim)));
  }

  // Walls follow the motion; so does the material unless its position is evolved.
  void move(double from, double to) {
    detail::Prescribe<typename P::motion> const displacement{settings_.motion, from, to};
    if constexpr (!OneOf<Position, typename P::physics::evolves>)
      for_each_particle<Basis>("scree::move_material", material(), displacement);
    for_each_particle<Basis>("scree::move_wall", wall(), displacement);
    system_.positions_changed();
    set_velocities(to);
  }
  void set_velocities(double time = 0) {
    detail::PrescribeVelocity<typename P::motion> const prescribed{settings_.motion, time};
    if constexpr (OneOf<Velocity, material_fields<P>> && !OneOf<Position, typename P::physics::evolves>)
      for_each_particle<Basis>("scree::material_velocity", material(), prescribed);
    if constexpr (OneOf<Velocity, wall_fields<P>>) for_each_particle<Basis>("scree::wall_velocity", wall(), prescribed);
  }

  SolverSettings<P> settings_;
  system_of<P> system_;
  TimeStepControl control_;
  double time_ = 0;
  long steps_ = 0;
};

/// An observer that acts at 0, interval, 2 interval, ... (s).
template <class S>
Observer<S> every(double interval, std::function<void(S&)> act) {
  return {[interval](double now) { return interval * std::floor(now / interval * (1 + 1e-12) + 1); }, std::move(act)};
}
/// An observer that acts at given times (s).
template <class S>
Observer<S> at(std::vector<double> times, std::function<void(S&)> act) {
  std::sort(times.begin(), times.end());
  return {[times](double now) {
            auto const next = std::upper_bound(times.begin(), times.end(), now);
            return next == times.end() ? std::numeric_limits<double>::infinity() : *next;
          },
          std::move(act)};
}

}  // namespace scree
