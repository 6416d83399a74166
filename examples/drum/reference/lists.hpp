// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "state.hpp"

#include <algorithm>
#include <cmath>
#include <string>

// Neighbours of grains. These are sorted by kind, replica and cell; each kind of grains has cells of its size.
namespace grains {

namespace detail {

/// Cells of one kind of grains, the same for each replica.
struct Cells {
  int first = 0;  ///< number of the first one
  int across = 0, along = 0;
  int far = 1;  ///< cells that a larger grain of any kind reaches
  float size = 0;
  float radius = 0;  ///< of the grains
};

struct Geometry {
  Kokkos::Array<Cells, max_kinds> cells;
  Kokkos::Array<int, max_kinds + 1> first;
  Units units;
  float range;
  float glued_from;  // least distance of a glued grain from the axis
  int kinds, first_glued;

  KOKKOS_FUNCTION int kind_of(int i) const {
    int kind = 0;
    while (kind + 1 < kinds && i >= first[kind + 1]) ++kind;
    return kind;
  }
  KOKKOS_FUNCTION int across(std::int32_t x, Cells const& c) const {
    int const k = int((units.xz * float(x) + range) / c.size);
    return k < 0 ? 0 : k >= c.across ? c.across - 1 : k;
  }
  KOKKOS_FUNCTION static int along(std::int32_t y, Cells const& c) {
    return int(std::uint64_t(std::uint32_t(y)) * std::uint64_t(c.along) >> 32);
  }
  KOKKOS_FUNCTION static int number(Cells const& c, int replica, int x, int y, int z) {
    return c.first + ((replica * c.across + z) * c.across + x) * c.along + y;
  }
};

/// Writes the neighbours of one grain in their new order, with the springs of contacts that it had.
struct ListNeighbours {
  State old, sorted;
  Column<int> order, inverse, start;
  Geometry geometry;
  float skin;

  KOKKOS_FUNCTION void operator()(int i, int& most) const {
    Place const p = sorted.place(i);
    int const replica = sorted.replica(i);
    float const from_axis = geometry.units.xz * Kokkos::hypot(float(p.x), float(p.z));
    int n = 0, touching_now = 0, apart = max_slots;  // those that touch come first, the others from the end
    for (int kind = 0; kind < geometry.kinds; ++kind) {
      Cells const& c = geometry.cells[kind];
      if (geometry.first[kind] == geometry.first[kind + 1]) continue;
      float const reach = p.radius + sorted.place(geometry.first[kind]).radius + skin;
      if (kind >= geometry.first_glued && from_axis + reach < geometry.glued_from) continue;
      int const far = p.radius > c.radius ? c.far : 1;
      int const x = geometry.across(p.x, c), y = Geometry::along(p.y, c), z = geometry.across(p.z, c);
      for (int cz = Kokkos::max(0, z - far); cz <= Kokkos::min(c.across - 1, z + far); ++cz) {
        for (int cx = Kokkos::max(0, x - far); cx <= Kokkos::min(c.across - 1, x + far); ++cx) {
          for (int dy = -far; dy <= far; ++dy) {
            int const cell = Geometry::number(c, replica, cx, (y + dy + c.along) % c.along, cz);
            for (int j = start(cell); j < start(cell + 1); ++j) {
              Vector const d = difference(p, sorted.place(j), geometry.units);
              if (j == i || dot(d, d) >= reach * reach) continue;
              if (++n > max_slots) continue;
              bool const touches = dot(d, d) < (reach - skin) * (reach - skin);
              sorted.neighbour(i, touches ? touching_now++ : --apart) = j;
            }
          }
        }
      }
    }
    if (n > most) most = n;
    n = Kokkos::min(n, int(max_slots));
    int const gap = apart - touching_now, moves = Kokkos::min(gap, max_slots - apart);
    for (int k = 0; k < moves; ++k) sorted.neighbour(i, touching_now + k) = sorted.neighbour(i, max_slots - 1 - k);
    sorted.count(i) = n;
    int const before = order(i);
    std::uint64_t touching = old.touching(before) & wall_bit;
    for (std::uint64_t left = old.touching(before) & ~wall_bit; left != 0; left &= left - 1) {
      int const slot = Kokkos::Experimental::countr_zero_builtin(static_cast<unsigned long long>(left));
      int const j = inverse(old.neighbour(before, slot));
      for (int s = 0; s < n; ++s) {
        if (sorted.neighbour(i, s) != j) continue;
        sorted.spring(i, s) = old.spring(before, slot);
        touching |= std::uint64_t(1) << s;
        break;
      }
    }
    sorted.touching(i) = touching;
  }
};

}  // namespace detail

class Lists {
 public:
  Lists() = default;
  /// `first`: the first grain of each kind, and their number. `glued_from`: least distance of a glued grain from the
  /// axis.
  Lists(Settings const& o, std::array<int, max_kinds + 1> const& first, Units const& units, double glued_from)
      : skin_(float(o.skin)), size_(first[o.kinds.size()]) {
    geometry_ = detail::Geometry{.cells = {},
                                 .first = {},
                                 .units = units,
                                 .range = float(o.range),
                                 .glued_from = float(glued_from),
                                 .kinds = int(o.kinds.size()),
                                 .first_glued = 0};
    for (int k = 0; k <= max_kinds; ++k) geometry_.first[k] = first[k];
    for (int k = 0; k < geometry_.kinds; ++k)
      if (!o.kinds[k].glued) mobile_ = first[k + 1], geometry_.first_glued = k + 1;
    make_cells(o);
    listed = Column<Place>("listed", size_);
    key_ = Column<int>("key", size_), rank_ = Column<int>("rank", size_);
    order_ = Column<int>("order", size_), inverse_ = Column<int>("inverse", size_);
  }

  /// Writes the grains of one state to another one, sorted, with new lists of neighbours; contacts keep their springs.
  void rebuild(State const& old, State const& sorted) {
    sort(old, sorted);
    detail::ListNeighbours const list{.old = old,
                                      .sorted = sorted,
                                      .order = order_,
                                      .inverse = inverse_,
                                      .start = start_,
                                      .geometry = geometry_,
                                      .skin = skin_};
    int most = 0;
    Kokkos::parallel_reduce("list_neighbours", Kokkos::RangePolicy<Space>(0, mobile_), list, Kokkos::Max<int>(most));
    if (most > max_slots)
      throw std::runtime_error("a grain has " + std::to_string(most) + " neighbours, more than " +
                               std::to_string(max_slots) + ": take a thinner skin");
  }

  void sort(State const& old, State const& sorted) {
    auto const geometry = geometry_;
    auto const key = key_, rank = rank_, order = order_, inverse = inverse_, start = start_;
    Kokkos::deep_copy(Space(), start, 0);
    Kokkos::RangePolicy<Space> const all(0, size_);
    Kokkos::parallel_for(
        "count", all, KOKKOS_LAMBDA(int i) {
          Place const p = old.place(i);
          detail::Cells const& c = geometry.cells[geometry.kind_of(i)];
          key(i) = detail::Geometry::number(c, old.replica(i), geometry.across(p.x, c), detail::Geometry::along(p.y, c),
                                            geometry.across(p.z, c));
          rank(i) = Kokkos::atomic_fetch_add(&start(key(i)), 1);
        });
    Kokkos::parallel_scan(
        "start", Kokkos::RangePolicy<Space>(0, cell_count_ + 1), KOKKOS_LAMBDA(int c, int& sum, bool last) {
          int const count = start(c);
          if (last) start(c) = sum;
          sum += count;
        });
    Kokkos::parallel_for(
        "fill", all, KOKKOS_LAMBDA(int i) { order(start(key(i)) + rank(i)) = i; });
    Kokkos::parallel_for(
        "sort_cells", Kokkos::RangePolicy<Space>(0, cell_count_), KOKKOS_LAMBDA(int c) {
          for (int k = start(c) + 1; k < start(c + 1); ++k) {
            int const moving = order(k);
            int at = k;
            for (; at > start(c) && order(at - 1) > moving; --at) order(at) = order(at - 1);
            order(at) = moving;
          }
        });
    auto const places = listed;
    Kokkos::parallel_for(
        "permute", all, KOKKOS_LAMBDA(int i) {
          int const from = order(i);
          inverse(from) = i;
          sorted.place(i) = places(i) = old.place(from);
          sorted.velocity(i) = old.velocity(from), sorted.spin(i) = old.spin(from);
          sorted.replica(i) = old.replica(from), sorted.identity(i) = old.identity(from);
          sorted.start_x(i) = old.start_x(from), sorted.start_z(i) = old.start_z(from);
          sorted.wall_spring(i) = old.wall_spring(from);
        });
  }

  Column<Place> listed;  ///< places at the last rebuild

 private:
  void make_cells(Settings const& o) {
    double largest = 0;
    for (auto const& kind : o.kinds) largest = std::max(largest, kind.radius);
    long total = 0;
    for (int kind = 0; kind < geometry_.kinds; ++kind) {
      double const size = 2 * o.kinds[kind].radius + o.skin, reach = o.kinds[kind].radius + largest + o.skin;
      int const along = int(o.length / size);
      if (!(o.kinds[kind].radius > 0)) throw std::runtime_error("the radius of each kind of grains must be positive");
      // A grain that is no larger reaches the next cell, and no farther.
      int const far = int(std::ceil(reach / size));
      if (along < 2 * far + 1)
        throw std::runtime_error("the period of the drum must hold " + std::to_string(2 * far + 1) +
                                 " cells of a diameter and a skin, " + std::to_string(size) + " m, of each kind");
      geometry_.cells[kind] = {int(total),  int(std::ceil(2 * o.range / size)), along, far,
                               float(size), float(o.kinds[kind].radius)};
      total += long(o.replicas) * geometry_.cells[kind].across * geometry_.cells[kind].across * along;
    }
    if (total > 2000000000) throw std::runtime_error("the range is too large for grains of this size");
    cell_count_ = int(total);
    start_ = Column<int>("start", cell_count_ + 1);
  }

  detail::Geometry geometry_ = {};
  float skin_ = 0;
  int size_ = 0, mobile_ = 0, cell_count_ = 0;
  Column<int> key_, rank_, order_, inverse_, start_;
};

}  // namespace grains
