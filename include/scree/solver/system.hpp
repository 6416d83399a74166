// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/periodic.hpp"
#include "../kernels/kernel.hpp"
#include "saved_fields.hpp"
#include "searches.hpp"
#include "sort.hpp"

#include <vector>

namespace scree {

/// Particles of all bodies with their kernel, neighbours and periodic images: the data that passes work on.
template <class P, class Search, class MaterialFields, class WallFields>
class System {
 public:
  using policy = P;

  System(typename P::space const& space, double smoothing_length, std::vector<Period> const& periods)
      : kernel_(smoothing_length),
        bodies_{Particles<P, MaterialFields>(space), Particles<P, WallFields>(space)},
        images_{images_of(periods), images_of(periods)},
        searches_(kernel_.radius()) {}
  /// On the default instance.
  System(double smoothing_length, std::vector<Period> const& periods)
      : System(typename P::space(), smoothing_length, periods) {}

  typename P::space const& space() const { return bodies_.material.space(); }
  kernel_of<P> const& kernel() const { return kernel_; }

  template <BodyTag Body>
  auto& body() {
    return bodies_.template of<Body>();
  }
  template <BodyTag Body>
  auto const& body() const {
    return bodies_.template of<Body>();
  }

  /// Call this after positions changed,
  void positions_changed() { stale_ = true; }
  /// and this at the beginning of a step. Particles that left a period return here, when lists are built anyway.
  void begin_step() {
    if (images_.material.any() && (stale_ || wrap_due_)) bring_up_to_date(true);
  }
  /// The same, but also sorts the material by cells and builds all lists.
  void begin_step_sorted() {
    stop_if_trial_failed();
    wrap();
    sort_along_cells(bodies_.material, kernel_.radius());
    renew();
  }

  /// Neighbours of the target body's particles among the source body's, for the present positions.
  template <BodyTag Target, BodyTag Source>
  auto const& neighbours() {
    bring_up_to_date(false);
#ifdef SCREE_CHECK_LISTS
    if (!trial_.under_way && searches_.outdated(now()))
      throw std::logic_error("scree: neighbour lists are used beyond their skin");
#endif
    return searches_.template neighbours<Target, Source>(now());
  }
  /// Copies fields of the owned particles to their images; positions must be among them.
  template <BodyTag Body, class List>
  void refresh_ghosts(List fields) {
    bring_up_to_date(false);
    images_.template of<Body>().refresh(body<Body>(), fields);
  }
  long neighbour_builds() const { return searches_.builds(); }
  std::vector<Period> const& periods() const { return images_.material.periods(); }
  /// The number of particles of a body with its images, if its owned particles are at these positions.
  int extent_at(std::vector<Vec<P::dim, typename P::real>> const& positions) const {
    Particles<P, Fields<Position>> body(space(), static_cast<int>(positions.size()));
    body.from_host(position, positions);
    images_of(periods()).create(body);
    return body.extent();
  }

  /// Begins a trial where that saves time (on a GPU). The watch checks rarely during a trial, so steps may turn out to
  /// have used lists that were no longer valid. Returns whether a trial has begun.
  bool begin_trial() {
    if constexpr (!detail::has_trials<typename P::space>) return false;
    if (trial_.under_way || shown_) {
      // A trial does not outlive lists: they are built here rather than within the step.
      begin_step();
      bring_up_to_date(false);
      shown_ = false;
    }
    if (!searches_.watch().may_look_rarely()) return false;
    trial_.material.save(bodies_.material.columns());
    trial_.wall.save(bodies_.wall.columns());
    trial_.stale = stale_, trial_.wrap_due = wrap_due_;
    trial_.history = searches_.watch().look_rarely();
    return trial_.under_way = true;
  }
  /// Whether steps must be repeated: after detail::ListsOutrun, or if this is true. Waits for all kernels of the
  /// system.
  bool trial_failed() {
    if (!trial_.under_way) return false;
    space().fence("scree::trial");
    return searches_.watch().outrun();
  }
  /// Call this before others read or change the state.
  void end_trial() {
    if (trial_.under_way) searches_.watch().look_always();
    trial_.under_way = false;
    shown_ = true;
  }
  /// Returns to the beginning of the trial. These lists allow no further trial.
  void undo_trial() {
    trial_.material.restore(bodies_.material.columns());
    trial_.wall.restore(bodies_.wall.columns());
    stale_ = trial_.stale, wrap_due_ = trial_.wrap_due;
    searches_.watch().go_back(trial_.history);
    trial_.under_way = false;
    ++trial_.failures;
    guard_positions();
  }
  long failed_trials() const { return trial_.failures; }

  /// The state that the order of neighbours depends on besides the fields, for snapshots.
  struct Memory {
    typename Searches<P, Search>::Memory searches;
    bool stale = true, wrap_due = false;
  };
  Memory memory() const { return {searches_.memory(), stale_, wrap_due_}; }
  /// Sets the system to the state of another one with the same fields: pour() sets the fields of owned particles.
  template <class Pour>
  void restore(Memory const& memory, Pour const& pour) {
    searches_.restore(space(), memory.searches);
    if constexpr (requires { memory.searches.first; }) {
      // Images belong to the positions that the lists were built from.
      restore_images(memory.searches.first, bodies_.material, images_.material);
      restore_images(memory.searches.second, bodies_.wall, images_.wall);
    }
    pour();
    positions_changed();
    stale_ = memory.stale;
    wrap_due_ = memory.wrap_due;
    end_trial();
  }

 private:
  PeriodicImages<P> images_of(std::vector<Period> const& periods) const {
    // Together two particles may cross the margin, and may be outside of a period by it.
    return {periods, kernel_.radius(), 2 * Searches<P, Search>::margin(kernel_.radius())};
  }
  PerBody<Places<P>> now() const {
    return {{bodies_.material[position], bodies_.material.size()}, {bodies_.wall[position], bodies_.wall.size()}};
  }
  void bring_up_to_date(bool between_steps) {
    bool const must = between_steps && wrap_due_;
    if (!must && !stale_) return;
    if (!must && searches_.serve(now())) {
      stale_ = false;
      return guard_positions();
    }
    // Within a step integrators rely on earlier positions, so particles must not jump.
    wrap_due_ = images_.material.any();
    if (between_steps) wrap();
    renew();
  }
  void wrap() {
    images_.material.wrap(bodies_.material);
    images_.wall.wrap(bodies_.wall);
    wrap_due_ = false;
  }
  void stop_if_trial_failed() {
    if (trial_failed()) throw detail::ListsOutrun();
  }
  void renew() {
    stop_if_trial_failed();
    images_.material.create(bodies_.material);
    images_.wall.create(bodies_.wall);
    searches_.renew(now());
    stale_ = trial_.under_way = false;
    guard_positions();
  }
  void guard_positions() {
    bodies_.material.guard_positions(searches_.watch().guard_of_first());
    bodies_.wall.guard_positions(searches_.watch().guard_of_second());
  }
  template <class Kept, class Body>
  static void restore_images(Kept kept, Body& body, PeriodicImages<P>& images) {
    if (!images.any() || kept.empty()) return;
    kept.resize(static_cast<std::size_t>(body.size()));
    body.from_host(position, kept);
    images.create(body);
  }

  /// The state at the beginning of a trial.
  struct Trial {
    bool under_way = false;
    long failures = 0;
    detail::SavedFields<typename P::space> material, wall;
    typename Searches<P, Search>::Watch::History history;
    bool stale = false, wrap_due = false;
  };

  kernel_of<P> kernel_;
  PerBody<Particles<P, MaterialFields>, Particles<P, WallFields>> bodies_;
  PerBody<PeriodicImages<P>> images_;
  Searches<P, Search> searches_;
  bool stale_ = true;  // positions changed since the last update of the searches
  bool wrap_due_ = false;
  bool shown_ = true;  // others may have changed positions without the guards
  Trial trial_;
};

}  // namespace scree
