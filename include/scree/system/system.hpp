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
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// A body of a system with the fields that it carries.
template <BodyTag Body, class List>
struct BodyWith {
  using body = Body;
  using fields = List;
};

/// The data that passes work on: particles of all bodies with their kernel, with neighbours and ghosts that follow the
/// positions. Its state can be saved and restored. Bodies and fields are types here, for passes; a Neighbourhood does
/// the work.
template <class P, class Search, class Ghosts, class... OfBodies>
class System {
  using Around = detail::Neighbourhood<P, Search, Ghosts>;

 public:
  using policy = P;
  using bodies = Bodies<typename OfBodies::body...>;
  static constexpr std::size_t count = sizeof...(OfBodies);                 ///< the number of bodies
  static constexpr bool tracks_changes = Around::Provider::tracks_changes;  ///< whether it asks for fields_changed()

  /// Bodies without particles on an instance of the execution space, with the smoothing length (m) of their kernel.
  System(typename P::space const& space, double smoothing_length, typename Ghosts::Settings const& of_ghosts)
      : kernel_(smoothing_length),
        bodies_{{Particles<P, typename OfBodies::fields>(space)}...},
        around_(kernel_.radius(), evolves, count, of_ghosts) {}
  /// On the default instance.
  System(double smoothing_length, typename Ghosts::Settings const& of_ghosts)
      : System(typename P::space(), smoothing_length, of_ghosts) {}
  /// The instance of the execution space in which all loops run.
  typename P::space const& space() const { return detail::value_at<0>(bodies_).space(); }
  /// The kernel with its smoothing length.
  kernel_of<P> const& kernel() const { return kernel_; }

  /// The particles of a body.
  template <BodyTag Body>
  auto& body() {
    return detail::value_at<number<Body>>(bodies_);
  }
  /// The particles of a body.
  template <BodyTag Body>
  auto const& body() const {
    return detail::value_at<number<Body>>(bodies_);
  }

  /// Announces that positions have changed.
  void positions_changed() { around_.positions_changed(); }
  /// Brings ghosts up to date at the beginning of a step. Particles that left a period return here, when lists are
  /// built anyway.
  void begin_step() { around_.begin_step(all()); }
  /// Begins a step by sorting the bodies that evolve by cells and building all lists.
  void begin_step_sorted() { around_.begin_step_sorted(all()); }

  /// Neighbours of the target body's particles among the source body's, for the present positions. Throws
  /// detail::ListsOutrun if steps on trial have used lists that were no longer valid; where SCREE_CHECK_LISTS is
  /// defined, std::logic_error if other steps have.
  template <BodyTag Target, BodyTag Source>
  auto const& neighbours() {
    auto const& found = searched<Target, Source>();
#ifdef SCREE_CHECK_LISTS
    around_.check_lists(all());
#endif
    return found;
  }
  /// Copies fields of the owned particles to their images; positions must be among them.
  template <BodyTag Body, class List>
  void refresh_ghosts(List fields) {
    around_.refresh_ghosts(all(), number<Body>, column_numbers<fields_of<Body>>(fields));
#ifdef SCREE_CHECK_LISTS
    std::array<ColumnNumbers, count> columns;
    columns[number<Body>] = column_numbers<fields_of<Body>>(fields);
    around_.check_ghosts(all(), columns.data());
#endif
  }
  /// refresh_ghosts() of all bodies for the fields that a pass reads of neighbours: `reads_j<Body>` of each body.
  template <class Pass>
  void refresh_ghosts_for(Pass const&) {
    static constexpr ColumnNumbers columns[] = {
        detail::ColumnNumbersOf<typename OfBodies::fields,
                                typename Pass::template reads_j<typename OfBodies::body>>::value...};
    around_.refresh_ghosts(all(), columns);
#ifdef SCREE_CHECK_LISTS
    around_.check_ghosts(all(), columns);
#endif
  }
  /// For lists of passes, where this system tracks_changes: begins (true) or ends (false) a time in which all changes
  /// of fields are announced by fields_changed(), so that only changed fields are copied to ghosts.
  void announces_changes(bool every) { around_.announces_changes(every); }
  /// Announces that fields of a body have changed, so that their ghosts are refreshed before they are read.
  template <BodyTag Body, class List>
  void fields_changed(List fields) {
    around_.columns_changed(number<Body>, column_numbers<fields_of<Body>>(fields));
  }
  /// How often neighbour lists were built.
  long neighbour_builds() const { return around_.neighbour_builds(); }
  /// The largest displacement of a particle between two builds of lists, without the last update, m; 0: lists are built
  /// at each update.
  double half_skin() const { return around_.half_skin(); }

  /// Adds particles of a body, with zeros in all fields, behind its others, where the case takes new ones; returns the
  /// number of the first. Call particles_changed() once their positions are set.
  template <BodyTag Body>
  int append(int particles) {
    return around_.append(all(), number<Body>, particles);
  }
  /// Keeps only these owned particles of a body, in this order. Call particles_changed() afterwards.
  template <BodyTag Body>
  void keep(Array<P, int const> const& numbers) {
    around_.keep(all(), number<Body>, numbers);
  }
  /// Builds all lists and ghosts for the new set of particles.
  void particles_changed() { around_.particles_changed(all()); }
  /// The numbers of particles that were added and removed in the whole case since the system was made.
  template <BodyTag Body>
  Turnover const& turnover() const {
    return around_.turnover(number<Body>);
  }
  /// The ghosts of the first body.
  Ghosts const& ghosts() const { return around_.ghosts(); }
  /// Begins with the particles that a solver is given. Throws std::invalid_argument if these are not all of the case.
  template <class Start>
  void begin(Start const& start) {
    around_.begin(start);
  }
  /// Brings particles of a share to where they belong.
  void settle_shares() { around_.settle_shares(all()); }
  /// visit(copies) for copies of those particles of a body that are elsewhere, within a distance (m) of the particles
  /// of all bodies here, and of periodic images if those are wanted. No call if all particles are here.
  template <BodyTag Body, class List, class Visit>
  void with_copies_near(double distance, bool images, List list, Visit const& visit) const {
    around_.with_copies_near(all(), number<Body>, distance, images, list, visit);
  }
  /// What is true of the whole case: WholeCase, or an Agreement of its ranks.
  auto const& whole_case() const { return around_.whole_case(); }
  /// A body of the whole case at a time (s).
  template <BodyTag Body>
  auto whole(double time = 0) const {
    return WholeBody(body<Body>(), whole_case(), time);
  }
  /// The number of particles of a body with its images, if its owned particles are at these positions.
  int extent_at(std::vector<Vec<P::dim, typename P::real>> const& positions) const {
    return around_.extent_at(space(), positions);
  }

  /// Begins a trial where that saves time, on a GPU. The watch checks rarely during a trial, so steps may turn out to
  /// have used lists that were no longer valid. Returns whether a trial has begun.
  bool begin_trial() {
    if constexpr (detail::has_trials<typename P::space>)
      return around_.begin_trial(all());
    else
      return false;
  }
  /// Whether steps are taken on trial.
  bool in_trial() const { return around_.in_trial(); }
  /// Whether steps must be repeated: after detail::ListsOutrun, or if this is true. Waits for all kernels of the
  /// system.
  bool trial_failed() { return around_.trial_failed(all()); }
  /// Throws detail::ListsOutrun if a trial failed.
  void stop_if_trial_failed() { around_.stop_if_trial_failed(all()); }
  /// Call this before others read or change the state.
  void end_trial() { around_.end_trial(); }
  /// Returns to the beginning of the trial. These lists allow no further trial.
  void undo_trial() { around_.undo_trial(all()); }
  /// How often steps on trial had to be repeated.
  long failed_trials() const { return around_.failed_trials(); }

  /// The state, in addition to the fields, that determines the order of neighbours; for snapshots.
  using Memory = typename Around::Memory;
  /// The state, in addition to the fields, that determines the order of neighbours.
  Memory memory() const { return around_.memory(all()); }
  /// Sets the system to the state of another one with the same fields and all particles of the case: pour(kept) sets
  /// the fields of the owned particles. `kept` has the numbers of those of each body that stay here; none: all do.
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
