// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

// Neighbour search written by hand for one case, without scree.
namespace by_hand {

using Space = Kokkos::DefaultExecutionSpace;
template <class T>
using Array = Kokkos::View<T, Space::memory_space>;

/// Four numbers that are loaded at once: 16 bytes in single, 32 in double precision.
template <class Real>
struct alignas(4 * sizeof(Real)) Quad {
  Real v[4];
};

/// Points in the order of their cells. The domain is known: a cube from zero to `length`, rounded to whole cells.
template <int Dim, class Real>
struct Cells {
  Real inverse_edge;
  int per_axis;
  Array<int*> start, next, order;
  Array<Quad<Real>*> sorted;  // positions, in the order of cells

  Cells(int points, Real length, Real cell_edge)
      : inverse_edge(1 / cell_edge), per_axis(static_cast<int>(length / cell_edge) + 3) {
    int all = 1;
    for (int axis = 0; axis < Dim; ++axis) all *= per_axis;
    start = Array<int*>("by_hand::start", all + 1);
    next = Array<int*>("by_hand::next", all);
    order = Array<int*>("by_hand::order", points);
    sorted = Array<Quad<Real>*>("by_hand::sorted", points);
  }

  // One row of cells stays empty all around, so that a walk around a cell needs no check.
  KOKKOS_INLINE_FUNCTION int coordinate(Real x) const { return static_cast<int>(x * inverse_edge + 1); }
  KOKKOS_INLINE_FUNCTION int cell(Quad<Real> const& x) const {
    int result = 0;
    for (int axis = Dim - 1; axis >= 0; --axis) result = result * per_axis + coordinate(x.v[axis]);
    return result;
  }
  /// Calls f(k) for all indices k in the sorted order whose points are in the cell of x or next to it.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_near(Quad<Real> const& x, F const& f) const {
    int const centre = cell(x), layers = Dim == 3 ? 1 : 0;
    for (int z = -layers; z <= layers; ++z)
      for (int y = -1; y <= 1; ++y) {
        int const row = centre + (z * per_axis + y) * per_axis, end = start(row + 2);
        for (int k = start(row - 1); k < end; ++k) f(k);
      }
  }
};

/// A plain counting sort. Atomic counters alone leave the order within a cell undefined.
template <int Dim, class Real>
void sort(Cells<Dim, Real> const& cells, Array<Quad<Real>*> const& x) {
  int const n = static_cast<int>(x.extent(0));
  auto const start = cells.start, next = cells.next;
  Kokkos::deep_copy(Space(), start, 0);
  Kokkos::parallel_for(
      "by_hand::count", Kokkos::RangePolicy<Space>(0, n),
      KOKKOS_LAMBDA(int i) { Kokkos::atomic_inc(&start(cells.cell(x(i)) + 1)); });
  Kokkos::parallel_scan(
      "by_hand::start", Kokkos::RangePolicy<Space>(0, static_cast<int>(next.extent(0))),
      KOKKOS_LAMBDA(int c, int& sum, bool last) {
        if (last) next(c) = sum;
        sum += start(c + 1);
        if (last) start(c + 1) = sum;
      });
  Kokkos::parallel_for(
      "by_hand::place", Kokkos::RangePolicy<Space>(0, n), KOKKOS_LAMBDA(int i) {
        int const k = Kokkos::atomic_fetch_add(&next(cells.cell(x(i))), 1);
        cells.order(k) = i;
        cells.sorted(k) = x(i);
      });
}

}  // namespace by_hand
