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

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
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
  /// The member `ranks` of the settings of a solver.
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

  bool any() const { return true; }
  /// The images at the ends of periods, without other ranks.
  PeriodicImages<P> images() const { return images_; }
  Settings const& settings() const { return settings_; }
  std::string signature() const { return images_.signature(); }

  /// Ghosts suffice wherever the owned particles of a rank are, so these may wait for lists that end between steps.
  /// Periodic images may not.
  bool must_settle(int builds) const { return !settings_.periods.empty() || builds > 64; }
  /// Divides the case if that is due, before settle() of the bodies.
  template <class... Bodies>
  static void before_settle(std::array<OtherRanks, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies) {
    std::apply(
        [&](auto const&... body) {
          all[0].shared().divide_if_due(all[0].needed_.reach(), all[0].scattered(), body...);
        },
        bodies);
  }
  /// Wraps particles that left a period, and sends those that left this rank to the ranks that they belong to.
  template <class Body>
  void settle(Body& body) {
    ProfilingRegion const region("scree::migrate");
    body.resize(body.size());
    images_.settle(body);
    if constexpr (!detail::on_all_ranks<Body>) {
      if (held_ == Held::own)
        migration_.run(shared(), body);
      else if (held_ == Held::share)
        migration_.run_for_share(shared(), body);
      else
        migration_.keep_own(shared(), body);
    }
    held_ = Held::own;
  }
  /// Tells all ranks where the particles of each are, before create() of the bodies.
  template <class... Bodies>
  static void before_create(std::array<OtherRanks, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies) {
    if (all[0].held_ != Held::own) {
      before_settle(all, bodies);
      [&]<std::size_t... K>(std::index_sequence<K...>) { (all[K].settle(std::get<K>(bodies)), ...); }
      (std::index_sequence_for<Bodies...>{});
    }
    std::apply(
        [&](auto&... body) {
          all[0].shared().find_boxes(body...);
          auto const counts = all[0].team().sum(std::vector{detail::counted_on(all[0].team().rank(), body)...});
          std::size_t k = 0;
          (body.set_everywhere(long(counts[k++])), ...);
        },
        bodies);
  }
  /// Replaces all ghosts according to the positions of the owned particles of all ranks.
  template <class Body>
  void create(Body& body) {
    ProfilingRegion const region("scree::ghosts_of_ranks");
    body.resize(body.size());
    if constexpr (!detail::on_all_ranks<Body>) {
      ghosts_.make(body.space(), team(), body.size(),
                   [&](int rank, int first, Span<int> const& numbers, auto const& shift_of) {
                     return find_for(rank, needed_, body, first, numbers, shift_of);
                   });
      check_number(double(body.size()) + double(ghosts_.receiving()));
      body.resize(body.size(), ghosts_.receiving());
      shared().counts.ghosts += ghosts_.receiving();
      current_.renew(column_numbers<typename Body::fields>(Fields<Position>{}).front());
      refresh(body, Fields<Position>{});
    }
  }
  /// Copies of the particles of a body on other ranks that are within a distance (m) of the box around the particles of
  /// `bodies` here, and of periodic images if those are wanted. All ranks call it together.
  template <class Body, class... Bodies, class... Fs>
  Particles<P, Fields<Fs...>> copies_near(Body const& body, std::tuple<Bodies...> const& bodies, double distance,
                                          bool images, Fields<Fs...> list) const {
    std::apply([&](auto const&... each) { shared().find_boxes(each...); }, bodies);
    detail::Needed<P> const near(images ? settings_.periods : std::vector<Period>{}, distance);
    Plan<P> plan;
    plan.make(body.space(), team(), body.size(),
              [&](int rank, int first, Span<int> const& numbers, auto const& shift_of) {
                return find_for(rank, near, body, first, numbers, shift_of);
              });
    Particles<P, Fields<Fs...>> copies(body.space(), plan.receiving());
    Exchange<P> exchange;
    if (plan.everywhere() > 0) {
      exchange.send(team(), {{plan, body, column_numbers<typename Body::fields>(list)}});
      exchange.receive({{plan, copies, column_numbers<Fields<Fs...>>(list)}});
    }
    return copies;
  }
  /// Copies fields of the origins to the ghosts, except those that are up to date there.
  template <class Body, class List>
  void refresh(Body& body, List fields) {
    Shipments due;
    add_due(due, body, fields);
    deliver(due);
    check_ghosts(body, fields);
  }
  /// refresh() for all bodies, each with a list of fields, with one message to each rank.
  template <class... Bodies, class... Lists>
  static void refresh_all(std::array<OtherRanks, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies,
                          std::tuple<Lists...> lists) {
    Shipments due;
    [&]<std::size_t... K>(std::index_sequence<K...>) {
      (all[K].add_due(due, std::get<K>(bodies), std::get<K>(lists)), ...);
      all[0].deliver(due);
      (all[K].check_ghosts(std::get<K>(bodies), std::get<K>(lists)), ...);
    }
    (std::index_sequence_for<Bodies...>{});
  }
  /// Marks the positions of the ghosts as outdated. Call it after positions of the body have changed.
  void positions_changed() { current_.positions_changed(); }
  /// Marks fields of the ghosts as outdated. Call it after fields of the body have changed, while all changes are
  /// announced.
  template <class Body, class List>
  void fields_changed(Body const&, List fields) {
    for (std::size_t const column : column_numbers<typename Body::fields>(fields)) current_.changed(column);
  }
  /// Begins (true) or ends (false) a time in which all changes of fields are announced.
  void announces_changes(bool all) { current_.forget(all); }

  /// Declares that all ranks have the particles of the whole case again, as at the start.
  template <std::size_t Count>
  static void begin_again(std::array<OtherRanks, Count>& all) {
    for (auto& each : all) each.held_ = Held::whole;
  }
  /// Declares that each rank begins with a share of the particles. They go to their ranks with the first lists.
  template <std::size_t Count>
  static void begin_with_shares(std::array<OtherRanks, Count>& all) {
    for (auto& each : all) each.held_ = Held::share;
  }
  /// Divides a case whose particles all ranks have, and makes the ghosts. Particles stay where they are, also outside
  /// of a period. Returns the numbers of those that each body keeps here.
  template <class... Bodies>
  static std::array<std::vector<int>, sizeof...(Bodies)> scatter(std::array<OtherRanks, sizeof...(Bodies)>& all,
                                                                 std::tuple<Bodies...>& bodies) {
    before_settle(all, bodies);
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
      std::array<std::vector<int>, sizeof...(Bodies)> numbers{all[K].keep_own(std::get<K>(bodies))...};
      before_create(all, bodies);
      (all[K].create(std::get<K>(bodies)), ...);
      return numbers;
    }
    (std::index_sequence_for<Bodies...>{});
  }

  /// How often the case was divided, and how many particles this rank received.
  RankCounts const& counts() const { return settings_.shared->counts; }
  /// The division of space among the ranks.
  Partition<P::dim> const& partition() const { return settings_.shared->partition(); }

 private:
  Shared& shared() const { return *settings_.shared; }
  /// The loop that finds the particles of this rank that another rank needs.
  template <class Body, class Numbers, class Shifts>
  detail::FindInBox<P> find_for(int rank, detail::Needed<P> const& needed, Body const& body, int first,
                                Numbers const& numbers, Shifts const& shift_of) const {
    int const here = team().rank();
    auto find = needed.loop(shared().box(rank), shared().box(here), rank == here);
    find.x = body.column(fields::position);
    find.first = first, find.numbers = numbers, find.shift_of = shift_of;
    return find;
  }
  template <class Body>
  std::vector<int> keep_own(Body& body) {
    held_ = Held::own;
    if constexpr (detail::on_all_ranks<Body>) {
      std::vector<int> all(std::size_t(body.size()));
      std::iota(all.begin(), all.end(), 0);
      return all;
    } else {
      return values_of(migration_.keep_own(shared(), body));
    }
  }
  /// Adds those of the fields that the ghosts of a body do not have.
  template <class Body, class List>
  void add_due(Shipments& due, Body const& body, List fields) {
    if (ghosts_.everywhere() == 0) return;
    auto columns = current_.due(column_numbers<typename Body::fields>(fields));
    if (!columns.empty()) due.emplace_back(ghosts_, body, std::move(columns));
  }
  void deliver(Shipments const& all) const {
    for (auto first = all.begin(); first != all.end();) {
      auto const last = first + std::min<std::ptrdiff_t>(Exchange<P>::most, all.end() - first);
      Shipments const some(first, last);
      shared().exchange.send(team(), some);
      shared().exchange.receive(some);
      first = last;
    }
  }

  /// Throws if ghosts have other values of these fields than their origins: somebody changed them and did not say so.
  template <class Body, class List>
  void check_ghosts([[maybe_unused]] Body const& body, [[maybe_unused]] List fields) const {
#ifdef SCREE_CHECK_LISTS
    auto const columns = column_numbers<typename Body::fields>(fields);
    if (columns.empty() || ghosts_.everywhere() == 0) return;
    Traffic const traffic = team().traffic();
    auto const before = bytes_of_ghosts(body, columns);
    deliver({{ghosts_, body, columns}});
    team().count_from(traffic);
    if (bytes_of_ghosts(body, columns) != before)
      throw std::logic_error("scree: ghosts are used with values that their origins do not have any more");
#endif
  }
  template <class Body>
  static std::vector<std::byte> bytes_of_ghosts(Body const& body, std::vector<std::size_t> const& columns) {
    std::vector<std::byte> bytes;
    for (std::size_t const column : columns) {
      auto const [words, of_each] = body.columns().untyped(column);
      std::size_t const first = bytes.size(), size = std::size_t(body.ghosts()) * std::size_t(of_each) * sizeof *words;
      bytes.resize(first + size);
      copy_bytes<Kokkos::HostSpace, memory_of<P>>(body.space(), bytes.data() + first,
                                                  words + std::size_t(body.size()) * std::size_t(of_each), size);
    }
    return bytes;
  }

  Settings settings_;
  PeriodicImages<P> images_;
  detail::Needed<P> needed_;
  detail::Migration<P> migration_;
  Plan<P> ghosts_;
  detail::CurrentColumns current_;
};

/// A formulation whose case may have several ranks, with the same bits on any number of them.
template <class F>
struct OnRanks : F {
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherRanks<P>;
};

}  // namespace scree
