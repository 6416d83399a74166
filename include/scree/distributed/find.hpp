// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/columns.hpp"
#include "../fields/standard.hpp"
#include "../system/periodic.hpp"
#include "partition.hpp"

#include <cstddef>
#include <vector>

// Functors for running_sum() that find the particles of a rank and the particles that the rank needs.
namespace scree::detail {

/// Lists the particles that belong to a rank, for a Plan.
template <class P>
struct FindOwnedBy {
  Column<P, Position> x;
  Span<typename Partition<P::dim>::Plane const> planes;
  int rank;
  int first;
  Span<int> numbers;
  int from = 0;  // the first particle of the loop

  SCREE_FN void operator()(int k, int& count, bool last) const {
    int const j = from + k;
    if (Partition<P::dim>::owner_of(planes, value_of(x(j))) != rank) return;
    if (last && first + count < numbers.size()) numbers(first + count) = j;
    ++count;
  }
};

/// Lists the particles that stay on a rank: all except the particles in [from, to) that belong to other ranks.
template <class P>
struct FindStaying {
  Column<P, Position> x;
  Span<typename Partition<P::dim>::Plane const> planes;
  int rank, from, to;
  Span<int> numbers;

  SCREE_FN void operator()(int j, int& count, bool last) const {
    if (j >= from && j < to && Partition<P::dim>::owner_of(planes, value_of(x(j))) != rank) return;
    if (last) numbers(count) = j;
    ++count;
  }
};

/// Lists the particles, and periodic images of particles, that lie within a box.
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

/// Finds the particles of this rank, and their periodic images, that another rank needs. These lie within the reach of
/// the neighbour lists of the bounding box of the other rank's particles.
template <class P>
class Needed {
 public:
  using vector = Vec<P::dim, typename P::real>;
  /// Takes the periods of the domain and the reach (m).
  Needed(std::vector<Period> const& periods, double reach) : reach_(reach), shifts_{zero<vector>()} {
    for (Period const& period : periods)
      for (std::size_t k = 0, count = shifts_.size(); k < count; ++k)
        for (int sign : {1, -1}) {
          vector shift = shifts_[k];
          shift[period.axis] += typename P::real(sign) * (typename P::real(period.high) - typename P::real(period.low));
          shifts_.push_back(shift);
        }
  }
  double reach() const { return reach_; }
  /// Returns the functor that finds the needed particles, given the bounding boxes of the particles on the other rank
  /// (`there`) and on this rank (`here`). `itself`: whether the two ranks are the same.
  template <class Box>
  FindInBox<P> loop(Box const& there, Box const& here, bool itself) const {
    using real = typename P::real;
    FindInBox<P> find;
    auto const& [low, high] = there;
    for (int axis = 0; axis < P::dim; ++axis) {
      find.low[axis] = real(low[axis] - reach_);
      find.high[axis] = real(high[axis] + reach_);
    }
    for (auto const& shift : shifts_) {
      if (itself && &shift == shifts_.data()) continue;  // a particle is not its own ghost
      bool near = true;
      for (int axis = 0; axis < P::dim; ++axis)
        near = near && here.high[axis] + double(shift[axis]) >= low[axis] - 2 * reach_ &&
               here.low[axis] + double(shift[axis]) <= high[axis] + 2 * reach_;
      if (near) find.shifts[find.shift_count++] = shift;
    }
    return find;
  }

 private:
  double reach_;
  std::vector<vector> shifts_;  // the first one is zero
};

}  // namespace scree::detail
