// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "spots.hpp"
#include "start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// The checks of check_start() and packing_of() in the execution space that has the particles.
namespace scree::detail {

/// A reduction that writes the packing around all particles of the material to arrays. Values that do not belong to a
/// median are infinite.
struct LookAtSpots {
  struct value_type {
    std::int64_t wrong;                // of a particle with a fault: lowest number in its cell * 2^32 + its own number
    int looked_at, alone, last_alone;  // `alone`: those without a neighbour within 1.5 spacings
    int full, at_walls, facing, facing_little;
  };
  static constexpr std::int64_t none = Kokkos::Experimental::finite_max_v<std::int64_t>;

  SpotsView cells;
  PackingKernel kernel;
  double spacing;
  int owned, first_wall;
  bool stops_at_faults;
  Span<char const> counted;  // empty: all
  Span<double> nearest, volume, density, by_number, walls;

  SCREE_FN void init(value_type& found) const {
    found.wrong = none;
    found.looked_at = found.alone = found.full = found.at_walls = found.facing = found.facing_little = 0;
    found.last_alone = -1;
  }
  SCREE_FN void join(value_type& found, value_type const& other) const {
    found.wrong = Kokkos::min(found.wrong, other.wrong);
    found.looked_at += other.looked_at, found.alone += other.alone;
    found.full += other.full, found.at_walls += other.at_walls;
    found.facing += other.facing, found.facing_little += other.facing_little;
    found.last_alone = Kokkos::max(found.last_alone, other.last_alone);
  }
  SCREE_FN void operator()(int k, value_type& found) const {
    int const i = cells.numbers(k);
    if (i >= owned) return;
    nearest(i) = volume(i) = density(i) = by_number(i) = walls(i) = Kokkos::Experimental::infinity_v<double>;
    if (counted.size() > 0 && counted(i) == 0) return;
    Spot const here = cells.sorted(k);
    Crowding const at = crowding(i, here);
    ++found.looked_at;
    if (at.nearest > 1.5 * spacing) ++found.alone, found.last_alone = Kokkos::max(found.last_alone, i);
    if (at.is_wrong(spacing))
      found.wrong = Kokkos::min(found.wrong, (std::int64_t(cells.first_of_cell(here.x)) << 32) + i);
    nearest(i) = at.nearest / spacing, volume(i) = at.volume;
    if (at.is_full) ++found.full, density(i) = at.density, by_number(i) = at.by_number;
    if (at.judges_walls) ++found.at_walls, walls(i) = at.walls;
    found.facing += at.faces_walls, found.facing_little += at.faces_too_little();
  }

 private:
  SCREE_FN Crowding crowding(int i, Spot const& here) const {
    CrowdingSum sum(kernel, here.volume);
    cells.for_each_near(here.x, [&](int j, Spot const& spot, double x, double y, double z, double squared) {
      if (j == i && squared == 0) return true;  // itself, not its images
      sum.add(x, y, z, squared, spot.volume, j >= first_wall, std::size_t(j));
      return !(stops_at_faults && sum.is_too_dense());
    });
    return sum.result();
  }
};

/// Computes StartLook::fill_of_wall() for some particles of walls.
struct FillsOfWalls {
  SpotsView cells;
  PackingKernel kernel;
  Span<Spot const> spots;
  int first_wall, walls, some;
  Span<double> fills;
  SCREE_FN void operator()(int k) const {
    int const i = first_wall + int(std::int64_t(k) * walls / some);
    Spot const here = spots(i);
    double least = kernel.support() * kernel.support();
    cells.for_each_near(here.x, [&](int j, Spot const&, double, double, double, double squared) {
      if (j >= first_wall && (j != i || squared > 0)) least = Kokkos::min(least, squared);
      return true;
    });
    fills(k) = here.volume / kernel.volume(Kokkos::sqrt(least));
  }
};

/// Writes, in ascending order, the numbers of the spots that are within 1.01 cell widths of a point along each axis, or
/// have a periodic image there.
struct NumbersNear {
  SpotsView cells;
  Span<Spot const> spots;
  Spot place;
  Span<int> near;
  SCREE_FN void operator()(int i, int& count, bool last) const {
    bool is_near = false;
    for (int image = 0; image < cells.images && !is_near; ++image) is_near = this->is_near(i, image);
    if (!is_near) return;
    if (last) near(count) = i;
    ++count;
  }

 private:
  SCREE_FN bool is_near(int i, int image) const {
    double const reach = 1.01 * cells.buckets.width;
    double shift[3] = {};
    cells.find_shift(image, shift);
    bool found = true;
    for (int axis = 0; axis < 3; ++axis)
      found = found && Kokkos::abs(spots(i).x[axis] + shift[axis] - place.x[axis]) < reach;
    return found;
  }
};

/// Counts the values that are at most `bar`.
struct CountUpTo {
  using value_type = int;
  Span<double const> values;
  double bar;
  SCREE_FN void init(int& count) const { count = 0; }
  SCREE_FN void join(int& count, int const& other) const { count += other; }
  SCREE_FN void operator()(int i, int& count) const { count += values(i) <= bar ? 1 : 0; }
};

/// The smallest and the largest coordinate of spots along a direction, times the length of its vector.
struct ExtentAlong {
  struct value_type {
    double low, high;
  };
  Span<Spot const> spots;
  double x, y, z;
  SCREE_FN void init(value_type& extent) const {
    extent.low = Kokkos::Experimental::infinity_v<double>, extent.high = -extent.low;
  }
  SCREE_FN void join(value_type& extent, value_type const& other) const {
    extent.low = Kokkos::min(extent.low, other.low), extent.high = Kokkos::max(extent.high, other.high);
  }
  SCREE_FN void operator()(int i, value_type& extent) const {
    double const along = x * spots(i).x[0] + y * spots(i).x[1] + z * spots(i).x[2];
    extent.low = Kokkos::min(extent.low, along), extent.high = Kokkos::max(extent.high, along);
  }
};

/// Checks of the positions of spots. The results are those of check_start() and packing_of() on the host, apart from
/// the rounding of sums, and a refusal has the same message.
template <class Space>
class StartIn {
 public:
  /// Sorts the spots, which must outlive this object.
  StartIn(Spots<Space> const& spots, double spacing, int dimensions, std::vector<Period> const& periods)
      : spots_(spots),
        spacing_(spacing),
        kernel_(spacing, dimensions),
        periods_(periods),
        cells_(spots, kernel_.support(), dimensions, periods) {}
  /// Whether the device can check the particles, because no bucket has too many of them. Otherwise the host must check
  /// them.
  bool can_look() const { return cells_.is_complete(); }
  /// The memory for each particle, bytes.
  static constexpr double bytes = sizeof(Spot) + SpotsInCells<Space>::bytes + 5 * sizeof(double);

  void check_start(StartWords const& words = {}) {
    StartFaults const faults{spacing_, kernel_.dimensions, words};
    auto const found = look(spots_.owned, true, {});
    if (found.wrong != LookAtSpots::none) refuse(faults, int(found.wrong & 0xffffffff));
    if (faults.refuses_alone(found.alone, spots_.owned))
      faults.refuse_alone({std::size_t(found.last_alone), place_of(found.last_alone)}, found.alone, spots_.owned);
    if (!faults.judges_packing()) return;
    Packing packing = medians(found);
    if (found.at_walls + found.facing > 0) packing.fill_of_walls = median_fill_of_walls();
    faults.check(packing);
  }
  /// Returns the medians over the material, or over its particles with a nonzero entry in `counted`.
  Packing packing(ArrayIn<char, Space> const& counted = {}) { return medians(look(spots_.all.size(), false, counted)); }
  /// Returns the extent of the material along a direction, m; 0 if the direction is a zero vector.
  double extent_along(std::array<double, 3> const& direction) const {
    auto const found = reduce(space(), "scree::extent", spots_.owned,
                              ExtentAlong{spots_.all, direction[0], direction[1], direction[2]});
    double const length = std::hypot(direction[0], direction[1], direction[2]);
    return length > 0 && found.low <= found.high ? (found.high - found.low) / length : 0;
  }

 private:
  using Found = LookAtSpots::value_type;
  using Numbers = ArrayIn<double, Space>;

  Space const& space() const { return spots_.space(); }
  Found look(int first_wall, bool stops_at_faults, ArrayIn<char, Space> const& counted) {
    for (Numbers* const each : {&nearest_, &volume_, &density_, &by_number_, &walls_})
      *each = {space(), "scree::packing", std::size_t(spots_.owned)};
    return reduce(space(), "scree::packing", spots_.all.size(),
                  LookAtSpots{cells_.view(), kernel_, spacing_, spots_.owned, first_wall, stops_at_faults, counted,
                              nearest_, volume_, density_, by_number_, walls_});
  }
  double quantile_of(Numbers const& values, int members, int twentieths = 10) const {
    return quantile(
        [&](double bar) {
          return long(reduce(space(), "scree::quantile", values.size(), CountUpTo{values, bar}));
        },
        members, twentieths);
  }
  Packing medians(Found const& found) const {
    Packing packing;
    packing.particles = found.looked_at, packing.full = found.full, packing.at_walls = found.at_walls;
    packing.facing = found.facing, packing.facing_little = found.facing_little;
    if (found.looked_at > 0)
      packing.nearest = quantile_of(nearest_, found.looked_at), packing.volume = quantile_of(volume_, found.looked_at);
    if (found.full > 0) {
      packing.density = quantile_of(density_, found.full), packing.by_number = quantile_of(by_number_, found.full);
      packing.loose = quantile_of(density_, found.full, 1), packing.dense = quantile_of(density_, found.full, 19);
    }
    if (found.at_walls > 0) packing.walls = quantile_of(walls_, found.at_walls);
    return packing;
  }
  double median_fill_of_walls() const {
    int const walls = spots_.all.size() - spots_.owned, some = std::min(walls, int(walls_looked_at));
    Numbers const fills(space(), "scree::fills_of_walls", std::size_t(some));
    for_each_index(space(), "scree::fills_of_walls", 0, some,
                   FillsOfWalls{cells_.view(), kernel_, spots_.all, spots_.owned, walls, some, fills});
    return quantile_of(fills, some);
  }
  PointsInCells::Point place_of(int i) const {
    auto const spot = scree::values_of(spots_.all.part(i, i + 1));
    return {spot[0].x[0], spot[0].x[1], spot[0].x[2]};
  }
  /// Copies the surroundings of a particle to the host, which checks them and refuses the start.
  [[noreturn, gnu::cold]] void refuse(StartFaults const& faults, int wrong) const {
    ArrayIn<int, Space> const all(space(), "scree::near", std::size_t(spots_.all.size()));
    NumbersNear const near{cells_.view(), spots_.all, scree::values_of(spots_.all.part(wrong, wrong + 1))[0], all};
    auto const numbers = all.part(0, running_sum(space(), "scree::near", spots_.all.size(), near));
    ArrayIn<Spot, Space> const picked(space(), "scree::near", std::size_t(numbers.size()));
    for_each_index(space(), "scree::near", 0, numbers.size(), PickSpots{spots_.all, numbers, picked});
    PlacedParticles placed;
    std::size_t first_wall = 0, i = 0;
    for (auto const& spot : scree::values_of(picked))
      placed.places.push_back({spot.x[0], spot.x[1], spot.x[2]}), placed.volumes.push_back(spot.volume);
    for (int const number : scree::values_of(numbers)) {
      bool const is_wall = number >= spots_.owned;
      if (number < wrong) ++i;
      if (!is_wall) ++first_wall;
      placed.numbers.push_back(is_wall ? number - spots_.owned : number);
    }
    auto const at = crowding_at(placed, i, first_wall, spacing_, kernel_.dimensions, periods_);
    faults.refuse({std::size_t(wrong), placed.places[i]}, at, std::size_t(placed.numbers[at.neighbour]),
                  at.neighbour >= first_wall);
  }

  Spots<Space> const& spots_;
  double spacing_;
  PackingKernel kernel_;
  std::vector<Period> periods_;
  SpotsInCells<Space> cells_;
  Numbers nearest_, volume_, density_, by_number_, walls_;
};

}  // namespace scree::detail

#ifdef SCREE_COMPILED
SCREE_INSTANCE class scree::detail::StartIn<Kokkos::DefaultExecutionSpace>;
#endif
