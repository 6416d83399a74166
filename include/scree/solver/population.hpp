// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/slip_normal.hpp"
#include "../fields/records.hpp"
#include "../openings/openings.hpp"
#include "../system/pick.hpp"
#include "added.hpp"
#include "state.hpp"

#include <stdexcept>
#include <vector>

// Particles of the material that are added or removed between steps: by the user, or through inlets, drains and open
// ends. All ranks of a case call these functions together, with the same arguments, and get the same results.
namespace scree::detail {

/// Adds particles, which have no neighbours until SolverState::particles_changed() is called; returns their total
/// volume, m^dim.
template <class P, class... Fs, class... Values>
double add_particles(SolverState<P>& state, std::vector<typename SolverState<P>::vector> const& points,
                     StartWords const& words, StartWords const& at_walls, Given<Fs, Values> const&... values) {
  ProfilingRegion const region("scree::add");
  state.busy.check_is_here();
  check_number(double(points.size()) + double(state.next_identity()));
  auto const volumes = volumes_at<basis_of<P>>(points, state.settings.spacing, values...);
  if (state.settings.start_checks) check_added(state.system, state.settings, points, volumes, words, at_walls);
  double const added = append(state.system, static_cast<int>(state.next_identity()), points, volumes, values...);
  state.followers.confines().add_material(points);
  return added;
}
/// Removes the particles that satisfy a condition, and returns the given fields of the removed particles. The remaining
/// particles have no neighbours until SolverState::particles_changed() is called.
template <class P, class Condition, class List>
auto remove_particles(SolverState<P>& state, Condition const& condition, List fields) {
  ProfilingRegion const region("scree::remove");
  state.busy.check_is_here();
  auto const whole = state.system.template whole<Material>();
  auto const& material = whole.here();
  auto const gone = pick(material, condition);
  auto const removed = whole.order(gone).of(records_of(material, fields, gone));
  if (!removed.empty()) state.system.template keep<Material>(pick(material, condition, false));
  return removed;
}

/// Returns the action of a drain, which removes the particles that satisfy a condition, counts them and passes them to
/// `receive`.
template <class P, class Condition, class List, class Receive>
auto emptied(Condition const& within, List handed, Receive const& receive) {
  return [=](SolverState<P>& now, Passed& passed) {
    auto const gone = remove_particles(now, within, handed);
    for (auto const& each : gone) passed.volume += double(each[fields::volume]);
    passed.particles += long(gone.size());
    if (!gone.empty()) receive(now.clock.time, gone);
  };
}
/// Warns if an inlet rains full layers between rough walls, within 45 degrees of gravity and faster than `most` (m/s).
template <class P>
[[gnu::cold]] void warn_of_block(SolverState<P> const& state, Inlet<P::dim> const& inlet, double most) {
  auto const& settings = state.settings;
  double const speed = inlet.velocity.norm();
  Vec<P::dim, double> const g = gravity_of(settings.physics).template vector<Vec<P::dim, double>>();
  bool const falls = inlet.velocity.dot(g) > 0.7 * speed * g.norm();
  if (!(speed > most) || !falls || !rains_in_full(inlet, settings.spacing)) return;
  bool beside = false;
  auto const box = corners_of(inlet.layer);  // most wall particles are far from the inlet
  for_each_body(not_rigid_among<following_bodies<P>>{}, [&]<class Body>() {
    auto const& walls = state.system.template body<Body>();
    auto const x = walls.to_host(fields::position);
    std::vector<char> smooth(x.size());
    if constexpr (OneOf<SlipNormal, typename std::remove_cvref_t<decltype(walls)>::fields>) {
      auto const normals = walls.to_host(fields::slip_normal);
      for (std::size_t i = 0; i < x.size(); ++i) smooth[i] = normals[i].squaredNorm() > 0;
    }
    for (std::size_t i = 0; i < x.size() && !beside; ++i) {
      Vec<P::dim, double> const point = x[i].template cast<double>();
      if (!smooth[i] && (point - point.cwiseMax(box.front()).cwiseMin(box.back())).norm() < 1.4 * settings.spacing)
        beside = is_beside(inlet, point, settings.spacing);
    }
  });
  if (state.system.whole_case().anywhere(beside) && settings.warn && state.system.whole_case().reports())
    settings.warn(warning_of_block(inlet.name, speed, most));
}
template <class S, class P, class... Fs, class... Values>
void add_inlet(Openings<S, SolverState<P>>& openings, SolverState<P> const& state, Inlet<P::dim> const& inlet,
               Given<Fs, Values> const&... values) {
  using namespace fields;
  using vector = typename SolverState<P>::vector;
  using real = typename P::real;
  static constexpr bool can_hold = OneOf<Held, material_fields<P>>;
  if (inlet.pushes && !can_hold)
    throw std::invalid_argument("scree: inlet '" + inlet.name +
                                "' pushes, so the formulation needs `using carries = Fields<Held>`; without it set "
                                "`.pushes = false`");
  if constexpr (OneOf<Volume, Fields<Fs...>>)
    if (std::isfinite(inlet.rate))
      throw std::invalid_argument("scree: inlet '" + inlet.name +
                                  "' has a rate and particles of a given volume: its rate is that of particles of the "
                                  "volume spacing^dim, so give one of the two");
  if (state.settings.start_checks) {
    check_layer(inlet, state.settings.spacing);
    if constexpr (requires { state.settings.physics.fastest_inlet(); })
      check_speed(inlet, state.settings.physics.fastest_inlet());
    if constexpr (P::dim == 3 && requires { state.settings.physics.fastest_rain(); })
      warn_of_block(state, inlet, state.settings.physics.fastest_rain());
  }
  vector const u = inlet.velocity.template cast<real>();
  auto const make = [=](SolverState<P>& now, std::vector<Vec<P::dim, double>> const& layer, int number) {
    std::vector<vector> points;
    for (auto const& x : layer) points.push_back(x.template cast<real>());
    StartWords const words{.when = "among those that enter,",
                           .of_others = " of those that are there",
                           .may_be_sparse = true,
                           .remedy =
                               "material has backed up to the inlet: move the inlet farther from it, feed less "
                               "(`rate`, `duration`) or remove material (`drain`)"};
    // The density of a single layer is about 1.5 inside a wall, and at most 1.05 beside walls.
    StartWords const at_walls{.when = words.when,
                              .may_be_sparse = true,
                              .remedy =
                                  "a wall is in the way of the inlet: the points of its `layer` must be a spacing "
                                  "from the particles of walls; move the inlet, or leave out points",
                              .most_density = 1.3};
    if constexpr (can_hold)
      return add_particles(now, points, words, at_walls, given(velocity, u), given(held, number), values...);
    else
      return add_particles(now, points, words, at_walls, given(velocity, u), values...);
  };
  auto const let_go = [](SolverState<P>& now, int number, Vec<P::dim, double> const& direction, double beyond) {
    if constexpr (can_hold)
      for_each_particle<basis_of<P>>("scree::let_go", now.system.template body<Material>(),
                                     Release<vector>{number, direction.template cast<real>(), real(beyond)});
  };
  openings.add(inlet, state.settings.spacing, state.support(), make, let_go);
}
template <class S, class P, class... Fs, class... Values>
void add_open_end(Openings<S, SolverState<P>>& openings, SolverState<P> const& state, OpenEnd<P::dim> const& end,
                  Given<Fs, Values> const&... values) {
  Vec<P::dim, double> const out = end.normal.normalized();
  auto const beyond = [&](double supports) {
    return Beyond<P::dim>{end.point + supports * state.support() * out, out};
  };
  auto const keep = [=, near = beyond(0), far = beyond(1)](SolverState<P>& now) {
    auto const& all = now.system.template body<Material>();
    KeepBeyond<basis_of<P>, Fields<Fs...>, Values...> const loop(near, far, all.select(Fields<Position, Held>{}),
                                                                 all.select(Fields<Held, Fs...>{}), values.value...);
    for_each_index(now.system.space(), "scree::open_end", 0, all.size(), loop);
  };
  auto const material = state.system.template whole<Material>();
  long const there = material.size();
  if (there > 0 && material.sum(long(pick(material.here(), beyond(0)).size())) == there)
    throw std::invalid_argument("scree: all particles of the material are beyond the open end '" + end.name +
                                "', and would leave: its normal must point out of the domain");
  openings.add(end, state.support(), state.system.half_skin(), keep, emptied<P>(beyond(2), Fields<Volume>{}, Ignore()));
}

}  // namespace scree::detail
