// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/available_memory.hpp"
#include "../passes/sums.hpp"
#include "kinds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

// The content of each cell of a grid: the samples of a mixture. Cells without particles take no memory, so particles
// far away from the others cost nothing extra.
namespace scree {

/// A sample: the content of one cell of a grid.
template <int Dim, int Kinds>
struct MixtureSample {
  Vec<Dim, double> centre = zero<Vec<Dim, double>>();      ///< centre of the cell, m
  double volume = 0;                                       ///< volume of its particles, m^dim
  Vec<Kinds, double> shares = zero<Vec<Kinds, double>>();  ///< share of each kind in this volume
};

namespace detail {

/// The key of a cell, made of its indices along the axes, up to a million cells on both sides of the origin. All cells
/// farther away are treated as the outermost cell.
template <int Dim>
struct CellKey {
  static constexpr int bits = 21;
  static constexpr std::int64_t half = std::int64_t(1) << (bits - 1), none = -1;
  double edge;  // m

  template <class X>
  SCREE_FN std::int64_t of(X const& x) const {
    std::int64_t key = 0;
    for (int axis = Dim - 1; axis >= 0; --axis) {
      double const place = Kokkos::floor(double(x[axis]) / edge) + double(half);
      auto const number = std::int64_t(Kokkos::fmax(0.0, Kokkos::fmin(place, double(2 * half - 1))));
      key = (key << bits) | number;
    }
    return key;
  }
  Vec<Dim, double> centre(std::int64_t key) const {
    Vec<Dim, double> x;
    for (int axis = 0; axis < Dim; ++axis, key >>= bits) x[axis] = (double((key & (2 * half - 1)) - half) + 0.5) * edge;
    return x;
  }
};

/// A kernel that adds the terms of each particle to the sums of its cell in a hash table. The search for the entry of a
/// cell begins at the hash of its key and ends at the first entry that is free or has this key. The index of the entry
/// depends on the order of the threads; its content does not.
template <class P, class Function>
struct SumInCells {
  static constexpr int most_tries = 64;
  Function function;
  Columns<P, Merge<Fields<Position>, reads_of<Function>>> reads;
  CellKey<P::dim> cell;
  FixedPoint unit;
  Span<std::int64_t> keys, sums;
  Span<int> failures;  // one number

  SCREE_FN void operator()(int i) const {
    auto const particle = reads.load(i);
    int const entry = place(cell.of(particle[fields::position]));
    if (entry < 0) return Kokkos::atomic_inc(&failures(0));
    Vec<Function::count, double> const terms = function(particle);
    for (int k = 0; k < Function::count; ++k)
      Kokkos::atomic_add(&sums(entry * Function::count + k), unit.whole(terms[k]));
  }

 private:
  SCREE_FN int place(std::int64_t key) const {
    auto mixed = std::uint64_t(key) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio: neighbours lie far apart
    mixed ^= mixed >> 32;
    int k = int(mixed % std::uint64_t(keys.size()));
    for (int tries = 0; tries < most_tries; ++tries) {
      std::int64_t const there = Kokkos::atomic_compare_exchange(&keys(k), std::int64_t(-1), key);
      if (there == -1 || there == key) return k;
      k = k + 1 < keys.size() ? k + 1 : 0;
    }
    return -1;
  }
};

struct SetNone {
  Span<std::int64_t> keys;
  SCREE_FN void operator()(int k) const { keys(k) = -1; }
};

/// The content of a cell: its key, and the sums of the terms of its particles in fixed-point units.
template <int Count>
struct CellEntry {
  std::int64_t key;
  std::array<std::int64_t, std::size_t(Count)> sums;
};

/// Returns the cells that contain particles of this rank, in any order. Unless the edge is near the spacing, many
/// particles share a cell, so the table begins small and doubles until each cell has an entry.
template <class P, class Body, class Function>
std::vector<CellEntry<Function::count>> cells_here(Body const& body, Function const& function,
                                                   CellKey<P::dim> const& cell, FixedPoint const& unit) {
  constexpr int count = Function::count;
  auto const& space = body.space();
  auto const reads = body.select(Merge<Fields<Position>, reads_of<Function>>{});
  for (std::size_t entries = std::size_t(body.size()) / 8 + 1024;; entries *= 2) {
    checked_count(entries * std::size_t(count));
    Array<P, std::int64_t> const keys(space, "scree::cells_of_samples", entries);
    Array<P, std::int64_t> const sums(space, "scree::samples", entries * std::size_t(count));
    Array<P, int> const failures(space, "scree::samples_without_place", 1);
    for_each_index(space, "scree::cells_of_samples", 0, keys.size(), SetNone{keys});
    for_each_index(space, "scree::samples", 0, body.size(),
                   SumInCells<P, Function>{function, reads, cell, unit, keys, sums, failures});
    if (scree::values_of(failures)[0] > 0) continue;
    std::vector<CellEntry<count>> found;
    auto const all_keys = scree::values_of(keys), all_sums = scree::values_of(sums);
    for (std::size_t k = 0; k < all_keys.size(); ++k) {
      if (all_keys[k] < 0) continue;
      CellEntry<count> entry{all_keys[k], {}};
      std::copy_n(all_sums.begin() + std::ptrdiff_t(k) * count, count, entry.sums.begin());
      found.push_back(entry);
    }
    return found;
  }
}

}  // namespace detail

/// Returns the content of the cells of a grid for the material of a solver: all cells that contain particles, in the
/// order of their keys. The cells have edges of `edge` (m) and corners at multiples of `edge`. A particle belongs to
/// the cell of its centre. The result is bitwise identical on any number of ranks (WholeBody). Throws
/// std::invalid_argument if `edge` is less than the spacing, and std::runtime_error if a value is not finite.
template <class S, class Kinds>
auto samples_of(S const& solver, double edge, Kinds const& kinds) {
  using P = typename detail::material_of<S>::policy;
  using Function = detail::VolumesOfKinds<Kinds>;
  double const spacing = solver.resolution().spacing;
  check_setting(edge >= spacing && std::isfinite(edge), "the edge of the cells of samples (m)", edge,
                detail::formatted("the spacing of the particles, %g, or more", spacing).c_str());
  Function const function{kinds};
  auto const unit = detail::unit_of_terms(solver.whole(), function, "the samples of a mixture");
  detail::CellKey<P::dim> const cell{edge};
  std::map<std::int64_t, std::array<std::int64_t, std::size_t(Function::count)>> cells;
  for (auto const& here : solver.whole().all_of(detail::cells_here<P>(solver.material(), function, cell, unit))) {
    auto& sums = cells[here.key];
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += here.sums[k];
  }
  std::vector<MixtureSample<P::dim, Kinds::kinds>> samples;
  for (auto const& [key, sums] : cells) {
    MixtureSample<P::dim, Kinds::kinds> sample{.centre = cell.centre(key), .volume = unit.value(sums[0])};
    for (int k = 0; k < Kinds::kinds; ++k) sample.shares[k] = unit.value(sums[std::size_t(k) + 1]) / sample.volume;
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace scree
