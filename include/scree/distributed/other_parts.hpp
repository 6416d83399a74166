// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/periodic.hpp"
#include "../neighbours/verlet_list.hpp"
#include "agreement.hpp"
#include "divide.hpp"
#include "exchange.hpp"
#include "find.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// Ghost particles of one body that are copies of particles of other parts of the case, and periodic images of those
/// and of its own. A GhostProvider: with it each part has a solver of its own, made from the particles of the whole
/// case, of which it keeps its share. Particles move to the part that their position belongs to whenever lists are
/// built between steps. All parts do the same steps, and call everything that reads neighbours together.
template <class P>
class OtherParts : public Agreement<P> {
  using Shared = detail::SharedByBodies<P>;
  using Agreement<P>::scattered_;
  using Shipments = typename Exchange<P>::Shipments;

 public:
  using Agreement<P>::team;
  /// The member `parts` of the settings of a solver.
  using Parts = DividedCase<typename P::space>;
  struct Settings {
    Settings(Parts const& parts, std::vector<Period> periods_)
        : shared(std::make_shared<Shared>(parts)), periods(std::move(periods_)) {}
    std::shared_ptr<Shared> shared;
    std::vector<Period> periods;
  };

  OtherParts(Settings const& settings, double support, double margin)
      : Agreement<P>(settings.shared->team),
        settings_(settings),
        images_(settings.periods, support, margin),
        // Lists are built of pairs within support and half the margin.
        reach_((support + margin / 2) * (1 + 1e-5)) {
    using vector = typename Plan<P>::vector;
    shifts_.push_back(zero<vector>());
    for (Period const& period : settings.periods)
      for (std::size_t k = 0, count = shifts_.size(); k < count; ++k)
        for (int sign : {1, -1}) {
          vector shift = shifts_[k];
          shift[period.axis] += typename P::real(sign) * (typename P::real(period.high) - typename P::real(period.low));
          shifts_.push_back(shift);
        }
  }

  bool any() const { return true; }
  /// The images at the ends of periods, without other parts.
  PeriodicImages<P> images() const { return images_; }
  Settings const& settings() const { return settings_; }
  std::string signature() const { return images_.signature(); }

  /// Ghosts suffice wherever the owned particles of a part are, so these may wait for lists that end between steps.
  /// Periodic images may not.
  bool must_settle(int builds) const { return !settings_.periods.empty() || builds > 64; }
  /// Divides the case if that is due, before settle() of the bodies.
  template <class... Bodies>
  static void before_settle(std::array<OtherParts, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies) {
    std::apply([&](auto const&... body) { all[0].shared().divide_if_due(all[0].reach_, all[0].scattered_, body...); },
               bodies);
  }
  /// Wraps particles that left a period, and sends those that left this part to the parts that they belong to.
  template <class Body>
  void settle(Body& body) {
    ProfilingRegion const region("scree::migrate");
    body.resize(body.size());
    images_.settle(body);
    if constexpr (!detail::on_all_parts<Body>) {
      if (scattered_)
        migrate(body);
      else
        body.reorder(own(body));
    }
    scattered_ = true;
  }
  /// Tells all parts where the particles of each are, before create() of the bodies.
  template <class... Bodies>
  static void before_create(std::array<OtherParts, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies) {
    if (!all[0].scattered_) {
      before_settle(all, bodies);
      [&]<std::size_t... K>(std::index_sequence<K...>) { (all[K].settle(std::get<K>(bodies)), ...); }
      (std::index_sequence_for<Bodies...>{});
    }
    std::apply(
        [&](auto&... body) {
          all[0].shared().find_boxes(body...);
          auto const counts = all[0].team().sum(std::vector{detail::counted_on(all[0].team().part(), body)...});
          std::size_t k = 0;
          (body.set_everywhere(long(counts[k++])), ...);
        },
        bodies);
  }
  /// Replaces all ghosts according to the positions of the owned particles of all parts.
  template <class Body>
  void create(Body& body) {
    ProfilingRegion const region("scree::ghosts_of_parts");
    body.resize(body.size());
    if constexpr (!detail::on_all_parts<Body>) {
      ghosts_.make(body.space(), team(), body.size(),
                   [&](int part, int first, Span<int> const& numbers, auto const& shift_of) {
                     auto find = box_of(part);
                     find.x = body.column(fields::position);
                     find.first = first, find.numbers = numbers, find.shift_of = shift_of;
                     return find;
                   });
      check_number(double(body.size()) + double(ghosts_.receiving()));
      body.resize(body.size(), ghosts_.receiving());
      shared().counts.ghosts += ghosts_.receiving();
      moved_ = true;
      refresh(body, Fields<Position>{});
    }
  }
  /// Copies fields of the origins to the ghosts. Positions travel only if they changed.
  template <class Body, class List>
  void refresh(Body& body, List fields) {
    Shipments due;
    add_due(due, body, fields);
    deliver(due);
    check_ghosts(body, fields);
  }
  /// The same for several bodies, with one message to each part: a list of fields of each.
  template <class... Bodies, class... Lists>
  static void refresh_all(std::array<OtherParts, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies,
                          std::tuple<Lists...> lists) {
    Shipments due;
    [&]<std::size_t... K>(std::index_sequence<K...>) {
      (all[K].add_due(due, std::get<K>(bodies), std::get<K>(lists)), ...);
      all[0].deliver(due);
      (all[K].check_ghosts(std::get<K>(bodies), std::get<K>(lists)), ...);
    }
    (std::index_sequence_for<Bodies...>{});
  }
  /// Call this after positions of the body changed.
  void positions_changed() { moved_ = true; }

  /// Lets all parts have the particles of the whole case again, as at the start.
  template <std::size_t Count>
  static void begin_again(std::array<OtherParts, Count>& all) {
    for (auto& each : all) each.scattered_ = false;
  }
  /// Divides a case whose particles all parts have, and makes the ghosts. Particles stay where they are, also outside
  /// of a period. Returns the numbers of those that each body keeps here.
  template <class... Bodies>
  static std::array<std::vector<int>, sizeof...(Bodies)> scatter(std::array<OtherParts, sizeof...(Bodies)>& all,
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

  PartCounts const& counts() const { return settings_.shared->counts; }
  Partition<P::dim> const& partition() const { return settings_.shared->partition(); }

 private:
  Shared& shared() const { return *settings_.shared; }
  /// The loop that finds what a part needs of this one.
  detail::FindInBox<P> box_of(int part) const {
    using real = typename P::real;
    detail::FindInBox<P> find;
    auto const& [low, high] = shared().box(part);
    auto const& mine = shared().box(team().part());
    for (int axis = 0; axis < P::dim; ++axis) {
      find.low[axis] = real(low[axis] - reach_);
      find.high[axis] = real(high[axis] + reach_);
    }
    for (auto const& shift : shifts_) {
      if (part == team().part() && &shift == shifts_.data()) continue;  // a particle is no ghost of itself
      bool near = true;
      for (int axis = 0; axis < P::dim; ++axis)
        near = near && mine.high[axis] + double(shift[axis]) >= low[axis] - 2 * reach_ &&
               mine.low[axis] + double(shift[axis]) <= high[axis] + 2 * reach_;
      if (near) find.shifts[find.shift_count++] = shift;
    }
    return find;
  }
  template <class Body>
  Array<P, int const> own(Body const& body) {
    detail::FindOwnedBy<P> find{body.column(fields::position), shared().planes(), team().part(), 0, {}};
    reserve(body.space(), kept_, "scree::kept", std::size_t(body.size()));
    find.numbers = kept_;
    int const count = running_sum(body.space(), "scree::own", body.size(), find);
    return kept_.part(0, count);
  }
  template <class Body>
  std::vector<int> keep_own(Body& body) {
    scattered_ = true;
    if constexpr (detail::on_all_parts<Body>) {
      std::vector<int> all(std::size_t(body.size()));
      std::iota(all.begin(), all.end(), 0);
      return all;
    } else {
      auto const numbers = own(body);
      body.reorder(numbers);
      return values_of(numbers);
    }
  }
  template <class Body>
  void migrate(Body& body) {
    leaving_.make(body.space(), team(), body.size(), [&](int part, int first, Span<int> const& numbers, auto const&) {
      int const wanted = part == team().part() ? -1 : part;
      return detail::FindOwnedBy<P>{body.column(fields::position), shared().planes(), wanted, first, numbers};
    });
    if (leaving_.everywhere() == 0) return;
    std::vector<std::size_t> columns(body.columns().kinds());
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = k;
    Shipments const all = {{leaving_, body, columns}};
    shared().exchange.send(team(), all);
    body.reorder(own(body));
    body.append(leaving_.receiving());
    shared().exchange.receive(all);
    shared().counts.migrated += leaving_.receiving();
  }
  /// Adds those of the fields that the ghosts of a body do not have.
  template <class Body, class List>
  void add_due(Shipments& due, Body const& body, List fields) {
    if constexpr (!std::is_same_v<List, Fields<>>) {
      if (ghosts_.everywhere() == 0) return;
      auto columns = column_numbers<typename Body::fields>(fields);
      if constexpr (OneOf<Position, List>) {
        if (!moved_) std::erase(columns, column_numbers<typename Body::fields>(Fields<Position>{}).front());
        moved_ = false;
      }
      if (!columns.empty()) due.emplace_back(ghosts_, body, std::move(columns));
    }
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

  /// Throws if positions of ghosts are not those of their origins: somebody changed positions and did not say so.
  template <class Body, class List>
  void check_ghosts([[maybe_unused]] Body const& body, List) const {
#ifdef SCREE_CHECK_LISTS
    if constexpr (OneOf<Position, List>) {
      if (ghosts_.everywhere() == 0) return;
      Traffic const traffic = team().traffic();
      auto const before = values_of(body[fields::position]);
      deliver({{ghosts_, body, column_numbers<typename Body::fields>(Fields<Position>{})}});
      team().count_from(traffic);
      if (values_of(body[fields::position]) != before)
        throw std::logic_error("scree: ghosts are used at positions that their origins have left");
    }
#endif
  }

  Settings settings_;
  PeriodicImages<P> images_;
  double reach_;
  std::vector<typename Plan<P>::vector> shifts_;  // the first is zero
  Plan<P> leaving_, ghosts_;
  Array<P, int> kept_;
  bool moved_ = true;  // positions changed since the ghosts were last told
};

/// A formulation whose case may have several parts, with the same bits on any number of them.
template <class F>
struct OnParts : F {
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherParts<P>;
};

}  // namespace scree
