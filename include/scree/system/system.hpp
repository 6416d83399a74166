// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../fields/bodies.hpp"
#include "../fields/whole_body.hpp"
#include "../kernels/kernel.hpp"
#include "instances.hpp"
#include "neighbourhood.hpp"
#include "periodic.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// A body of a system with its fields.
template <BodyTag Body, class List>
struct BodyWith {
  using body = Body;
  using fields = List;
};

/// The data on which passes work: the particles of all bodies and their kernel, with neighbours and ghosts that are
/// kept up to date with the positions. The state of a system can be saved and restored. A system handles bodies and
/// fields as types, because passes need these types, and delegates the work to a Neighbourhood, which handles bodies as
/// values.
template <class P, class Search, class Ghosts, class... OfBodies>
class System {
  using Around = detail::Neighbourhood<P, Search, Ghosts>;

 public:
  using policy = P;
  using bodies = Bodies<typename OfBodies::body...>;
  static constexpr std::size_t count = sizeof...(OfBodies);  ///< the number of bodies

  /// Makes bodies without particles on an instance of the execution space, and the kernel with its smoothing length
  /// (m).
  System(typename P::space const& space, double smoothing_length, typename Ghosts::Settings const& of_ghosts)
      : kernel_(smoothing_length),
        bodies_{{Particles<P, typename OfBodies::fields>(space)}...},
        around_(kernel_.radius(), evolves, count, of_ghosts) {}
  /// Makes bodies without particles on the default instance of the execution space, and the kernel with its smoothing
  /// length (m).
  System(double smoothing_length, typename Ghosts::Settings const& of_ghosts)
      : System(typename P::space(), smoothing_length, of_ghosts) {}
  /// Returns the instance of the execution space in which all loops run.
  typename P::space const& space() const { return detail::value_at<0>(bodies_).space(); }
  /// Returns the kernel with its smoothing length.
  kernel_of<P> const& kernel() const { return kernel_; }

  /// Returns the particles of a body.
  template <BodyTag Body>
  auto& body() {
    return detail::value_at<number<Body>>(bodies_);
  }
  /// Returns the particles of a body.
  template <BodyTag Body>
  auto const& body() const {
    return detail::value_at<number<Body>>(bodies_);
  }

  /// Announces that positions have changed.
  void positions_changed() { around_.positions_changed(); }
  /// Brings ghosts up to date at the beginning of a step. If this requires new lists, particles that have left a period
  /// are wrapped first.
  void begin_step() { around_.begin_step(all()); }
  /// Begins a step: sorts the particles of evolving bodies by cells and builds all lists.
  void begin_step_sorted() { around_.begin_step_sorted(all()); }

  /// Returns the neighbours of the particles of the target body in the source body, for the present positions. Throws
  /// detail::ListsOutrun if steps of a trial have used lists that were no longer valid. If SCREE_CHECK_LISTS is
  /// defined, throws std::logic_error if steps outside a trial use such lists.
  template <BodyTag Target, BodyTag Source>
  auto const& neighbours() {
    auto const& found = searched<Target, Source>();
#ifdef SCREE_CHECK_LISTS
    around_.check_lists(all());
#endif
    return found;
  }
  /// Copies fields of the owned particles to their ghosts. The fields must include positions.
  template <BodyTag Body, class List>
  void refresh_ghosts(List fields) {
    around_.refresh_ghosts(all(), number<Body>, column_numbers<fields_of<Body>>(fields));
#ifdef SCREE_CHECK_LISTS
    std::array<ColumnNumbers, count> of_bodies;
    of_bodies[number<Body>] = column_numbers<fields_of<Body>>(fields);
    around_.check_ghosts(all(), of_bodies.data());
#endif
  }
  /// The numbers of the columns of each body that hold the fields `Some::of<Body>`.
  template <class Some>
  static constexpr std::array<ColumnNumbers, count> columns = {
      detail::ColumnNumbersOf<typename OfBodies::fields,
                              typename Some::template of<typename OfBodies::body>>::value...};
  /// Runs passes in order. Ghosts are refreshed before each pass that reads them.
  void run(std::span<detail::AnyPass const> passes) { around_.run(all(), passes, this); }
  /// Throws std::logic_error if the values of ghosts in these columns of each body differ from the values of their
  /// origins. The check runs only if SCREE_CHECK_LISTS is defined and the ghosts are those of several ranks.
  void check_ghosts([[maybe_unused]] ColumnNumbers const* of_bodies) {
#ifdef SCREE_CHECK_LISTS
    around_.check_ghosts(all(), of_bodies);
#endif
  }
  /// Returns the number of builds of the neighbour lists.
  long neighbour_builds() const { return around_.neighbour_builds(); }
  /// Returns the largest displacement of a particle between two builds of the lists, excluding the last update, m; 0 if
  /// lists are built at each update.
  double half_skin() const { return around_.half_skin(); }

  /// Appends particles to a body, with zeros in all fields, where the case takes new particles, and returns the index
  /// of the first. Call particles_changed() once the positions of the new particles are set.
  template <BodyTag Body>
  int append(int particles) {
    return around_.append(all(), number<Body>, particles);
  }
  /// Keeps only the owned particles of a body with these indices, in this order. Call particles_changed() afterwards.
  template <BodyTag Body>
  void keep(Array<P, int const> const& numbers) {
    around_.keep(all(), number<Body>, numbers);
  }
  /// Builds all lists and ghosts for the new set of particles, after append() or keep().
  void particles_changed() { around_.particles_changed(all()); }
  /// Returns the numbers of particles added and removed in the whole case since the system was made.
  template <BodyTag Body>
  Turnover const& turnover() const {
    return around_.turnover(number<Body>);
  }
  /// Returns the ghosts of the first body.
  Ghosts const& ghosts() const { return around_.ghosts(); }
  /// Begins with the particles that a solver is given. Throws std::invalid_argument if these are not all of the case.
  template <class Start>
  void begin(Start const& start) {
    around_.begin(start);
  }
  /// Moves the particles of a share to where they belong.
  void settle_shares() { around_.settle_shares(all()); }
  /// Calls visit(copies) with copies of the particles of a body that are elsewhere or, if `images` is true, are
  /// periodic images, and that lie within a distance (m) of the bounding box of the particles of all bodies here. Does
  /// not call it if all particles are here.
  template <BodyTag Body, class List, class Visit>
  void with_copies_near(double distance, bool images, List list, Visit const& visit) const {
    around_.with_copies_near(all(), number<Body>, distance, images, list, visit);
  }
  /// Returns the agreement on what is true of the whole case: WholeCase, or an Agreement of its ranks.
  auto const& whole_case() const { return around_.whole_case(); }
  /// Returns a body of the whole case at a time (s); see WholeBody.
  template <BodyTag Body>
  auto whole(double time = 0) const {
    return WholeBody(body<Body>(), whole_case(), time);
  }
  /// Returns the number of particles that a body would have, images included, if its owned particles were at these
  /// positions.
  int extent_at(std::vector<Vec<P::dim, typename P::real>> const& positions) const {
    return around_.extent_at(space(), positions);
  }

  /// Begins a trial if that saves time, as on a GPU, and returns whether a trial has begun. During a trial, neighbour
  /// lists are checked rarely, so its steps may turn out to have used lists that were no longer valid.
  bool begin_trial() {
    if constexpr (detail::has_trials<typename P::space>)
      return around_.begin_trial(all());
    else
      return false;
  }
  /// Whether a trial is in progress.
  bool in_trial() const { return around_.in_trial(); }
  /// Whether the steps of the trial must be repeated because they have used invalid lists, which detail::ListsOutrun
  /// reports during a step. Waits for all kernels of the system.
  bool trial_failed() { return around_.trial_failed(all()); }
  /// Throws detail::ListsOutrun if the trial has failed.
  void stop_if_trial_failed() { around_.stop_if_trial_failed(all()); }
  /// Ends the trial and keeps its steps. Call this before other code reads or changes the state.
  void end_trial() { around_.end_trial(); }
  /// Restores the state at the beginning of the trial. No further trial can begin until lists are built again.
  void undo_trial() { around_.undo_trial(all()); }
  /// Returns the number of failed trials, whose steps were repeated.
  long failed_trials() const { return around_.failed_trials(); }

  /// The state, saved in snapshots, that together with the fields determines the order of neighbours.
  using Memory = typename Around::Memory;
  /// Returns the state that, in addition to the fields, determines the order of neighbours.
  Memory memory() const { return around_.memory(all()); }
  /// Restores the state of another system with the same fields and all particles of the case. pour(kept) must set the
  /// fields of the owned particles; `kept` lists the particles of each body that stay here; none: all do.
  template <class Pour>
  void restore(Memory memory, Pour const& pour) {
    pour(around_.begin_restore(all(), memory));
    around_.end_restore(memory);
  }

 private:
  static constexpr bool evolves[] = {EvolvingBody<typename OfBodies::body>...};
  template <BodyTag Body>
  static constexpr std::size_t number = body_index<Body, bodies>();
  template <BodyTag Body>
  using fields_of = typename detail::type_at<number<Body>, detail::Tuple<OfBodies...>>::fields;
  std::array<AnyParticles<P>*, count> all() { return {&body<typename OfBodies::body>()...}; }
  std::array<AnyParticles<P> const*, count> all() const { return {&body<typename OfBodies::body>()...}; }
  template <BodyTag Target, BodyTag Source>
  auto const& searched() {
    if constexpr (std::is_same_v<Target, Source>)
      return around_.within(all(), number<Target>);
    else
      return around_.among(all(), number<Target>, number<Source>);
  }

  kernel_of<P> kernel_;
  detail::TupleValues<std::index_sequence_for<OfBodies...>, Particles<P, typename OfBodies::fields>...> bodies_;
  Around around_;
};

}  // namespace scree
