// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "../kernels/kernel.hpp"
#include "instances.hpp"
#include "periodic.hpp"
#include "searches.hpp"
#include "sort.hpp"
#include "trial.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// The numbers of particles that were added to a body and removed from it.
struct Turnover {
  long added = 0, removed = 0;  ///< their numbers since the start
  bool operator==(Turnover const&) const = default;
  /// The number of particles at the start, which follows from the number `present` now.
  long at_start(long present) const { return present - added + removed; }
};

/// A body of a system with the fields that it carries.
template <BodyTag Body, class List>
struct BodyWith {
  using body = Body;
  using fields = List;
};

/// The data that passes work on: particles of all bodies with their kernel, with neighbours and ghosts that follow the
/// positions. Its state can be saved and restored.
template <class P, class Search, class Ghosts, class... OfBodies>
class System {
  static_assert(GhostProvider<Ghosts, P>, "`ghosts` of this formulation is no GhostProvider");

 public:
  using policy = P;
  using bodies = Bodies<typename OfBodies::body...>;
  static constexpr std::size_t count = sizeof...(OfBodies);  ///< the number of bodies
  static constexpr bool has_ranks = detail::on_ranks<Ghosts>;

  /// Bodies without particles on an instance of the execution space, with the smoothing length (m) of their kernel.
  System(typename P::space const& space, double smoothing_length, typename Ghosts::Settings const& of_ghosts)
      : kernel_(smoothing_length),
        bodies_{Particles<P, typename OfBodies::fields>(space)...},
        ghosts_{((void)sizeof(OfBodies), ghosts_of(of_ghosts))...},
        searches_(kernel_.radius()) {}
  /// On the default instance.
  System(double smoothing_length, typename Ghosts::Settings const& of_ghosts)
      : System(typename P::space(), smoothing_length, of_ghosts) {}
  /// The instance of the execution space in which all loops run.
  typename P::space const& space() const { return std::get<0>(bodies_).space(); }
  /// The kernel with its smoothing length.
  kernel_of<P> const& kernel() const { return kernel_; }

  /// The particles of a body.
  template <BodyTag Body>
  auto& body() {
    return std::get<body_index<Body, bodies>()>(bodies_);
  }
  /// The particles of a body.
  template <BodyTag Body>
  auto const& body() const {
    return std::get<body_index<Body, bodies>()>(bodies_);
  }

  /// Announces that positions have changed.
  void positions_changed() {
    stale_ = true;
    if constexpr (detail::on_ranks<Ghosts>)
      for (Ghosts& each : ghosts_) each.positions_changed();
  }
  /// Brings ghosts up to date at the beginning of a step. Particles that left a period return here, when lists are
  /// built anyway.
  void begin_step() {
    if (has_ghosts() && (stale_ || wrap_due_)) bring_up_to_date(true);
  }
  /// Begins a step by sorting the bodies that evolve by cells and building all lists.
  void begin_step_sorted() {
    stop_if_trial_failed();
    settle();
    for_each([&]<std::size_t K>(auto& body) {
      if constexpr (EvolvingBody<Tag<K>>) sort_along_cells(body, kernel_.radius());
    });
    renew();
  }

  /// Neighbours of the target body's particles among the source body's, for the present positions. Throws
  /// detail::ListsOutrun if steps on trial have used lists that were no longer valid; where SCREE_CHECK_LISTS is
  /// defined, std::logic_error if other steps have.
  template <BodyTag Target, BodyTag Source>
  auto const& neighbours() {
    bring_up_to_date(false);
#ifdef SCREE_CHECK_LISTS
    if (!trial_.under_way && searches_.outdated(now()))
      throw std::logic_error("scree: neighbour lists are used beyond their skin");
#endif
    return searches_.template neighbours<body_index<Target, bodies>(), body_index<Source, bodies>()>(now());
  }
  /// Copies fields of the owned particles to their images; positions must be among them.
  template <BodyTag Body, class List>
  void refresh_ghosts(List fields) {
    bring_up_to_date(false);
    ghosts_[body_index<Body, bodies>()].refresh(body<Body>(), fields);
  }
  /// refresh_ghosts() of all bodies for the fields that a pass reads of neighbours: `reads_j<Body>` of each body.
  template <class Pass>
  void refresh_ghosts_for(Pass const&) {
    bring_up_to_date(false);
    using Lists = std::tuple<typename Pass::template reads_j<typename OfBodies::body>...>;
    if constexpr (detail::on_ranks<Ghosts>)
      Ghosts::refresh_all(ghosts_, bodies_, Lists());
    else
      for_each([&]<std::size_t K>(auto& body) {
        using List = std::tuple_element_t<K, Lists>;
        if constexpr (!std::is_same_v<List, Fields<>>) ghosts_[K].refresh(body, List{});
      });
  }
  /// For lists of passes on ranks: begins (true) or ends (false) a time in which all changes of fields are announced by
  /// fields_changed(), so that only changed fields are copied to ghosts.
  void announces_changes(bool all) {
    for (Ghosts& each : ghosts_) each.announces_changes(all);
  }
  /// Announces that fields of a body have changed, so that their ghosts are refreshed before they are read.
  template <BodyTag Body, class List>
  void fields_changed(List fields) {
    ghosts_[body_index<Body, bodies>()].fields_changed(body<Body>(), fields);
  }
  /// How often neighbour lists were built.
  long neighbour_builds() const { return searches_.builds(); }
  /// The largest displacement of a particle between two builds of lists, without the last update, m; 0: lists are built
  /// at each update.
  double half_skin() const { return Searches<P, Search, count>::margin(kernel_.radius()) / 2; }

  /// Adds particles of a body, with zeros in all fields, behind its others, on the rank that takes new ones; returns
  /// the number of the first. Call particles_changed() once their positions are set.
  template <BodyTag Body>
  int append(int number) {
    require_no_trial();
    int const first = body<Body>().append(ranks().takes_new() ? number : 0);
    turnover_[body_index<Body, bodies>()].added += number;
    return first;
  }
  /// Keeps only these owned particles of a body, in this order. Call particles_changed() afterwards.
  template <BodyTag Body>
  void keep(Array<P, int const> const& numbers) {
    require_no_trial();
    auto& all = body<Body>();
    turnover_[body_index<Body, bodies>()].removed += ranks().sum(all.size() - numbers.size());
    all.reorder(numbers);
  }
  /// Builds all lists and ghosts for the new set of particles.
  void particles_changed() {
    settle();
    renew();
  }
  /// The numbers of particles that were added and removed since the system was made, on all ranks.
  template <BodyTag Body>
  Turnover const& turnover() const {
    return turnover_[body_index<Body, bodies>()];
  }
  /// The ghosts of the first body, which know the ranks of the case.
  Ghosts const& ghosts() const { return ghosts_[0]; }
  /// Declares that each rank of the case begins with a share of the particles.
  void begin_with_shares() {
    if constexpr (has_ranks) Ghosts::begin_with_shares(ghosts_);
  }
  /// Sends shares to the ranks that they belong to.
  void settle_shares() {
    if constexpr (has_ranks)
      if (ranks().scattered() && !ranks().settled()) settle();
  }
  /// Copies of the particles of a body on other ranks that are within a distance (m) of those of all bodies here, and
  /// of periodic images if those are wanted. All ranks call it together.
  template <BodyTag Body, class List>
  auto copies_near(double distance, bool images, List list) const {
    constexpr auto k = body_index<Body, bodies>();
    return ghosts_[k].copies_near(std::get<k>(bodies_), bodies_, distance, images, list);
  }
  /// Agreement of all ranks of the case.
  decltype(auto) ranks() const {
    if constexpr (detail::on_ranks<Ghosts>)
      return static_cast<Ghosts const&>(ghosts_[0]);
    else
      return OneRank();
  }
  /// The number of particles of a body with its images, if its owned particles are at these positions.
  int extent_at(std::vector<Vec<P::dim, typename P::real>> const& positions) const {
    Particles<P, Fields<Position>> body(space(), static_cast<int>(positions.size()));
    body.from_host(fields::position, positions);
    if constexpr (detail::on_ranks<Ghosts>)
      ghosts_[0].images().create(body);
    else
      ghosts_of(ghosts_[0].settings()).create(body);
    return body.extent();
  }

  /// Begins a trial where that saves time, on a GPU. The watch checks rarely during a trial, so steps may turn out to
  /// have used lists that were no longer valid. Returns whether a trial has begun. All ranks of a case call this and
  /// the next three together.
  bool begin_trial() {
    if constexpr (!detail::has_trials<typename P::space>) return false;
    if (trial_.under_way || shown_) {
      // A trial does not outlive lists: they are built here rather than within the step.
      begin_step();
      bring_up_to_date(false);
      shown_ = false;
    }
    if (!searches_.watch().may_look_rarely() || ranks().on_any(here() > decltype(trial_)::most)) return false;
    trial_.begin(bodies_, searches_.watch());
    trial_.stale = stale_, trial_.wrap_due = wrap_due_;
    return true;
  }
  /// Whether steps are taken on trial.
  bool in_trial() const { return trial_.under_way; }
  /// Whether steps must be repeated: after detail::ListsOutrun, or if this is true. Waits for all kernels of the
  /// system.
  bool trial_failed() {
    if (!trial_.under_way) return false;
    space().fence("scree::trial");
    return ranks().on_any(searches_.watch().outrun());
  }
  /// Throws detail::ListsOutrun if a trial failed.
  void stop_if_trial_failed() {
    if (trial_failed()) throw detail::ListsOutrun();
  }
  /// Call this before others read or change the state.
  void end_trial() {
    if (trial_.under_way) searches_.watch().look_always();
    trial_.under_way = false;
    shown_ = true;
  }
  /// Returns to the beginning of the trial. These lists allow no further trial.
  void undo_trial() {
    trial_.undo(bodies_, searches_.watch());
    positions_changed();  // ghosts are refreshed again
    stale_ = trial_.stale, wrap_due_ = trial_.wrap_due;
    guard_positions();
  }
  /// How often steps on trial had to be repeated.
  long failed_trials() const { return trial_.failures; }

  /// The state, in addition to the fields, that determines the order of neighbours; for snapshots.
  struct Memory {
    typename Searches<P, Search, count>::Memory searches;
    std::array<int, count> owned = {};  ///< particles of each body
    std::array<Turnover, count> turnover = {};
    bool stale = true, wrap_due = false;
    int unsettled = 0;
  };
  /// The state, in addition to the fields, that determines the order of neighbours.
  Memory memory() const {
    Memory memory{searches_.memory(), {}, turnover_, stale_, wrap_due_, unsettled_};
    auto const places = now();
    for (std::size_t k = 0; k < count; ++k) memory.owned[k] = places[k].owned;
    return memory;
  }
  /// The numbers of the particles of each body that belong to this rank; empty: all.
  using Kept = std::array<std::vector<int>, count>;
  /// Sets the system to the state of another one with the same fields and all particles of the case: pour(kept) sets
  /// the fields of the owned particles.
  template <class Pour>
  void restore(Memory memory, Pour const& pour) {
    for_each([&]<std::size_t K>(auto& body) {
      if (body.size() != memory.owned[K]) body.resize(memory.owned[K]);
    });
    turnover_ = memory.turnover;
    Kept kept;
    if constexpr (detail::on_ranks<Ghosts>) Ghosts::begin_again(ghosts_);
    if constexpr (requires { memory.searches.kept; })
      if (memory.searches.builds > 0) kept = restore_ghosts(memory.searches);
    searches_.restore(space(), memory.searches, ranks());
    pour(kept);
    positions_changed();
    stale_ = memory.stale;
    wrap_due_ = memory.wrap_due;
    unsettled_ = memory.unsettled;
    end_trial();
  }

 private:
  void require_no_trial() const {
    if (trial_.under_way) throw std::logic_error("scree: particles can be added and removed between steps only");
  }
  template <std::size_t K>
  using Tag = typename std::tuple_element_t<K, std::tuple<OfBodies...>>::body;
  /// Calls visit.template operator()<K>(body) for each body.
  template <class Visit>
  void for_each(Visit const& visit) {
    [&]<std::size_t... K>(std::index_sequence<K...>) { (visit.template operator()<K>(std::get<K>(bodies_)), ...); }
    (std::make_index_sequence<count>());
  }
  /// The number of owned particles of all bodies.
  int here() const {
    return std::apply([](auto const&... body) { return (body.size() + ...); }, bodies_);
  }
  bool has_ghosts() const { return ghosts_[0].any(); }
  Ghosts ghosts_of(typename Ghosts::Settings const& settings) const {
    // Together two particles may cross the margin, and may be outside of a period by it.
    return {settings, kernel_.radius(), 2 * Searches<P, Search, count>::margin(kernel_.radius())};
  }
  std::array<Places<P>, count> now() const {
    return std::apply(
        [](auto const&... body) {
          return std::array<Places<P>, count>{{{body[fields::position], body.size()}...}};
        },
        bodies_);
  }
  void bring_up_to_date(bool between_steps) {
    bool const must = between_steps && wrap_due_;
    if (!must && !stale_) return;
    if (!must && searches_.serve(now(), ranks())) {
      stale_ = false;
      return guard_positions();
    }
    // Within a step integrators rely on earlier positions, so particles must not jump.
    wrap_due_ = must_settle();
    if (between_steps) settle();
    renew();
  }
  void settle() {
    if constexpr (detail::on_ranks<Ghosts>) Ghosts::before_settle(ghosts_, bodies_);
    for_each([&]<std::size_t K>(auto& body) { ghosts_[K].settle(body); });
    wrap_due_ = false;
    unsettled_ = 0;
  }
  /// Whether particles must go where they belong before the next step, even if the lists are valid for it.
  bool must_settle() {
    if constexpr (detail::on_ranks<Ghosts>)
      return ghosts_[0].must_settle(++unsettled_);
    else
      return has_ghosts();
  }
  void renew() {
    stop_if_trial_failed();
    if constexpr (detail::on_ranks<Ghosts>) Ghosts::before_create(ghosts_, bodies_);
    for_each([&]<std::size_t K>(auto& body) { ghosts_[K].create(body); });
    searches_.renew(now(), ranks());
    stale_ = trial_.under_way = false;
    guard_positions();
  }
  void guard_positions() {
    for_each([&]<std::size_t K>(auto& body) { body.guard_positions(searches_.watch().guard(K)); });
  }

  /// Ghosts belong to the positions that the lists were built from, those of the owned particles in `lists`. Adds their
  /// positions to these.
  template <class Lists>
  Kept restore_ghosts(Lists& lists) {
    using namespace fields;
    Kept kept;
    if (!has_ghosts()) return kept;
    for_each([&]<std::size_t K>(auto& body) {
      lists.kept[K].resize(std::size_t(body.size()));
      body.from_host(position, lists.kept[K]);
    });
    if constexpr (detail::on_ranks<Ghosts>)
      kept = Ghosts::scatter(ghosts_, bodies_);
    else
      for_each([&]<std::size_t K>(auto& body) { ghosts_[K].create(body); });
    for_each([&]<std::size_t K>(auto& body) {
      lists.owned[K] = body.size();
      lists.kept[K] = values_of(body[position]);
    });
    return kept;
  }

  kernel_of<P> kernel_;
  std::tuple<Particles<P, typename OfBodies::fields>...> bodies_;
  std::array<Ghosts, count> ghosts_;
  Searches<P, Search, count> searches_;
  std::array<Turnover, count> turnover_;
  bool stale_ = true;  // positions changed since the last update of the searches
  bool wrap_due_ = false;
  int unsettled_ = 0;  // builds since particles last went where they belong, on ranks
  bool shown_ = true;  // others may have changed positions without the guards
  detail::Trial<typename P::space, decltype(std::declval<Searches<P, Search, count>&>().watch()), count> trial_;
};

}  // namespace scree
