// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cells.hpp"

// Neighbour lists written by hand: with equal capacity for each particle, or contiguous (CSR).
namespace by_hand {

/// Row i holds the neighbours of particle i: contiguous on a CPU; on a GPU the k-th neighbours of all particles are
/// contiguous.
struct PaddedList {
  Array<int*> lengths;
  Array<int**> rows;
};

/// Calls f(j, near) for all candidates j of the particle at index k of the sorted order; near: within `radius`, and not
/// the particle itself.
template <int Dim, class Real, class F>
KOKKOS_INLINE_FUNCTION void for_each_candidate(Cells<Dim, Real> const& cells, Real radius, int k, F const& f) {
  Quad<Real> const x = cells.sorted(k);
  Real const squared_radius = radius * radius;
  cells.for_each_near(x, [&](int l) {
    Quad<Real> const y = cells.sorted(l);
    Real squared = 0;
    for (int axis = 0; axis < Dim; ++axis) squared += (x.v[axis] - y.v[axis]) * (x.v[axis] - y.v[axis]);
    f(cells.order(l), (squared < squared_radius) & (l != k));
  });
}

template <int Dim, class Real>
PaddedList padded_list(Cells<Dim, Real> const& cells, Real radius, int room) {
  int const n = static_cast<int>(cells.order.extent(0));
  PaddedList const list{Array<int*>("by_hand::lengths", n),
                        Array<int**>(Kokkos::view_alloc("by_hand::rows", Kokkos::WithoutInitializing), n, room)};
  Kokkos::parallel_for(
      "by_hand::padded_list", Kokkos::RangePolicy<Space>(0, n), KOKKOS_LAMBDA(int k) {
        int const i = cells.order(k);
        int length = 0;
        for_each_candidate(cells, radius, k, [&](int j, bool near) {
          if (!near) return;
          if (length < room) list.rows(i, length) = j;
          ++length;
        });
        list.lengths(i) = length < room ? length : room;
      });
  return list;
}

/// Number of neighbours of each particle.
template <int Dim, class Real>
void count(Cells<Dim, Real> const& cells, Real radius, Array<int*> const& lengths) {
  Kokkos::parallel_for(
      "by_hand::count", Kokkos::RangePolicy<Space>(0, static_cast<int>(lengths.extent(0))), KOKKOS_LAMBDA(int k) {
        int length = 0;
        for_each_candidate(cells, radius, k, [&](int, bool near) { length += near; });
        lengths(cells.order(k)) = length;
      });
}

/// The neighbours of particle i are indices(start(i)) ... indices(start(i + 1) - 1).
struct CsrList {
  Array<int*> start, indices;
  int pairs = 0;
};

/// Counts, sums up, fills. The memory is reused by the next call.
template <int Dim, class Real>
void build(CsrList& list, Cells<Dim, Real> const& cells, Real radius) {
  int const n = static_cast<int>(cells.order.extent(0));
  if (static_cast<int>(list.start.extent(0)) != n + 1) list.start = Array<int*>("by_hand::start", n + 1);
  auto const start = list.start;
  count(cells, radius, Array<int*>(Kokkos::subview(start, Kokkos::make_pair(1, n + 1))));
  Kokkos::parallel_scan(
      "by_hand::csr_start", Kokkos::RangePolicy<Space>(0, n),
      KOKKOS_LAMBDA(int i, int& sum, bool last) {
        sum += start(i + 1);
        if (last) start(i + 1) = sum;
      },
      list.pairs);
  if (static_cast<int>(list.indices.extent(0)) < list.pairs)
    list.indices =
        Array<int*>(Kokkos::view_alloc("by_hand::indices", Kokkos::WithoutInitializing), list.pairs + list.pairs / 8);
  auto const indices = list.indices;
  Kokkos::parallel_for(
      "by_hand::csr_fill", Kokkos::RangePolicy<Space>(0, n), KOKKOS_LAMBDA(int k) {
        int next = start(cells.order(k));
        for_each_candidate(cells, radius, k, [&](int j, bool near) {
          if (near) indices(next++) = j;
        });
      });
}

}  // namespace by_hand
