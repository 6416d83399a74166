// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "../fields/standard.hpp"

#include <limits>
#include <stdexcept>

namespace scree {

/// A direction in which the domain repeats: coordinate `axis` in [low, high), m.
struct Period {
  int axis = 0;
  double low = 0, high = 0;
};

namespace detail {

/// What else says where a particle is goes with its position.
template <class P, class... Others>
struct Wrap {
  Columns<P, Fields<Position, Others...>> columns;
  int axis;
  typename P::real low, length;
  SCREE_FN void operator()(int i) const {
    auto const away = length * Kokkos::floor((columns[position](i)[axis] - low) / length);
    if (away == 0) return;
    columns[position](i)[axis] -= away;
    ((columns[Others{}](i)[axis] -= away), ...);
  }
};

/// Numbers the images a particle needs and, in the second sweep, writes where they come from. Image k of particle j
/// lies one length up (j is near the low end) or down.
template <class P>
struct FindImages {
  Column<P, Position> x;
  Period period;
  typename P::real reach;
  int first;  // index of the first new ghost
  Kokkos::View<int*, memory_of<P>> origin;
  Kokkos::View<Vec<P::dim, typename P::real>*, memory_of<P>> shift;

  SCREE_FN void operator()(int j, int& count, bool last) const {
    using real = typename P::real;
    real const place = x(j)[period.axis], low = real(period.low), high = real(period.high);
    for (int side = 0; side < 2; ++side) {
      if (side == 0 ? place >= low + reach : place < high - reach) continue;
      if (last && first + count < static_cast<int>(origin.extent(0))) {
        int const ghost = first + count;
        origin(ghost) = j < first && origin(j) >= 0 ? origin(j) : j;
        shift(ghost) = origin(ghost) == j ? Vec<P::dim, real>(Vec<P::dim, real>::Zero()) : shift(j);
        shift(ghost)[period.axis] += side == 0 ? high - low : low - high;
      }
      ++count;
    }
  }
};

template <class P, class... Fs>
struct CopyToImages {
  Columns<P, Fields<Fs...>> columns;
  Kokkos::View<int*, memory_of<P>> origin;
  Kokkos::View<Vec<P::dim, typename P::real>*, memory_of<P>> shift;
  SCREE_FN void operator()(int ghost) const { (copy(Fs{}, ghost, origin(ghost)), ...); }

 private:
  template <class F>
  SCREE_FN void copy(F field, int ghost, int from) const {
    columns[field](ghost) = columns[field](from);
    if constexpr (std::is_same_v<F, Position>) columns[field](ghost) += shift(ghost);
  }
};

}  // namespace detail

/// Ghost particles of one body that stand for its periodic images. A ghost carries copies of the fields of its origin,
/// so that terms need not know of periods. Images of all particles within support and margin of the ends of each period
/// are made at create(), and follow their origins, as long as two particles have not moved by the margin.
template <class P>
class PeriodicImages {
 public:
  /// Lengths in m. Throws std::invalid_argument if a period is shorter than two supports or has no axis of the space.
  PeriodicImages(std::vector<Period> periods, double support, double margin = 0)
      : periods_(std::move(periods)), reach_(support + margin) {
    for (Period const& period : periods_)
      if (period.axis < 0 || period.axis >= P::dim || !(period.high - period.low >= 2 * support))
        throw std::invalid_argument("scree: a period needs an axis of the space and at least two supports of length");
  }

  bool any() const { return !periods_.empty(); }

  /// Moves owned particles that left a period to its other end, with their places at rest.
  template <class Body>
  void wrap(Body& body) const {
    if constexpr (OneOf<RestPosition, typename Body::fields>)
      wrap_with(body, Fields<Position, RestPosition>{});
    else
      wrap_with(body, Fields<Position>{});
  }

  /// Makes the ghosts anew from the positions of the owned particles.
  template <class Body>
  void create(Body& body) {
    if (periods_.empty()) return;
    body.resize(body.size());
    Kokkos::deep_copy(origin_, -1);
    for (Period const& period : periods_) {
      int const first = body.extent();
      int const images = find(body, period, first);
      body.resize(body.size(), first + images - body.size());
      if (static_cast<int>(origin_.extent(0)) < body.extent()) {
        Kokkos::resize(origin_, body.extent() + body.extent() / 8);
        Kokkos::resize(shift_, origin_.extent(0));
        Kokkos::deep_copy(Kokkos::subview(origin_, Kokkos::make_pair(first, static_cast<int>(origin_.extent(0)))), -1);
        if (first == body.size()) Kokkos::deep_copy(Kokkos::subview(origin_, Kokkos::make_pair(0, first)), -1);
        find(body, period, first);
      }
      copy(body, Fields<Position>{}, first);
    }
  }

  /// Copies fields of the origins to the ghosts.
  template <class Body, class... Fs>
  void refresh(Body& body, [[maybe_unused]] Fields<Fs...> fields) const {
    if constexpr (sizeof...(Fs) > 0)
      if (body.ghosts() > 0) copy(body, fields, body.size());
  }

 private:
  using real = typename P::real;

  template <class Body, class F>
  static Column<P, F> column(Body& body, F field) {
    return body.select(Fields<F>{})[field];
  }
  template <class Body>
  int find(Body& body, Period const& period, int first) const {
    int images = 0;
    Kokkos::parallel_scan("scree::find_images", Kokkos::RangePolicy<typename P::space>(0, first),
                          detail::FindImages<P>{column(body, position), period, real(reach_), first, origin_, shift_},
                          images);
    return images;
  }
  template <class Body, class... Fs>
  void copy(Body& body, Fields<Fs...> fields, int first) const {
    Kokkos::parallel_for("scree::refresh_images", Kokkos::RangePolicy<typename P::space>(first, body.extent()),
                         detail::CopyToImages<P, Fs...>{body.select(fields), origin_, shift_});
  }
  template <class Body, class... Others>
  void wrap_with(Body& body, Fields<Position, Others...> fields) const {
    for (Period const& period : periods_)
      Kokkos::parallel_for("scree::wrap", Kokkos::RangePolicy<typename P::space>(0, body.size()),
                           detail::Wrap<P, Others...>{body.select(fields), period.axis, real(period.low),
                                                      real(period.high - period.low)});
  }

  std::vector<Period> periods_;
  double reach_;
  Kokkos::View<int*, memory_of<P>> origin_;
  Kokkos::View<Vec<P::dim, real>*, memory_of<P>> shift_;
};

}  // namespace scree
