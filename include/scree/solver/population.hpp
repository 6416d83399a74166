// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/records.hpp"
#include "../openings/openings.hpp"
#include "../system/pick.hpp"
#include "added.hpp"
#include "stepper.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

/// A stepper whose particles come and go between steps: by hand, through inlets, drains and open ends. The parts of a
/// case call these functions together, with the same arguments, and get the same results.
template <class P>
class Population : public Stepper<P> {
  using Base = Stepper<P>;

 public:
  using Base::evolves_position, Base::material, Base::neighbour_builds, Base::space, Base::time, Base::update_rates;
  using typename Base::Basis;
  using typename Base::vector;

  /// Adds particles to the material, with new identities:
  ///   solver.add(points, given(fields::velocity, u), given(fields::concentration, [](auto const& x) { return ...; }));
  /// Each gets the volume spacing^dim unless that is given; other fields that are not given are zero. Throws
  /// std::invalid_argument, and adds none, if they overlap with others or with walls, or if their distances or volumes
  /// do not fit the spacing (see `start_checks`). Call it between steps, in an observer for example. Rates are
  /// evaluated again.
  template <class... Fs, class... Values>
  void add(std::vector<vector> const& points, Given<Fs, Values> const&... values) {
    detail::static_check_given<P, Fs...>();
    if (points.empty()) return;
    place(points, {"among those to be added,", " of those that are there"}, values...);
    particles_changed();
  }
  // Called with something else, the compiler says what is wrong with the points.
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
    check_settings_of(condition);
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
    using namespace fields;
    static_assert(evolves_position, "inlets need a physics model that evolves the position of the material");
    static_assert(!OneOf<Velocity, Fields<Fs...>>, "the velocity of particles that enter is that of the inlet");
    detail::static_check_given<P, Fs...>();
    static constexpr bool can_hold = OneOf<Held, material_fields<P>>;
    if (inlet.pushes && !can_hold)
      throw std::invalid_argument("scree: inlet '" + inlet.name +
                                  "' pushes, so the formulation needs `using carries = Fields<Held>`; without it set "
                                  "`.pushes = false`");
    if (settings_.start_checks) {
      detail::check_layer(inlet, settings_.spacing);
      if constexpr (requires { settings_.physics.fastest_inlet(); })
        detail::check_speed(inlet, settings_.physics.fastest_inlet());
    }
    vector const u = inlet.velocity.template cast<typename P::real>();
    openings().add(
        inlet, settings_.spacing, support(),
        [=](Population& now, std::vector<Vec<P::dim, double>> const& layer, int number) {
          std::vector<vector> points;
          for (auto const& x : layer) points.push_back(x.template cast<typename P::real>());
          StartWords const words{"among those that enter,", " of those that are there", true};
          if constexpr (can_hold)
            return now.place(points, words, given(velocity, u), given(held, number), values...);
          else
            return now.place(points, words, given(velocity, u), values...);
        },
        [](Population& now, int number, Vec<P::dim, double> const& direction, double beyond) {
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
    check_settings_of(within);
    openings().add(settings, support(), system_.half_skin(),
                   emptied(within, Merge<Fields<Identity, Volume>, Fields<Fs...>>{}, receive));
  }
  /// Opens an end (openings/open_end.hpp) where particles leave with given fields: values, or functions of the position
  /// (m) that a device can call.
  template <class... Fs, class... Values>
  void open_end(OpenEnd<P::dim> const& end, Given<Fs, Values> const&... values) {
    static_assert(OneOf<Held, material_fields<P>>,
                  "an open end keeps the velocity of particles that leave: the formulation needs "
                  "`using carries = Fields<Held>`");
    Vec<P::dim, double> const out = end.normal.normalized();
    auto const beyond = [&](double supports) { return Beyond<P::dim>{end.point + supports * support() * out, out}; };
    auto const keep = [=, near = beyond(0), far = beyond(1)](Population& now) {
      auto const& all = now.material();
      detail::KeepBeyond<Basis, Fields<Fs...>, Values...> const loop(
          near, far, all.select(Fields<Position, Held>{}), all.select(Fields<Held, Fs...>{}), values.value...);
      for_each_index(now.space(), "scree::open_end", 0, all.size(), loop);
    };
    long const there = this->parts().sum(long(material().size()));
    if (there > 0 && this->parts().sum(long(pick(material(), beyond(0)).size())) == there)
      throw std::invalid_argument("scree: all particles of the material are beyond the open end '" + end.name +
                                  "', and would leave: its normal must point out of the domain");
    openings().add(end, support(), system_.half_skin(), keep, emptied(beyond(2), Fields<Volume>{}, detail::Ignore()));
  }
  /// The volume and number that came through each inlet and left through each drain.
  std::vector<Passed> entered() const { return openings_ ? openings_->entered() : std::vector<Passed>(); }
  std::vector<Passed> left() const { return openings_ ? openings_->left() : std::vector<Passed>(); }
  /// The number of particles that the solver was made with.
  long particles_at_start() const { return at_start_; }
  /// How many particles of the material came and went, on all parts: the number at the start + added - removed is the
  /// number now.
  Turnover const& turnover() const { return system_.template turnover<Material>(); }
  /// Advances by one step of at most `longest` (s); returns its length. Throws std::invalid_argument unless `longest`
  /// is positive; it may be infinite if the physics model limits the step. Throws std::logic_error as run() does.
  double step(double longest) {
    check_setting(longest > 0, "the length of a step (s)", longest, "above 0");
    detail::Busy::Hold const hold(busy_);
    open();
    double const dt = step_closed(longest);
    if (openings_due()) serve_openings();
    return dt;
  }

 protected:
  using Base::at_start_, Base::busy_, Base::check_start_once, Base::control_, Base::followers_, Base::settings_,
      Base::started_, Base::steps_, Base::support, Base::system_, Base::time_;
  using Base::Base;
  using typename Base::AtStart;
  long next_identity() const { return at_start_ + turnover().added; }
  void particles_changed() {
    system_.particles_changed();
    control_.look_before(steps_);
    if (started_) update_rates();
  }
  /// Adds particles without neighbours; returns their volume, m^dim.
  template <class... Fs, class... Values>
  double place(std::vector<vector> const& points, StartWords const& words, Given<Fs, Values> const&... values) {
    ProfilingRegion const region("scree::add");
    busy_.check_is_here();
    check_number(double(points.size()) + double(next_identity()));
    auto const volumes = detail::volumes_at<Basis>(points, settings_.spacing, values...);
    if (settings_.start_checks) detail::check_added(system_, settings_, points, volumes, words);
    double const added = detail::append(system_, static_cast<int>(next_identity()), points, volumes, values...);
    followers_.confines().add_material(points);
    return added;
  }
  /// Removes particles; those that are left have no neighbours until particles_changed().
  template <class Condition, class List>
  auto take_out(Condition const& condition, List fields) {
    ProfilingRegion const region("scree::remove");
    busy_.check_is_here();
    auto const gone = pick(material(), condition);
    auto const removed = this->parts().order_of(material(), gone).of(records_of(material(), fields, gone));
    if (!removed.empty()) system_.template keep<Material>(pick(material(), condition, false));
    return removed;
  }
  /// What a drain does.
  template <class Condition, class List, class Receive>
  static auto emptied(Condition const& within, List handed, Receive const& receive) {
    return [=](Population& now, Passed& passed) {
      auto const gone = now.take_out(within, handed);
      for (auto const& each : gone) passed.volume += double(each[fields::volume]);
      passed.particles += long(gone.size());
      if (!gone.empty()) receive(now.time(), gone);
    };
  }
  detail::Openings<Population>& openings() {
    if (!openings_) openings_ = std::make_unique<detail::Openings<Population>>();
    return static_cast<detail::Openings<Population>&>(*openings_);
  }
  bool openings_due() const { return openings_ && openings_->due(time_, neighbour_builds()); }
  void open() {
    if (!openings_) return;
    if (!started_) check_start_once(), openings_->keep(*this);
    if (openings_due()) serve_openings();
  }
  /// Feeds inlets and empties drains. Rates of those who enter are zero until they are evaluated in the next step.
  void serve_openings() {
    ProfilingRegion const region("scree::openings");
    Turnover const before = turnover();
    openings_->serve(*this, time_, neighbour_builds());
    if (before == turnover()) return;
    system_.particles_changed();
    control_.look_before(steps_);
  }
  /// One step, without what comes and goes after it.
  double step_closed(double longest) {
    ProfilingRegion const region("scree::step");
    double const dt = Base::take_step(longest);
    if (openings_) openings_->keep(*this);
    return dt;
  }

  std::unique_ptr<detail::AnyOpenings<Population>> openings_;
};

}  // namespace scree
