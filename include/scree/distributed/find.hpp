// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/columns.hpp"
#include "../fields/standard.hpp"
#include "partition.hpp"

// Loops that find the particles of a part and those that it needs, for running_sum().
namespace scree::detail {

/// Numbers the particles that belong to a part; for a Plan, or alone.
template <class P>
struct FindOwnedBy {
  Column<P, Position> x;
  Span<typename Partition<P::dim>::Plane const> planes;
  int part;
  int first;
  Span<int> numbers;
  int from = 0;  // particle with which the loop begins

  SCREE_FN void operator()(int k, int& count, bool last) const {
    int const j = from + k;
    if (Partition<P::dim>::owner_of(planes, value_of(x(j))) != part) return;
    if (last && first + count < numbers.size()) numbers(first + count) = j;
    ++count;
  }
};

/// Numbers all particles but those from one up to another that do not belong to a part.
template <class P>
struct FindStaying {
  Column<P, Position> x;
  Span<typename Partition<P::dim>::Plane const> planes;
  int part, from, to;
  Span<int> numbers;

  SCREE_FN void operator()(int j, int& count, bool last) const {
    if (j >= from && j < to && Partition<P::dim>::owner_of(planes, value_of(x(j))) != part) return;
    if (last) numbers(count) = j;
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

}  // namespace scree::detail
