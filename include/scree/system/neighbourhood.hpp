// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "any_pass.hpp"
#include "ghosts.hpp"
#include "searches.hpp"
#include "sort.hpp"
#include "trial.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// The numbers of particles added to a body and removed from it.
struct Turnover {
  long added = 0, removed = 0;  ///< numbers of particles since the start
  bool operator==(Turnover const&) const = default;
  /// Returns the number of particles at the start, given the number `present` now.
  long at_start(long present) const { return present - added + removed; }
};

namespace detail {

/// The neighbour lists and ghosts of the bodies of a system, which follow the positions of the particles. Bodies are
/// values, in the order of the system, so this class does not depend on their number and fields and is compiled once
/// for each basis.
template <class P, class Search, class Ghosts>
class Neighbourhood {
  static_assert(GhostProvider<Ghosts, P>, "`ghosts` of this formulation is no GhostProvider");

 public:
  using All = AllBodies<P>;
  using Read = AllBodiesRead<P>;
  using SearchesOf = Searches<P, Search>;
  using Provider = provider_in_case<P, Ghosts>;

  /// Takes the radius within which pairs are found (m), an array that tells which bodies are sorted, the number of
  /// bodies, and the settings of the ghosts. The array must outlive this object.
  [[gnu::cold]] Neighbourhood(double radius, bool const* sorted, std::size_t bodies,
                              typename Ghosts::Settings const& of_ghosts);
  [[gnu::cold]] Neighbourhood(Neighbourhood&&) noexcept;
  Neighbourhood& operator=(Neighbourhood&&) noexcept;
  [[gnu::cold]] ~Neighbourhood();

  /// Announces that positions have changed.
  void positions_changed();
  /// Brings ghosts up to date at the beginning of a step. Particles that have left a period are wrapped if lists are
  /// built.
  void begin_step(All bodies) {
    if (has_ghosts() && (stale_ || wrap_due_)) bring_up_to_date(bodies, true);
  }
  /// Begins a step: sorts bodies by cells and builds all lists.
  [[gnu::cold]] void begin_step_sorted(All bodies);

  /// Returns the neighbours of the particles of a body in the same body, for the present positions. Throws ListsOutrun
  /// if steps of a trial have used lists that were no longer valid.
  Search const& within(All bodies, std::size_t body);
  /// Returns the neighbours of the particles of the target body in the source body, for the present positions. Throws
  /// ListsOutrun if steps of a trial have used lists that were no longer valid.
  typename SearchesOf::OfOthers const& among(All bodies, std::size_t target, std::size_t source);
  /// Copies columns of the owned particles to their ghosts. `columns` is an array with an element for each body; the
  /// columns must include positions.
  void refresh_ghosts(All bodies, ColumnNumbers const* columns);
  /// Copies columns of the owned particles of one body to their ghosts.
  void refresh_ghosts(All bodies, std::size_t body, ColumnNumbers columns);
  /// Throws std::logic_error if the lists are not valid for the present positions. Intended for tests.
  [[gnu::cold]] void check_lists(Read bodies) const;
  /// Throws std::logic_error if values of ghosts in these columns differ from the values of their origins. Intended for
  /// tests.
  [[gnu::cold]] void check_ghosts(Read bodies, ColumnNumbers const* columns) const {
    for (std::size_t k = 0; k < bodies.size(); ++k) ghosts_[k].check_ghosts(bodies[k], columns[k]);
  }
  /// Runs passes in order and hands them the address of a system. Ghosts are refreshed before each pass that reads
  /// them.
  void run(All bodies, std::span<AnyPass const> passes, void* system);
  /// Returns the number of builds of the neighbour lists.
  long neighbour_builds() const { return searches_.builds(); }
  /// Returns the largest displacement of a particle between two builds of the lists, excluding the last update, m; 0 if
  /// lists are built at each update.
  double half_skin() const { return SearchesOf::margin(radius_) / 2; }

  /// Appends particles to a body, with zeros in all fields, where the case takes new particles, and returns the index
  /// of the first. Call particles_changed() once the positions of the new particles are set.
  [[gnu::cold]] int append(All bodies, std::size_t body, int number);
  /// Keeps only the owned particles of a body with these indices, in this order. Call particles_changed() afterwards.
  [[gnu::cold]] void keep(All bodies, std::size_t body, Array<P, int const> const& numbers);
  /// Builds all lists and ghosts for the new set of particles, after append() or keep().
  void particles_changed(All bodies) {
    settle(bodies);
    renew(bodies);
  }
  /// Returns the numbers of particles added and removed in the whole case since the system was made.
  Turnover const& turnover(std::size_t body) const { return turnover_[body]; }

  /// Returns the ghosts of the first body.
  Ghosts const& ghosts() const { return ghosts_[0]; }
  /// Begins with the particles that a solver is given. Throws std::invalid_argument if these are not all of the case.
  template <class Start>
  void begin(Start const& start) {
    Provider::begin(ghosts_, start);
  }
  /// Moves the particles of a share to where they belong.
  void settle_shares(All bodies) {
    if (ghosts_[0].has_share()) settle(bodies);
  }
  /// Calls visit(copies) with copies of the particles of a body that are elsewhere or, if `images` is true, are
  /// periodic images, and that lie within a distance (m) of the bounding box of the particles of all bodies here. Does
  /// not call it if all particles are here.
  template <class List, class Visit>
  void with_copies_near(Read bodies, std::size_t body, double distance, bool images, List list,
                        Visit const& visit) const {
    ghosts_[body].with_copies_near(bodies[body], bodies, distance, images, list, visit);
  }
  /// Returns the agreement on what is true of the whole case: a WholeCase, or a provider with its functions.
  auto const& whole_case() const { return ghosts_[0].whole_case(); }
  /// Returns the number of particles that a body would have, images included, if its owned particles were at these
  /// positions.
  [[gnu::cold]] int extent_at(typename P::space const& space,
                              std::vector<Vec<P::dim, typename P::real>> const& positions) const;

  /// Begins a trial if that saves time, and returns whether a trial has begun. During a trial, neighbour lists are
  /// checked rarely, so its steps may turn out to have used lists that were no longer valid.
  [[gnu::cold]] bool begin_trial(All bodies);
  /// Whether a trial is in progress.
  bool in_trial() const { return trial_.under_way; }
  /// Whether the steps of the trial must be repeated because they have used invalid lists, which ListsOutrun reports
  /// during a step. Waits for all kernels of the bodies.
  bool trial_failed(All bodies);
  /// Throws ListsOutrun if the trial has failed.
  void stop_if_trial_failed(All bodies) {
    if (trial_failed(bodies)) throw ListsOutrun();
  }
  /// Ends the trial and keeps its steps. Call this before other code reads or changes the state.
  void end_trial();
  /// Restores the state at the beginning of the trial. No further trial can begin until lists are built again.
  [[gnu::cold]] void undo_trial(All bodies);
  /// Returns the number of failed trials, whose steps were repeated.
  long failed_trials() const { return trial_.failures; }

  /// The state for snapshots that, in addition to the fields, determines the order of neighbours.
  struct Memory {
    /// Makes the state for a number of bodies.
    explicit Memory(std::size_t bodies) : searches(bodies), owned(bodies), turnover(bodies) {}
    typename SearchesOf::Memory searches;
    std::vector<int> owned;  ///< number of owned particles of each body
    std::vector<Turnover> turnover;
    bool stale = true, wrap_due = false;
    int unsettled = 0;
  };
  /// Returns the state that, in addition to the fields, determines the order of neighbours.
  [[gnu::cold]] Memory memory(Read bodies) const;
  /// The indices of the particles of each body that stay here; none: all do.
  using Kept = std::optional<std::vector<std::vector<int>>>;
  /// Restores everything except the fields from the state of another system with the same fields and all particles of
  /// the case. Returns the particles that stay here. Set their fields, and then call end_restore().
  [[gnu::cold]] Kept begin_restore(All bodies, Memory& memory);
  /// Completes a restart that begin_restore() has begun, with the same memory.
  [[gnu::cold]] void end_restore(Memory const& memory);

 private:
  /// A scope in which passes announce the columns that they change, so only these columns are copied to ghosts.
  struct Announced {
    explicit Announced(std::vector<Provider>& of_bodies) : ghosts(of_bodies) { switch_to(true); }
    Announced(Announced const&) = delete;
    ~Announced() { switch_to(false); }
    void switch_to(bool all) const {
      for (Provider& each : ghosts) each.announces_changes(all);
    }
    /// Announces the changed columns of each body.
    void changed(ColumnNumbers const* columns) const {
      for (Provider& each : ghosts) each.columns_changed(*columns++);
    }
    std::vector<Provider>& ghosts;
  };
  void require_no_trial() const {
    if (trial_.under_way) throw std::logic_error("scree: particles can be added and removed between steps only");
  }
  bool has_ghosts() const { return ghosts_[0].any(); }
  Provider ghosts_of(typename Ghosts::Settings const& settings) const {
    // Two particles together may move by the margin, and each may be outside a period by the margin.
    return {settings, radius_, 2 * SearchesOf::margin(radius_)};
  }
  static std::vector<Places<P>> now(Read bodies);
  void bring_up_to_date(All bodies, bool between_steps);
  [[gnu::cold]] void settle(All bodies);
  /// Whether the lists are valid for the present positions, after a change of these. Throws ListsOutrun if steps on
  /// trial have used lists that were no longer valid.
  bool lists_serve(Read bodies);
  [[gnu::cold]] void renew(All bodies);
  void join_frames() {
    searches_.join_frames([&](auto& frames) { whole_case().join(frames); });
  }
  void guard_positions(All bodies);
  /// Creates ghosts for the positions from which the lists were built. These are the positions of owned particles in
  /// `lists`, to which the positions of the ghosts are added.
  template <class Lists>
  [[gnu::cold]] Kept restore_ghosts(All bodies, Lists& lists);

  double radius_;
  std::vector<Provider> ghosts_;
  SearchesOf searches_;
  std::vector<Turnover> turnover_;
  bool const* sorted_;
  bool stale_ = true;  // positions changed since the last update of the searches
  bool wrap_due_ = false;
  int unsettled_ = 0;  // builds since particles were last moved to where they belong
  bool shown_ = true;  // other code may have changed positions without the guards
  Trial<P, decltype(std::declval<SearchesOf&>().watch())> trial_;
};

template <class P, class Search, class Ghosts>
Neighbourhood<P, Search, Ghosts>::Neighbourhood(double radius, bool const* sorted, std::size_t bodies,
                                                typename Ghosts::Settings const& of_ghosts)
    : radius_(radius), searches_(radius, bodies), turnover_(bodies), sorted_(sorted) {
  ghosts_.reserve(bodies);
  for (std::size_t k = 0; k < bodies; ++k) ghosts_.push_back(ghosts_of(of_ghosts));
}

template <class P, class Search, class Ghosts>
Neighbourhood<P, Search, Ghosts>::Neighbourhood(Neighbourhood&&) noexcept = default;
template <class P, class Search, class Ghosts>
Neighbourhood<P, Search, Ghosts>& Neighbourhood<P, Search, Ghosts>::operator=(Neighbourhood&&) noexcept = default;
template <class P, class Search, class Ghosts>
Neighbourhood<P, Search, Ghosts>::~Neighbourhood() = default;

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::positions_changed() {
  stale_ = true;
  for (Provider& each : ghosts_) each.positions_changed();
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::begin_step_sorted(All bodies) {
  stop_if_trial_failed(bodies);
  settle(bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (sorted_[k]) sort_along_cells(bodies[k], radius_);
  renew(bodies);
}

template <class P, class Search, class Ghosts>
Search const& Neighbourhood<P, Search, Ghosts>::within(All bodies, std::size_t body) {
  bring_up_to_date(bodies, false);
  return searches_.within(body, now(bodies));
}

template <class P, class Search, class Ghosts>
auto Neighbourhood<P, Search, Ghosts>::among(All bodies, std::size_t target, std::size_t source) ->
    typename SearchesOf::OfOthers const& {
  bring_up_to_date(bodies, false);
  return searches_.among(target, source, now(bodies));
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::check_lists(Read bodies) const {
  if (!trial_.under_way && searches_.outdated(now(bodies)))
    throw std::logic_error("scree: neighbour lists are used beyond their skin");
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::refresh_ghosts(All bodies, ColumnNumbers const* columns) {
  bring_up_to_date(bodies, false);
  Provider::refresh_all(ghosts_, bodies, columns);
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::refresh_ghosts(All bodies, std::size_t body, ColumnNumbers columns) {
  bring_up_to_date(bodies, false);
  ghosts_[body].refresh(bodies[body], columns);
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::run(All bodies, std::span<AnyPass const> passes, void* system) {
  // While a list of passes runs, all changes of fields are announced, so that only changed fields are copied to ghosts.
  Announced const announced(ghosts_);
  for (AnyPass const& pass : passes) {
    if (!pass.active) continue;
    ProfilingRegion const region(pass.label);
    if (pass.changes == nullptr) announced.switch_to(false);
    if (pass.reads_of_ghosts != nullptr) refresh_ghosts(bodies, pass.reads_of_ghosts);
    pass.loops(pass.pass, system);
    if (pass.moves) positions_changed();
    if (pass.changes == nullptr)
      announced.switch_to(true);
    else
      announced.changed(pass.changes);
  }
}

template <class P, class Search, class Ghosts>
int Neighbourhood<P, Search, Ghosts>::append(All bodies, std::size_t body, int number) {
  require_no_trial();
  int const first = bodies[body].append(whole_case().takes_new() ? number : 0);
  turnover_[body].added += number;
  return first;
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::keep(All bodies, std::size_t body, Array<P, int const> const& numbers) {
  require_no_trial();
  turnover_[body].removed += whole_case().sum(bodies[body].size() - numbers.size());
  bodies[body].reorder(numbers);
}

template <class P, class Search, class Ghosts>
int Neighbourhood<P, Search, Ghosts>::extent_at(typename P::space const& space,
                                                std::vector<Vec<P::dim, typename P::real>> const& positions) const {
  Particles<P, Fields<Position>> body(space, static_cast<int>(positions.size()));
  body.from_host(fields::position, positions);
  ghosts_of(ghosts_[0].settings()).images().create(body);
  return body.extent();
}

template <class P, class Search, class Ghosts>
bool Neighbourhood<P, Search, Ghosts>::begin_trial(All bodies) {
  if (trial_.under_way || shown_) {
    // A trial ends when lists are built, so lists are built here rather than within the step.
    begin_step(bodies);
    bring_up_to_date(bodies, false);
    shown_ = false;
  }
  int here = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) here += bodies[k].size();
  if (!searches_.watch().may_look_rarely() || whole_case().anywhere(here > decltype(trial_)::most)) return false;
  trial_.begin(bodies, searches_.watch());
  trial_.stale = stale_, trial_.wrap_due = wrap_due_;
  return true;
}

template <class P, class Search, class Ghosts>
bool Neighbourhood<P, Search, Ghosts>::trial_failed(All bodies) {
  if (!trial_.under_way) return false;
  bodies[0].space().fence("scree::trial");
  return whole_case().anywhere(searches_.watch().outrun());
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::end_trial() {
  if (trial_.under_way) searches_.watch().look_always();
  trial_.under_way = false;
  shown_ = true;
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::undo_trial(All bodies) {
  trial_.undo(bodies, searches_.watch());
  positions_changed();  // ghosts are refreshed again
  stale_ = trial_.stale, wrap_due_ = trial_.wrap_due;
  guard_positions(bodies);
}

template <class P, class Search, class Ghosts>
auto Neighbourhood<P, Search, Ghosts>::memory(Read bodies) const -> Memory {
  Memory memory(bodies.size());
  memory.searches = searches_.memory();
  memory.turnover = turnover_;
  memory.stale = stale_, memory.wrap_due = wrap_due_, memory.unsettled = unsettled_;
  for (std::size_t k = 0; k < bodies.size(); ++k) memory.owned[k] = bodies[k].size();
  return memory;
}

template <class P, class Search, class Ghosts>
auto Neighbourhood<P, Search, Ghosts>::begin_restore(All bodies, Memory& memory) -> Kept {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (bodies[k].size() != memory.owned[k]) bodies[k].resize(memory.owned[k]);
  turnover_ = memory.turnover;
  Kept kept;
  Provider::begin_again(ghosts_);
  if constexpr (ListsWithSkin<Search, P>)
    if (memory.searches.builds > 0) kept = restore_ghosts(bodies, memory.searches);
  searches_.restore(bodies[0].space(), memory.searches);
  join_frames();
  return kept;
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::end_restore(Memory const& memory) {
  positions_changed();
  stale_ = memory.stale;
  wrap_due_ = memory.wrap_due;
  unsettled_ = memory.unsettled;
  end_trial();
}

template <class P, class Search, class Ghosts>
std::vector<Places<P>> Neighbourhood<P, Search, Ghosts>::now(Read bodies) {
  std::vector<Places<P>> places;
  places.reserve(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) places.push_back({bodies[k][fields::position], bodies[k].size()});
  return places;
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::bring_up_to_date(All bodies, bool between_steps) {
  bool const must = between_steps && wrap_due_;
  if (!must && !stale_) return;
  if (!must && lists_serve(bodies)) {
    stale_ = false;
    return guard_positions(bodies);
  }
  // Integrators use earlier positions within a step, so particles must not jump to another place.
  wrap_due_ = ghosts_[0].must_settle(unsettled_);
  if (between_steps) settle(bodies);
  renew(bodies);
}

template <class P, class Search, class Ghosts>
bool Neighbourhood<P, Search, Ghosts>::lists_serve(Read bodies) {
  auto&& watch = searches_.watch();
  double crossed = watch.crossed(now(bodies));
  if (watch.looks_now()) {
    crossed = whole_case().largest(crossed);
    if (trial_.under_way && whole_case().anywhere(watch.outrun())) throw ListsOutrun();
  }
  return watch.serves(crossed);
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::settle(All bodies) {
  Provider::before_settle(ghosts_, bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) ghosts_[k].settle(bodies[k]);
  wrap_due_ = false;
  unsettled_ = 0;
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::renew(All bodies) {
  stop_if_trial_failed(bodies);
  Provider::before_create(ghosts_, bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) ghosts_[k].create(bodies[k]);
  searches_.renew(now(bodies));
  join_frames();
  stale_ = trial_.under_way = false;
  guard_positions(bodies);
}

template <class P, class Search, class Ghosts>
void Neighbourhood<P, Search, Ghosts>::guard_positions(All bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k].guard_positions(searches_.watch().guard(k));
}

template <class P, class Search, class Ghosts>
template <class Lists>
auto Neighbourhood<P, Search, Ghosts>::restore_ghosts(All bodies, Lists& lists) -> Kept {
  using namespace fields;
  if (!has_ghosts()) return std::nullopt;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    lists.kept[k].resize(std::size_t(bodies[k].size()));
    bodies[k].columns().from_host(bodies[k].number_of(position), lists.kept[k].data());
  }
  Kept kept = Provider::scatter(ghosts_, bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    lists.owned[k] = bodies[k].size();
    lists.kept[k] = values_of(bodies[k][position]);
  }
  return kept;
}

}  // namespace detail
}  // namespace scree
