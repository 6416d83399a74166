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

/// Ghost particles of one body that are copies of particles of other ranks of the case, and periodic images of those
/// and of its own. A GhostProvider: with it each rank has a solver of its own, made from the particles of the whole
/// case or from a share of them; it keeps its own. Particles move to the rank that their position belongs to whenever
/// lists are built between steps. All ranks do the same steps, and call everything that reads neighbours together.
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
    /// Settings of a case on these ranks, with the directions in which its domain is periodic.
    Settings(Ranks const& ranks, std::vector<Period> periods_)
        : shared(std::make_shared<Shared>(ranks)), periods(std::move(periods_)) {}
    std::shared_ptr<Shared> shared;  ///< common to the ranks of a case
    std::vector<Period> periods;     ///< directions in which the domain is periodic
  };

  /// Ghosts for sums within `support` (m), which suffice until particles have moved by the margin (m).
  OtherRanks(Settings const& settings, double support, double margin)
      : Agreement<P>(settings.shared->team),
        settings_(settings),
        images_(settings.periods, support, margin),
        // Lists are built of pairs within support and half the margin.
        needed_(settings.periods, (support + margin / 2) * (1 + 1e-5)) {}

  /// The agreement of all ranks.
  OtherRanks const& whole_case() const { return *this; }
  bool any() const { return true; }
  /// The images at the ends of periods, without other ranks.
  PeriodicImages<P> images() const { return images_; }
  /// Images at the ends of periods within a radius (m), without other ranks.
  PeriodicImages<P> images_within(double radius) const { return PeriodicImages<P>(settings_.periods, radius); }
  Settings const& settings() const { return settings_; }
  std::string signature() const { return images_.signature(); }

  /// Ghosts suffice wherever the owned particles of a rank are, so these may wait for lists that end between steps.
  /// Periodic images may not.
  bool must_settle(int& unsettled) const { return ++unsettled > 64 || !settings_.periods.empty(); }
  /// Divides the case if that is due, before settle() of the bodies.
  static void before_settle(std::vector<OtherRanks>& all, detail::AllBodiesRead<P> bodies) {
    all[0].shared().divide_if_due(all[0].needed_.reach(), !all[0].all_here(), bodies);
  }
  /// Wraps particles that left a period, and sends those that left this rank to the ranks that they belong to.
  void settle(AnyParticles<P>& body);
  /// Tells all ranks where the particles of each are, before create() of the bodies.
  static void before_create(std::vector<OtherRanks>& all, detail::AllBodies<P> bodies);
  /// Replaces all ghosts according to the positions of the owned particles of all ranks.
  void create(AnyParticles<P>& body);
  /// Unless all particles are here, visit(copies) for copies of the particles of a body on other ranks that are within
  /// a distance (m) of the box around the particles of `bodies` here, and of periodic images if those are wanted. All
  /// ranks call it together.
  template <class... Fs, class Visit>
  void with_copies_near(AnyParticles<P> const& body, detail::AllBodiesRead<P> bodies, double distance, bool images,
                        Fields<Fs...> list, Visit const& visit) const {
    if (this->all_here()) return;
    Particles<P, Fields<Fs...>> copies(body.space());
    copy_near(body, body.numbers_of(list), bodies, distance, images, copies, copies.numbers_of(list));
    visit(copies);
  }
  /// Copies columns of the origins to the ghosts, except those that are up to date there.
  void refresh(AnyParticles<P>& body, ColumnNumbers columns);
  /// refresh() for all bodies, each with some columns, with one message to each rank.
  static void refresh_all(std::vector<OtherRanks>& all, detail::AllBodies<P> bodies, ColumnNumbers const* columns);
  /// Throws std::logic_error if ghosts have other values of these columns than their origins: somebody changed them and
  /// did not say so. For tests.
  void check_ghosts(AnyParticles<P> const& body, ColumnNumbers columns) const;
  /// Marks the positions of the ghosts as outdated. Call it after positions of the body have changed.
  void positions_changed() { current_.positions_changed(); }
  /// Marks columns of the ghosts as outdated. Call it after fields of the body have changed, while all changes are
  /// announced.
  void columns_changed(ColumnNumbers columns) {
    for (std::size_t const column : columns) current_.changed(column);
  }
  /// Begins (true) or ends (false) a time in which all changes of fields are announced.
  void announces_changes(bool all) { current_.forget(all); }

  /// Declares that all ranks have the particles of the whole case again, as at the start.
  static void begin_again(std::vector<OtherRanks>& all) {
    for (auto& each : all) each.held_ = Held::whole;
  }
  /// Begins with the particles that a solver is given on each rank, of the whole case or in shares, which go to their
  /// ranks with the first lists. Throws std::invalid_argument if the shares are not those of one case.
  template <class Start>
  static void begin(std::vector<OtherRanks>& all, Start const& start) {
    if (!all[0].anywhere(detail::begins_from_shares(start))) return;
    for (auto& each : all) each.held_ = Held::share;
    detail::check_shares(start, all[0]);
  }
  /// Whether this rank has a share whose particles may belong to other ranks.
  bool has_share() const { return held_ == Held::share; }
  /// Divides a case whose particles all ranks have, and makes the ghosts. Particles stay where they are, also outside
  /// of a period. Returns the numbers of those that each body keeps here.
  static std::optional<std::vector<std::vector<int>>> scatter(std::vector<OtherRanks>& all,
                                                              detail::AllBodies<P> bodies);

  /// How often the case was divided, and how many particles this rank received.
  RankCounts const& counts() const { return settings_.shared->counts; }
  /// The division of space among the ranks.
  Partition<P::dim> const& partition() const { return settings_.shared->partition(); }

 private:
  Shared& shared() const { return *settings_.shared; }
  /// Lists the particles that the ranks need of this one.
  void plan_for(Plan<P>& plan, detail::Needed<P> const& needed, AnyParticles<P> const& body) const;
  void copy_near(AnyParticles<P> const& body, ColumnNumbers columns, detail::AllBodiesRead<P> bodies, double distance,
                 bool images, AnyParticles<P>& copies, ColumnNumbers columns_of_copies) const;
  std::vector<int> keep_own(AnyParticles<P>& body);
  /// Adds those of the columns that the ghosts of a body do not have.
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

/// A formulation whose case may have several ranks, with the same bits on any number of them.
template <class F>
struct OnRanks : F {
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherRanks<P>;
};

}  // namespace scree

#include "instances.hpp"
