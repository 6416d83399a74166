// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/periodic.hpp"
#include "../neighbours/verlet_list.hpp"
#include "../solver/survey.hpp"
#include "by_identity.hpp"
#include "divide.hpp"
#include "exchange.hpp"
#include "find.hpp"

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
    std::apply([&](auto const&... body) { all[0].shared().divide_if_due(all[0].reach_, all[0].scattered(), body...); },
               bodies);
  }
  /// Wraps particles that left a period, and sends those that left this part to the parts that they belong to.
  template <class Body>
  void settle(Body& body) {
    ProfilingRegion const region("scree::migrate");
    body.resize(body.size());
    images_.settle(body);
    if constexpr (!detail::on_all_parts<Body>) {
      if (held_ == Held::own)
        migrate(body, 0, body.size());
      else if (held_ == Held::share)
        migrate_share(body);
      else
        body.reorder(own(body));
    }
    held_ = Held::own;
  }
  /// Tells all parts where the particles of each are, before create() of the bodies.
  template <class... Bodies>
  static void before_create(std::array<OtherParts, sizeof...(Bodies)>& all, std::tuple<Bodies...>& bodies) {
    if (all[0].held_ != Held::own) {
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
  /// Copies of the particles of a body on other parts that are within a distance (m) of the box around the particles of
  /// `bodies` here, and of periodic images if those are wanted. All parts call it together.
  template <class Body, class... Bodies, class... Fs>
  Particles<P, Fields<Fs...>> copies_near(Body const& body, std::tuple<Bodies...> const& bodies, double distance,
                                          bool images, Fields<Fs...> list) const {
    std::apply([&](auto const&... each) { shared().find_boxes(each...); }, bodies);
    Plan<P> plan;
    plan.make(body.space(), team(), body.size(), [&](int part, int first, auto const& numbers, auto const& shift_of) {
      auto find = box_of(part, distance, images);
      find.x = body.column(fields::position);
      find.first = first, find.numbers = numbers, find.shift_of = shift_of;
      return find;
    });
    Particles<P, Fields<Fs...>> copies(body.space(), plan.receiving());
    Exchange<P> exchange;
    exchange.send(team(), plan, body, column_numbers<typename Body::fields>(list));
    exchange.receive(plan, copies, column_numbers<Fields<Fs...>>(list), 0);
    return copies;
  }
  /// Copies fields of the origins to the ghosts: one message to each part. Positions travel only if they changed.
  template <class Body, class List>
  void refresh(Body& body, List fields) {
    if (ghosts_.everywhere() == 0) return;
    auto columns = column_numbers<typename Body::fields>(fields);
    if constexpr (OneOf<Position, List>) {
      if (!moved_) std::erase(columns, column_numbers<typename Body::fields>(Fields<Position>{}).front());
      moved_ = false;
    }
    if (!columns.empty()) send(ghosts_, body, columns, body.size());
#ifdef SCREE_CHECK_LISTS
    if constexpr (OneOf<Position, List>) check_positions(body);
#endif
  }
  /// Call this after positions of the body changed.
  void positions_changed() { moved_ = true; }

  /// Whether there are other parts.
  bool several() const { return team().parts() > 1; }
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

  /// Whether each part has its own particles only, as from the first lists on.
  bool scattered() const { return held_ != Held::whole; }
  /// The values of all parts, those of part 0 first.
  template <class T>
  std::vector<T> of_all(std::vector<T> values) const {
    return scattered() ? detail::joined_values(team(), std::move(values)) : values;
  }
  /// The sum of a number of particles over all parts.
  long sum(long here) const { return scattered() ? long(team().sum(here)) : here; }
  /// The number of particles of all parts.
  template <class Body>
  long count(Body const& body) const {
    return detail::on_all_parts<Body> ? body.size() : sum(body.size());
  }
  /// Brings values of the particles of all parts, or of some of them by number, into the order of their identities.
  template <class Body, class... Numbers>
  detail::ByIdentity<typename P::space> order_of(Body const& body, Numbers const&... which) const {
    return {team(), body.to_host(fields::identity, which...), scattered() && !detail::on_all_parts<Body>};
  }
  /// Whether particles that are added to the case are added here; they move to their part with the next lists.
  bool takes_new() const { return !scattered() || team().part() == 0; }
  /// Lets all parts have the particles of the whole case again, as at the start.
  template <std::size_t Count>
  static void begin_again(std::array<OtherParts, Count>& all) {
    for (auto& each : all) each.held_ = Held::whole;
  }
  /// Tells that each part begins with a share of the particles. They go to their parts with the first lists.
  template <std::size_t Count>
  static void begin_with_shares(std::array<OtherParts, Count>& all) {
    for (auto& each : all) each.held_ = Held::share;
  }
  /// Whether particles have gone to the parts that their positions belong to.
  bool settled() const { return held_ == Held::own; }
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

  Team<typename P::space> const& team() const { return settings_.shared->team; }
  PartCounts const& counts() const { return settings_.shared->counts; }
  Partition<P::dim> const& partition() const { return settings_.shared->partition(); }

 private:
  Shared& shared() const { return *settings_.shared; }
  /// The loop that finds what a part needs of this one.
  detail::FindInBox<P> box_of(int part) const { return box_of(part, reach_, true); }
  /// The same within a distance (m), with or without periodic images.
  detail::FindInBox<P> box_of(int part, double reach, bool images) const {
    using real = typename P::real;
    detail::FindInBox<P> find;
    auto const& [low, high] = shared().box(part);
    auto const& mine = shared().box(team().part());
    for (int axis = 0; axis < P::dim; ++axis) {
      find.low[axis] = real(low[axis] - reach);
      find.high[axis] = real(high[axis] + reach);
    }
    for (auto const& shift : shifts_) {
      bool const is_image = &shift != shifts_.data();
      if (is_image ? !images : part == team().part()) continue;  // a particle is no ghost of itself
      bool near = true;
      for (int axis = 0; axis < P::dim; ++axis)
        near = near && mine.high[axis] + double(shift[axis]) >= low[axis] - 2 * reach &&
               mine.low[axis] + double(shift[axis]) <= high[axis] + 2 * reach;
      if (near) find.shifts[find.shift_count++] = shift;
    }
    return find;
  }
  template <class Body>
  Array<P, int const> own(Body const& body) {
    return staying(body, 0, body.size());
  }
  /// All particles but those among some that belong to other parts.
  template <class Body>
  Array<P, int const> staying(Body const& body, int from, int count) {
    reserve(body.space(), kept_, "scree::kept", std::size_t(body.size()));
    detail::FindStaying<P> const find{
        body.column(fields::position), shared().planes(), team().part(), from, from + count, kept_};
    return kept_.part(0, running_sum(body.space(), "scree::own", body.size(), find));
  }
  template <class Body>
  std::vector<int> keep_own(Body& body) {
    held_ = Held::own;
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
  /// Sends those among some particles that belong to other parts. Returns how many.
  template <class Body>
  int migrate(Body& body, int from, int count) {
    leaving_.make(body.space(), team(), count, [&](int part, int first, Span<int> const& numbers, auto const&) {
      int const wanted = part == team().part() ? -1 : part;
      return detail::FindOwnedBy<P>{body.column(fields::position), shared().planes(), wanted, first, numbers, from};
    });
    if (leaving_.everywhere() == 0) return 0;
    std::vector<std::size_t> columns(body.columns().kinds());
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = k;
    shared().exchange.send(team(), leaving_, body, columns);
    body.reorder(staying(body, from, count));
    int const first = body.append(leaving_.receiving());
    shared().exchange.receive(leaving_, body, columns, first);
    shared().counts.migrated += leaving_.receiving();
    return leaving_.sending();
  }
  /// The same for a share, most of which leaves: in rounds, so that messages need little memory.
  template <class Body>
  void migrate_share(Body& body) {
    int const rounds = 8, all = body.size();
    int seen = 0, sent = 0;
    for (int round = 1; round <= rounds; ++round) {
      int const count = static_cast<int>(std::int64_t(all) * round / rounds) - seen;
      int const from = seen - sent;
      seen += count;
      sent += migrate(body, from, count);
    }
    leaving_ = {}, shared().exchange = {};  // later messages are shorter
  }
  template <class Body>
  void send(Plan<P> const& plan, Body const& body, std::vector<std::size_t> const& columns, int first) const {
    shared().exchange.send(team(), plan, body, columns);
    shared().exchange.receive(plan, body, columns, first);
  }

  /// Throws if positions of ghosts are not those of their origins: somebody changed positions and did not say so.
  template <class Body>
  void check_positions(Body const& body) const {
    auto const before = values_of(body[fields::position]);
    send(ghosts_, body, column_numbers<typename Body::fields>(Fields<Position>{}), body.size());
    if (values_of(body[fields::position]) != before)
      throw std::logic_error("scree: ghosts are used at positions that their origins have left");
  }

  Settings settings_;
  PeriodicImages<P> images_;
  double reach_;
  std::vector<typename Plan<P>::vector> shifts_;  // the first is zero
  Plan<P> leaving_, ghosts_;
  Array<P, int> kept_;
  enum class Held { whole, share, own };
  Held held_ = Held::whole;  // what this part has of the case
  bool moved_ = true;        // positions changed since the ghosts were last told
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
