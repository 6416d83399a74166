// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/remainder.hpp"
#include "ghosts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace scree {

/// A periodic direction of the domain, in which coordinate number `axis` is in [low, high), m.
struct Period {
  int axis = 0;
  double low = 0, high = 0;
};

namespace detail {

template <class P>
struct Wrap {
  Column<P, Position> x, at_rest;            // at_rest may be empty
  Column<P, Remainder<Position>> remainder;  // may be empty
  int axis;
  typename P::real low, length;
  SCREE_FN void operator()(int i) const {
    auto const away = length * Kokkos::floor((x(i)[axis] - low) / length);
    if (away == 0) return;
    if (i < remainder.size())
      wrap(x(i)[axis], remainder(i)[axis], away);
    else
      x(i)[axis] -= away;
    if (i < at_rest.size()) at_rest(i)[axis] -= away;
  }

 private:
  using real = typename P::real;
  /// Wraps a coordinate and adds the rounding error to its remainder.
  SCREE_FN static void wrap(real& place, real& remainder, real const& away) {
    auto const wrapped = two_sum(place, -away);
    auto const sum = two_sum(wrapped.value, wrapped.remainder + remainder);
    place = sum.value, remainder = sum.remainder;
  }
};

/// A loop that counts the images of each particle and, in the second sweep, writes their origins and shifts. An image
/// is shifted up by one period if the particle is near the low end, and down if it is near the high end.
template <class P>
struct FindImages {
  Column<P, Position> x;
  Period period;
  typename P::real reach;
  int owned;
  int first;  // index of the first new ghost
  Span<int> origin;
  ArraySpan<P, Vec<P::dim, typename P::real>> shift;

  SCREE_FN void operator()(int j, int& count, bool last) const {
    using real = typename P::real;
    real const place = x(j)[period.axis], low = real(period.low), high = real(period.high);
    for (int side = 0; side < 2; ++side) {
      if (side == 0 ? place >= low + reach : place < high - reach) continue;
      if (last && first + count < origin.size()) {
        int const ghost = first + count;
        bool const of_owned = j < owned;
        origin(ghost) = of_owned ? j : origin(j);
        shift(ghost) = of_owned ? zero<Vec<P::dim, real>>() : value_of(shift(j));
        shift(ghost)[period.axis] += side == 0 ? high - low : low - high;
      }
      ++count;
    }
  }
};

/// A loop that copies columns to images, and shifts the images if their positions are copied.
template <class P>
struct CopyToImages {
  static constexpr int most = 16;
  UntypedColumn columns[most];
  int count;
  Column<P, Position> places;  // empty unless positions are among the columns
  Span<int const> origin;
  ArraySpan<P, Vec<P::dim, typename P::real> const> shift;
  SCREE_FN void operator()(int ghost) const {
    for (int k = 0; k < count; ++k) columns[k].copy(columns[k], origin(ghost), ghost);
    if (ghost < places.size()) places(ghost) += shift(ghost);
  }
};

}  // namespace detail

/// A GhostProvider for the periodic images of one body. A ghost carries copies of the fields of its origin, so terms
/// need not take periods into account. create() makes images of all particles within support plus margin of an end of a
/// period, and refresh() updates them from their origins.
template <class P>
class PeriodicImages {
 public:
  using Settings = std::vector<Period>;
  /// Takes periods, support (m) and margin (m). Throws std::invalid_argument if a period is shorter than two supports,
  /// if its axis does not exist, or if two periods have the same axis.
  PeriodicImages(std::vector<Period> periods, double support, double margin = 0);

  bool any() const { return !periods_.empty(); }
  Settings const& settings() const { return periods_; }
  std::string signature() const;

  /// Moves owned particles that have left a period to its other end, and their rest positions with them.
  [[gnu::cold]] void settle(AnyParticles<P>& body) const;
  /// Replaces all ghosts, according to the positions of the owned particles.
  [[gnu::cold]] void create(AnyParticles<P>& body);
  /// Copies columns of the origins to the ghosts.
  void refresh(AnyParticles<P>& body, ColumnNumbers columns) const {
    if (body.ghosts() > 0) copy(body, columns, body.size());
  }

 private:
  using real = typename P::real;

  int find(AnyParticles<P> const& body, Period const& period, int first) const;
  void copy(AnyParticles<P> const& body, ColumnNumbers columns, int first) const;

  std::vector<Period> periods_;
  double reach_;
  Array<P, int> origin_;
  Array<P, Vec<P::dim, real>> shift_;
};

template <class P>
PeriodicImages<P>::PeriodicImages(std::vector<Period> periods, double support, double margin)
    : periods_(std::move(periods)), reach_(support + margin) {
  double const least = 2 * support * (1 - 1e-12);  // rounding may shorten a period of exactly two supports
  bool has_period[P::dim] = {};
  for (Period const& period : periods_) {
    check_setting(period.axis >= 0 && period.axis < P::dim, "the axis of a period", period.axis,
                  "an axis of the space");
    check_setting(std::isfinite(period.low), "the low end (m) of a period", period.low, "finite");
    check_setting(period.high - period.low >= least && std::isfinite(period.high),
                  "the length (m) of a period, high - low,", period.high - period.low, "two supports or more");
    check_setting(!has_period[period.axis], "the axis of a period", period.axis, "another than that of the others");
    has_period[period.axis] = true;
  }
}

template <class P>
void PeriodicImages<P>::settle(AnyParticles<P>& body) const {
  using namespace fields;
  ProfilingRegion const region("scree::wrap");
  Column<P, Position> at_rest;
  Column<P, Remainder<Position>> remainder;
  if (body.has(rest_position)) at_rest = body.column(rest_position);
  if (body.has(Remainder<Position>{})) remainder = body.column(Remainder<Position>{});
  for (Period const& period : periods_)
    for_each_index(body.space(), "scree::wrap", 0, body.size(),
                   detail::Wrap<P>{body.column(position), at_rest, remainder, period.axis, real(period.low),
                                   real(period.high - period.low)});
}

template <class P>
void PeriodicImages<P>::create(AnyParticles<P>& body) {
  if (periods_.empty()) return;
  ProfilingRegion const region("scree::images");
  std::array const positions{body.number_of(fields::position)};
  body.resize(body.size());
  for (Period const& period : periods_) {
    int const first = body.extent(), images = find(body, period, first);
    body.resize(body.size(), first + images - body.size());
    if (origin_.size() < body.extent()) {
      int const spare = std::min(body.extent() / 8, most_particles - body.extent());
      enlarge(body.space(), origin_, "scree::origins", body.extent() + spare);
      enlarge(body.space(), shift_, "scree::shifts", origin_.size());
      find(body, period, first);
    }
    copy(body, positions, first);
  }
}

template <class P>
int PeriodicImages<P>::find(AnyParticles<P> const& body, Period const& period, int first) const {
  return running_sum(
      body.space(), "scree::find_images", first,
      detail::FindImages<P>{body.column(fields::position), period, real(reach_), body.size(), first, origin_, shift_});
}

template <class P>
void PeriodicImages<P>::copy(AnyParticles<P> const& body, ColumnNumbers columns, int first) const {
  using Copies = detail::CopyToImages<P>;
  std::size_t const positions = body.number_of(fields::position);
  for (std::size_t begin = 0; begin < columns.size(); begin += Copies::most) {
    ColumnNumbers const some(columns.begin() + begin, std::min(columns.size() - begin, std::size_t(Copies::most)));
    Copies copies{{}, static_cast<int>(some.size()), {}, origin_, shift_};
    for (std::size_t k = 0; k < some.size(); ++k) {
      copies.columns[k] = body.columns().untyped(some[k]);
      if (some[k] == positions) copies.places = body.column(fields::position);
    }
    for_each_index(body.space(), "scree::refresh_images", first, body.extent(), copies);
  }
}

template <class P>
std::string PeriodicImages<P>::signature() const {
  std::string text;
  for (Period const& period : periods_)
    text += detail::formatted("period along axis %d: %.17g to %.17g m\n", period.axis, period.low, period.high);
  return text;
}

}  // namespace scree
