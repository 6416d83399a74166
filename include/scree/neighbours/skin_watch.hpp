// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../core/loop.hpp"
#include "neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {
namespace detail {

/// Largest displacement of each of two bodies.
template <class P>
struct LargestDisplacements {
  using real = typename P::real;
  struct value_type {
    real first, second;
  };
  PositionSpan<P> first_now, first_then, second_now, second_then;
  int of_first;

  SCREE_FN void init(value_type& largest) const { largest.first = largest.second = 0; }
  SCREE_FN void join(value_type& largest, value_type const& other) const {
    largest.first = Kokkos::max(largest.first, other.first);
    largest.second = Kokkos::max(largest.second, other.second);
  }
  SCREE_FN void operator()(int i, value_type& largest) const {
    if (i < of_first)
      largest.first = Kokkos::max(largest.first, displacement(first_now(i), first_then(i)));
    else
      largest.second = Kokkos::max(largest.second, displacement(second_now(i - of_first), second_then(i - of_first)));
  }

 private:
  template <class X>
  SCREE_FN static real displacement(X const& now, X const& then) {
    return or_infinity(norm(value_of(now) - value_of(then)));
  }
};

}  // namespace detail

/// Tells when lists that hold more than the support, by a skin, have to be built anew: lists of pairs within a first
/// body and between it and a second one, which may be empty. Keeps the positions the lists are built from. Owned
/// particles are watched, ghosts move as these do.
///
/// The skin may be crossed when the displacements of two particles since the build add up to it. They are looked at as
/// often as needed to see that in time, as long as particles speed up no faster than from rest under a constant
/// acceleration since the look before the last; particles at rest are looked at after 256 updates. A look costs a
/// sweep and, on a GPU, a wait, so that lists about to end are not looked at again but built.
template <class P>
class SkinWatch {
 public:
  using vector = Vec<P::dim, typename P::real>;
  using Kept = Array<P, vector>;

  explicit SkinWatch(double skin) : skin_(skin) {}  ///< m

  /// To be asked once after each change of positions: whether lists built from the kept ones serve for these.
  bool serves(Places<P> const& first, Places<P> const& second) {
    ++updates_;
    if (builds_ == 0 || first.owned != owned_first_ || second.owned != owned_second_) return false;
    if (updates_ < next_look_) return true;
    double const crossed = crossed_since(first, second), updates = updates_until_crossed(crossed);
    last_look_ = updates_;
    crossed_before_ = crossed;
    // What is not finite must lead to a build, which reports it.
    return crossed < 1 && !(updates + 1 < double(updates_) / 16);
  }
  /// To be called when lists are to be built from these positions.
  void keep(Places<P> const& first, Places<P> const& second) {
    copy(first_, first.all);
    copy(second_, second.all);
    owned_first_ = first.owned;
    owned_second_ = second.owned;
    ++builds_;
    // Rarely is a list far shorter-lived than the one before.
    next_look_ = std::clamp(updates_ / 4, 1L, 256L);
    updates_ = last_look_ = 0;
    crossed_before_ = 0;
  }
  /// To be called if particles may have changed places in the arrays or jumped since the last update.
  void look() { next_look_ = 0; }

  Kept const& first() const { return first_; }
  Kept const& second() const { return second_; }
  long builds() const { return builds_; }

  /// All that lists and their lifetime follow from. Lists built from the present positions would have another order of
  /// neighbours, so a run that goes on from a snapshot needs this.
  struct Memory {
    std::vector<vector> first, second;
    int owned_first = 0, owned_second = 0;
    long builds = 0, updates = 0, last_look = 0, next_look = 1;
    double crossed_before = 0;
  };
  Memory memory() const {
    return {values_of(first_), values_of(second_), owned_first_, owned_second_,  builds_,
            updates_,          last_look_,         next_look_,   crossed_before_};
  }
  void restore(Memory const& memory) {
    first_ = array_of<P>(memory.first);
    second_ = array_of<P>(memory.second);
    owned_first_ = memory.owned_first;
    owned_second_ = memory.owned_second;
    builds_ = memory.builds;
    updates_ = memory.updates;
    last_look_ = memory.last_look;
    next_look_ = memory.next_look;
    crossed_before_ = memory.crossed_before;
  }

 private:
  static void copy(Kept& kept, Positions<P> const& x) {
    if (kept.size() != x.size()) kept = Kept("scree::kept_positions", static_cast<std::size_t>(x.size()));
    copy_array(kept, x);
  }

  /// The part of the skin that two particles may have crossed together.
  double crossed_since(Places<P> const& first, Places<P> const& second) const {
    auto const moved =
        reduce<typename P::space>("scree::displacement", first.owned + second.owned,
                                  detail::LargestDisplacements<P>{first.all, first_, second.all, second_, first.owned});
    return (double(moved.first) + double(std::max(moved.first, moved.second))) / skin_;
  }
  // `crossed`, which is 1 where the list ends, has grown by g over the last n updates. From rest at their beginning
  // that is (k/n)^2 g after k updates, so that it comes to 1 after k = n sqrt(1 + (1 - crossed)/g).
  double updates_until_crossed(double crossed) {
    double const n = double(updates_ - last_look_), growth = crossed - crossed_before_;
    double const updates = n * (std::sqrt(1 + (1 - crossed) / growth) - 1);
    next_look_ = updates_ + (updates >= 1 ? static_cast<long>(std::min({updates, 2 * n, 256.0})) : 1);
    return updates;
  }

  double skin_;
  Kept first_, second_;
  int owned_first_ = 0, owned_second_ = 0;
  long builds_ = 0;
  long updates_ = 0, last_look_ = 0, next_look_ = 1;  // counted from the last build
  double crossed_before_ = 0;                         // at the last look
};

}  // namespace scree
