// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../neighbours/verlet_list.hpp"
#include "../system/periodic.hpp"
#include "agreement.hpp"
#include "current_columns.hpp"
#include "divide.hpp"
#include "exchange.hpp"
#include "find.hpp"
#include "migration.hpp"
#include "shares_at_start.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// A GhostProvider for cases on several ranks. The ghosts of a body are copies of particles on other ranks, and
/// periodic images of these copies and of the rank's own particles. Each rank has its own solver, made from the
/// particles of the whole case or from a share of them, and keeps the particles that belong to the rank. Particles
/// migrate to the rank that owns their position whenever neighbour lists are built between steps. All ranks do the same
/// steps, and call every function that reads neighbours together.
template <class P>
class OtherRanks : public Agreement<P> {
  using Shared = detail::SharedByBodies<P>;
  using typename Agreement<P>::Held;
  using Agreement<P>::held_;
  using Shipments = typename Exchange<P>::Shipments;

 public:
  using Agreement<P>::team;
  /// The type of the member `ranks` of SolverSettings.
  using Ranks = DividedCase<typename P::space>;
  struct Settings {
    /// Takes the settings of a divided case and the directions in which its domain is periodic.
    Settings(Ranks const& ranks, std::vector<Period> periods_)
        : shared(std::make_shared<Shared>(ranks)), periods(std::move(periods_)) {}
    std::shared_ptr<Shared> shared;  ///< common to all bodies on a rank
    std::vector<Period> periods;     ///< directions in which the domain is periodic
  };

  /// Provides ghosts for sums within `support` (m), which suffice until particles have moved by the margin (m).
  OtherRanks(Settings const& settings, double support, double margin)
      : Agreement<P>(settings.shared->team),
        settings_(settings),
        images_(settings.periods, support, margin),
        // Neighbour lists contain pairs within the support plus half the margin.
        needed_(settings.periods, (support + margin / 2) * (1 + 1e-5)) {}

  /// Returns the agreement of all ranks.
  OtherRanks const& whole_case() const { return *this; }
  bool any() const { return true; }
  /// Returns the periodic images of this rank's own particles only.
  PeriodicImages<P> images() const { return images_; }
  /// Returns the periodic images within a radius (m) of this rank's own particles only.
  PeriodicImages<P> images_within(double radius) const { return PeriodicImages<P>(settings_.periods, radius); }
  Settings const& settings() const { return settings_; }
  std::string signature() const { return images_.signature(); }

  /// Whether particles must settle before the next step after lists were built within a step. Ghosts surround the
  /// particles of a rank even outside its region, so migration may wait for 64 such builds; in a periodic domain it may
  /// not wait.
  bool must_settle(int& unsettled) const { return ++unsettled > 64 || !settings_.periods.empty(); }
  /// Divides the case if a division is due. The function is called before settle() of the bodies.
  static void before_settle(std::vector<OtherRanks>& all, detail::AllBodiesRead<P> bodies) {
    all[0].shared().divide_if_due(all[0].needed_.reach(), !all[0].all_here(), bodies);
  }
  /// Wraps particles that left a period, and sends particles that left this rank to the ranks that they belong to.
  void settle(AnyParticles<P>& body);
  /// Tells all ranks where the particles of each rank are. The function is called before create() of the bodies.
  static void before_create(std::vector<OtherRanks>& all, detail::AllBodies<P> bodies);
  /// Replaces all ghosts according to the positions of the owned particles of all ranks.
  void create(AnyParticles<P>& body);
  /// Calls visit(copies) unless this rank has all particles. `copies` has the particles of `body` on other ranks, and
  /// periodic images if `images` is true, that lie within a distance (m) of the bounding box of this rank's particles
  /// of `bodies`. All ranks call this function together.
  template <class... Fs, class Visit>
  void with_copies_near(AnyParticles<P> const& body, detail::AllBodiesRead<P> bodies, double distance, bool images,
                        Fields<Fs...> list, Visit const& visit) const {
    if (this->all_here()) return;
    Particles<P, Fields<Fs...>> copies(body.space());
    copy_near(body, body.numbers_of(list), bodies, distance, images, copies, copies.numbers_of(list));
    visit(copies);
  }
  /// Copies the outdated ones of some columns to the ghosts from the particles that they copy.
  void refresh(AnyParticles<P>& body, ColumnNumbers columns);
  /// Copies the outdated ones of some columns of each body to the ghosts, with one message to each rank for up to six
  /// bodies.
  static void refresh_all(std::vector<OtherRanks>& all, detail::AllBodies<P> bodies, ColumnNumbers const* columns);
  /// Throws std::logic_error if the ghosts differ in these columns from the particles that they copy, because a change
  /// was not announced. Used in tests.
  void check_ghosts(AnyParticles<P> const& body, ColumnNumbers columns) const;
  /// Marks the positions of the ghosts as outdated. Call this function after positions of the body have changed.
  void positions_changed() { current_.positions_changed(); }
  /// Marks columns of the ghosts as outdated. Call this function after each change of fields of the body while all
  /// changes are announced.
  void columns_changed(ColumnNumbers columns) {
    for (std::size_t const column : columns) current_.changed(column);
  }
  /// Begins (true) or ends (false) a period during which all changes of fields are announced.
  void announces_changes(bool all) { current_.forget(all); }

  /// Declares that all ranks have the particles of the whole case again, as at the start.
  static void begin_again(std::vector<OtherRanks>& all) {
    for (auto& each : all) each.held_ = Held::whole;
  }
  /// Notes whether the ranks begin with the particles of the whole case or with shares of them, whose particles migrate
  /// to their ranks when neighbour lists are first built. Throws std::invalid_argument if the shares do not form one
  /// case.
  template <class Start>
  static void begin(std::vector<OtherRanks>& all, Start const& start) {
    if (!all[0].anywhere(detail::begins_from_shares(start))) return;
    for (auto& each : all) each.held_ = Held::share;
    detail::check_shares(start, all[0]);
  }
  /// Whether this rank has a share whose particles may belong to other ranks.
  bool has_share() const { return held_ == Held::share; }
  /// Divides a case while every rank has all particles, and creates the ghosts. Positions do not change, not even
  /// outside a period. Returns, for each body, the numbers of the particles that this rank keeps.
  static std::optional<std::vector<std::vector<int>>> scatter(std::vector<OtherRanks>& all,
                                                              detail::AllBodies<P> bodies);

  /// Returns how often the case was divided, and how many particles and ghosts this rank received.
  RankCounts const& counts() const { return settings_.shared->counts; }
  /// Returns the division of space among the ranks.
  Partition<P::dim> const& partition() const { return settings_.shared->partition(); }

 private:
  Shared& shared() const { return *settings_.shared; }
  /// Lists in `plan` the particles of this rank that each rank needs.
  void plan_for(Plan<P>& plan, detail::Needed<P> const& needed, AnyParticles<P> const& body) const;
  void copy_near(AnyParticles<P> const& body, ColumnNumbers columns, detail::AllBodiesRead<P> bodies, double distance,
                 bool images, AnyParticles<P>& copies, ColumnNumbers columns_of_copies) const;
  std::vector<int> keep_own(AnyParticles<P>& body);
  /// Adds a shipment of those columns that are outdated in the ghosts of a body.
  void add_due(Shipments& due, AnyParticles<P> const& body, ColumnNumbers columns);
  void deliver(Shipments const& all) const;

  Settings settings_;
  PeriodicImages<P> images_;
  detail::Needed<P> needed_;
  detail::Migration<P> migration_;
  Plan<P> ghosts_;
  detail::CurrentColumns current_;
};

template <class P>
void OtherRanks<P>::settle(AnyParticles<P>& body) {
  ProfilingRegion const region("scree::migrate");
  body.resize(body.size());
  images_.settle(body);
  if (!detail::on_all_ranks(body)) {
    if (held_ == Held::own)
      migration_.run(shared(), body);
    else if (held_ == Held::share)
      migration_.run_for_share(shared(), body);
    else
      migration_.keep_own(shared(), body);
  }
  held_ = Held::own;
}

template <class P>
void OtherRanks<P>::before_create(std::vector<OtherRanks>& all, detail::AllBodies<P> bodies) {
  auto& first = all[0];
  if (first.held_ != Held::own) {
    before_settle(all, bodies);
    for (std::size_t k = 0; k < bodies.size(); ++k) all[k].settle(bodies[k]);
  }
  first.shared().find_boxes(bodies);
  std::vector<std::int64_t> here;
  for (std::size_t k = 0; k < bodies.size(); ++k) here.push_back(detail::counted_on(first.team().rank(), bodies[k]));
  auto const counts = first.team().sum(here);
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k].set_everywhere(long(counts[k]));
}

template <class P>
void OtherRanks<P>::create(AnyParticles<P>& body) {
  ProfilingRegion const region("scree::ghosts_of_ranks");
  body.resize(body.size());
  if (detail::on_all_ranks(body)) return;
  plan_for(ghosts_, needed_, body);
  check_number(double(body.size()) + double(ghosts_.receiving()));
  body.resize(body.size(), ghosts_.receiving());
  shared().counts.ghosts += ghosts_.receiving();
  std::array const positions{body.number_of(fields::position)};
  current_.renew(positions[0]);
  refresh(body, positions);
}

template <class P>
void OtherRanks<P>::plan_for(Plan<P>& plan, detail::Needed<P> const& needed, AnyParticles<P> const& body) const {
  plan.make(body.space(), team(), body.size(),
            [&](int rank, int first, Span<int> const& numbers, auto const& shift_of) {
              int const here = team().rank();
              auto find = needed.loop(shared().box(rank), shared().box(here), rank == here);
              find.x = body.column(fields::position);
              find.first = first, find.numbers = numbers, find.shift_of = shift_of;
              return find;
            });
}

template <class P>
void OtherRanks<P>::copy_near(AnyParticles<P> const& body, ColumnNumbers columns, detail::AllBodiesRead<P> bodies,
                              double distance, bool images, AnyParticles<P>& copies,
                              ColumnNumbers columns_of_copies) const {
  shared().find_boxes(bodies);
  Plan<P> plan;
  plan_for(plan, detail::Needed<P>(images ? settings_.periods : std::vector<Period>{}, distance), body);
  copies.resize(plan.receiving());
  if (plan.everywhere() == 0) return;
  Exchange<P> exchange;
  exchange.send(team(), {{plan, body, columns}});
  exchange.receive({{plan, copies, columns_of_copies}});
}

template <class P>
void OtherRanks<P>::refresh(AnyParticles<P>& body, ColumnNumbers columns) {
  Shipments due;
  add_due(due, body, columns);
  deliver(due);
}

template <class P>
void OtherRanks<P>::refresh_all(std::vector<OtherRanks>& all, detail::AllBodies<P> bodies,
                                ColumnNumbers const* columns) {
  Shipments due;
  for (std::size_t k = 0; k < bodies.size(); ++k) all[k].add_due(due, bodies[k], columns[k]);
  all[0].deliver(due);
}

template <class P>
std::optional<std::vector<std::vector<int>>> OtherRanks<P>::scatter(std::vector<OtherRanks>& all,
                                                                    detail::AllBodies<P> bodies) {
  before_settle(all, bodies);
  std::vector<std::vector<int>> numbers;
  for (std::size_t k = 0; k < bodies.size(); ++k) numbers.push_back(all[k].keep_own(bodies[k]));
  before_create(all, bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) all[k].create(bodies[k]);
  return numbers;
}

template <class P>
std::vector<int> OtherRanks<P>::keep_own(AnyParticles<P>& body) {
  held_ = Held::own;
  if (!detail::on_all_ranks(body)) return values_of(migration_.keep_own(shared(), body));
  std::vector<int> all(std::size_t(body.size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

template <class P>
void OtherRanks<P>::add_due(Shipments& due, AnyParticles<P> const& body, ColumnNumbers columns) {
  if (ghosts_.everywhere() == 0) return;
  auto outdated = current_.due({columns.begin(), columns.end()});
  if (!outdated.empty()) due.emplace_back(ghosts_, body, std::move(outdated));
}

template <class P>
void OtherRanks<P>::deliver(Shipments const& all) const {
  for (auto first = all.begin(); first != all.end();) {
    auto const last = first + std::min<std::ptrdiff_t>(Exchange<P>::most, all.end() - first);
    Shipments const some(first, last);
    shared().exchange.send(team(), some);
    shared().exchange.receive(some);
    first = last;
  }
}

template <class P>
void OtherRanks<P>::check_ghosts(AnyParticles<P> const& body, ColumnNumbers columns) const {
  if (columns.empty() || ghosts_.everywhere() == 0) return;
  auto const bytes_of_ghosts = [&] {
    std::vector<std::byte> bytes;
    for (std::size_t const column : columns) {
      auto const [words, of_each] = body.columns().untyped(column);
      std::size_t const first = bytes.size(), size = std::size_t(body.ghosts()) * std::size_t(of_each) * sizeof *words;
      bytes.resize(first + size);
      copy_bytes<Kokkos::HostSpace, memory_of<P>>(body.space(), bytes.data() + first,
                                                  words + std::size_t(body.size()) * std::size_t(of_each), size);
    }
    return bytes;
  };
  Traffic const traffic = team().traffic();
  auto const before = bytes_of_ghosts();
  deliver({{ghosts_, body, columns}});
  team().count_from(traffic);
  if (bytes_of_ghosts() != before)
    throw std::logic_error("scree: ghosts are used with values that their origins do not have any more");
}

/// A formulation whose case may be divided among ranks, with bitwise identical results for any number of ranks.
template <class F>
struct OnRanks : F {
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherRanks<P>;
};

}  // namespace scree

#include "instances.hpp"
