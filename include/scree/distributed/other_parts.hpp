// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/periodic.hpp"
#include "../solver/survey.hpp"
#include "divide.hpp"
#include "exchange.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Numbers the particles that belong to a part; for a Plan, or alone.
template <class P>
struct FindOwnedBy {
  Column<P, Position> x;
  Span<typename Partition<P::dim>::Plane const> planes;
  int part;
  int first;
  Span<int> numbers;

  SCREE_FN void operator()(int j, int& count, bool last) const {
    if (Partition<P::dim>::owner_of(planes, value_of(x(j))) != part) return;
    if (last && first + count < numbers.size()) numbers(first + count) = j;
    ++count;
  }
};

/// Lists the particles and images of them within a box.
template <class P>
struct FindInBox {
  static constexpr int most_shifts = P::dim == 2 ? 9 : 27;
  using vector = Vec<P::dim, typename P::real>;
  Column<P, Position> x;
  vector low, high, shifts[most_shifts];
  int shift_count = 0;
  int first = 0;
  Span<int> numbers;
  ArraySpan<P, vector> shift_of;

  SCREE_FN void operator()(int j, int& count, bool last) const {
    for (int s = 0; s < shift_count; ++s) {
      vector const place = value_of(x(j)) + shifts[s];
      bool inside = true;
      for (int axis = 0; axis < P::dim; ++axis)
        inside = inside && place[axis] >= low[axis] && place[axis] <= high[axis];
      if (!inside) continue;
      if (last && first + count < numbers.size()) {
        numbers(first + count) = j;
        shift_of(first + count) = shifts[s];
      }
      ++count;
    }
  }
};

}  // namespace detail

/// Ghost particles of one body that are copies of particles of other parts of the case, and periodic images of those
/// and of its own. A GhostProvider: with it each part has a solver of its own, made from the particles of the whole
/// case, of which it keeps its share. Particles move to the part that their position belongs to whenever lists are
/// built between steps. All parts do the same steps, and call everything that reads neighbours together.
template <class P>
class OtherParts {
  using Shared = detail::SharedByBodies<P>;

 public:
  /// The member `parts` of the settings of a solver.
  using Parts = DividedCase<typename P::space>;
  struct Settings {
    Settings(Parts const& parts, std::vector<Period> periods_)
        : shared(std::make_shared<Shared>(parts)), periods(std::move(periods_)) {}
    std::shared_ptr<Shared> shared;
    std::vector<Period> periods;
  };

  OtherParts(Settings const& settings, double support, double margin)
      : settings_(settings),
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
  Settings const& settings() const { return settings_; }
  std::string signature() const { return images_.signature(); }

  /// Ghosts suffice wherever the owned particles of a part are, so these may wait for lists that end between steps.
  /// Periodic images may not.
  bool must_settle(int builds) const { return !settings_.periods.empty() || builds > 64; }
  /// Divides the case if that is due, before settle() of the bodies.
  template <class... Bodies>
  static void before_settle(std::array<OtherParts, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies) {
    std::apply([&](auto const&... body) { all[0].shared().divide_if_due(all[0].reach_, body...); }, bodies);
  }
  /// Wraps particles that left a period, and sends those that left this part to the parts that they belong to.
  template <class Body>
  void settle(Body& body) {
    ProfilingRegion const region("scree::migrate");
    body.resize(body.size());
    images_.settle(body);
    if (!scattered_)
      keep_own(body);
    else
      migrate(body);
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
    std::apply([&](auto const&... body) { all[0].shared().find_boxes(body...); }, bodies);
  }
  /// Replaces all ghosts according to the positions of the owned particles of all parts.
  template <class Body>
  void create(Body& body) {
    ProfilingRegion const region("scree::ghosts_of_parts");
    body.resize(body.size());
    ghosts_.make(body.space(), team(), body.size(),
                 [&](int part, int first, Span<int> const& numbers, auto const& shift_of) {
                   auto find = box_of(part);
                   find.x = body.column(position);
                   find.first = first, find.numbers = numbers, find.shift_of = shift_of;
                   return find;
                 });
    check_number(double(body.size()) + double(ghosts_.receiving()));
    body.resize(body.size(), ghosts_.receiving());
    shared().counts.ghosts += ghosts_.receiving();
    refresh(body, Fields<Position>{});
  }
  /// Copies fields of the origins to the ghosts: one message to each part.
  template <class Body, class List>
  void refresh(Body& body, List fields) const {
    if (ghosts_.everywhere() == 0) return;
    send(ghosts_, body, column_numbers<typename Body::fields>(fields), body.size());
  }

  /// The largest of a number over all parts, which all get.
  double largest(double here) const { return team().largest(here); }
  /// Joins the frames of each body over all parts.
  template <std::size_t Count>
  void join(std::array<Frame<P::dim>, Count>& frames) const {
    auto const all = team().gather(frames);
    frames = {};
    for (auto const& each : all)
      for (std::size_t body = 0; body < Count; ++body) frames[body].add(each[body]);
  }

  template <std::size_t Count>
  std::pair<std::array<Largest, Count>, long> joined(std::array<Largest, Count> const& here, long particles) const {
    struct Found {
      std::array<Largest, Count> largest;
      long particles;
    };
    auto const all = team().gather(Found{here, particles});
    std::array<Largest, Count> joined = {};
    long count = 0;
    for (Found const& each : all) count += each.particles;
    for (std::size_t k = 0; k < Count; ++k) {
      int first = -1;  // the first part with the largest value
      for (int q = 0; q < team().parts(); ++q) {
        auto const& [largest, number] = all[std::size_t(q)];
        joined[k].beyond += largest[k].beyond;
        if (number > 0 && (first < 0 || largest[k].value > joined[k].value))
          joined[k].value = largest[k].value, first = q;
      }
      joined[k].particle = first == team().part() ? here[k].particle : detail::no_particle;
    }
    return {joined, count};
  }

  Team<typename P::space> const& team() const { return settings_.shared->team; }
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
    detail::FindOwnedBy<P> find{body.column(position), shared().planes(), team().part(), 0, {}};
    reserve(body.space(), kept_, "scree::kept", std::size_t(body.size()));
    find.numbers = kept_;
    int const count = running_sum(body.space(), "scree::own", body.size(), find);
    return kept_.part(0, count);
  }
  template <class Body>
  void keep_own(Body& body) {
    body.reorder(own(body));
  }
  template <class Body>
  void migrate(Body& body) {
    leaving_.make(body.space(), team(), body.size(), [&](int part, int first, Span<int> const& numbers, auto const&) {
      int const wanted = part == team().part() ? -1 : part;
      return detail::FindOwnedBy<P>{body.column(position), shared().planes(), wanted, first, numbers};
    });
    if (leaving_.everywhere() == 0) return;
    std::vector<std::size_t> columns(body.columns().kinds());
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = k;
    shared().exchange.send(team(), leaving_, body, columns);
    body.reorder(own(body));
    int const first = body.append(leaving_.receiving());
    shared().exchange.receive(leaving_, body, columns, first);
    shared().counts.migrated += leaving_.receiving();
  }
  template <class Body>
  void send(Plan<P> const& plan, Body const& body, std::vector<std::size_t> const& columns, int first) const {
    shared().exchange.send(team(), plan, body, columns);
    shared().exchange.receive(plan, body, columns, first);
    ++shared().counts.exchanges;
    shared().counts.bytes = shared().exchange.bytes();
  }

  Settings settings_;
  PeriodicImages<P> images_;
  double reach_;
  std::vector<typename Plan<P>::vector> shifts_;  // the first is zero
  Plan<P> leaving_, ghosts_;
  Array<P, int> kept_;
  bool scattered_ = false;  // each part has only its own particles
};

}  // namespace scree
