// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/array.hpp"
#include "../fields/columns.hpp"
#include "../fields/standard.hpp"
#include "../neighbours/cell_list.hpp"
#include "../system/periodic.hpp"
#include "near_cells.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

// Particles of all bodies in the memory of an execution space, and a search for particles near a point, for checks of
// positions.
namespace scree::detail {

/// A particle: position (m; the third coordinate in a plane is 0) and volume (m^dim).
struct alignas(16) Spot {
  double x[3];
  double volume;
};

template <class P>
struct CopyToSpots {
  Columns<P, Fields<Position, Volume>> from;
  Span<Spot> to;
  int first;
  SCREE_FN void operator()(int i) const {
    Spot spot{};
    auto const x = from.load(fields::position, i);
    for (int axis = 0; axis < P::dim; ++axis) spot.x[axis] = double(x[axis]);
    spot.volume = double(from.load(fields::volume, i));
    to(first + i) = spot;
  }
};

/// The particles of all bodies: first those of the material, `owned` of them, then those of walls.
template <class Space>
struct Spots {
  ArrayIn<Spot, Space> all;
  int owned = 0;

  explicit Spots(Space const& space, int count) : all(space, "scree::spots", std::size_t(count)) {}
  Space const& space() const { return all.space(); }
  /// Copies the owned particles of a body to the places from `first` on.
  template <class Body>
  void copy(Body const& body, int first) const {
    using P = typename Body::policy;
    for_each_index(space(), "scree::copy_spots", 0, body.size(),
                   CopyToSpots<P>{body.select(Fields<Position, Volume>{}), all, first});
  }
};

/// The box around some spots; NaN coordinates are ignored.
struct BoxAroundSpots {
  struct value_type {
    double low[3], high[3];
  };
  Span<Spot const> spots;
  SCREE_FN void init(value_type& box) const {
    for (int axis = 0; axis < 3; ++axis)
      box.low[axis] = Kokkos::Experimental::infinity_v<double>, box.high[axis] = -box.low[axis];
  }
  SCREE_FN void join(value_type& box, value_type const& other) const {
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = Kokkos::min(box.low[axis], other.low[axis]);
      box.high[axis] = Kokkos::max(box.high[axis], other.high[axis]);
    }
  }
  SCREE_FN void operator()(int i, value_type& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      double const x = spots(i).x[axis];
      if (x < box.low[axis]) box.low[axis] = x;
      if (x > box.high[axis]) box.high[axis] = x;
    }
  }
};

/// The cells of PointsInCells, distributed over buckets by a hash; a bucket may hold several cells.
struct Buckets {
  double width;  // edge of a cell, m
  int dimensions;
  std::uint64_t mask;  // the number of buckets - 1

  struct Cell {
    std::int64_t at[3];
    SCREE_FN bool operator==(Cell const& other) const {
      return at[0] == other.at[0] && at[1] == other.at[1] && at[2] == other.at[2];
    }
  };
  SCREE_FN Cell cell_of(double const* x) const {
    return {{MaybeNear::index_of(x[0], width), MaybeNear::index_of(x[1], width), MaybeNear::index_of(x[2], width)}};
  }
  SCREE_FN int bucket_of(Cell const& cell) const {
    return int(MaybeNear::hash(cell.at[0], cell.at[1], cell.at[2]) & mask);
  }
  /// Calls visit(bucket) for the buckets of the cells around a point, once for each bucket.
  template <class Visit>
  SCREE_FN void for_each_around(double const* x, Visit const& visit) const {
    Cell const centre = cell_of(x);
    int const cells = dimensions == 2 ? 9 : 27;
    int visited[27];
    for (int k = 0; k < cells; ++k) {
      int const above = dimensions == 2 ? 0 : k / 9 - 1;
      int const bucket = bucket_of({{centre.at[0] + k % 3 - 1, centre.at[1] + k / 3 % 3 - 1, centre.at[2] + above}});
      bool is_new = true;
      for (int before = 0; before < k; ++before) is_new = is_new && visited[before] != bucket;
      visited[k] = bucket;
      if (is_new) visit(bucket);
    }
  }
};

/// Spots in the order of their buckets; within a bucket, they are in ascending order of their numbers.
struct SpotsView {
  Buckets buckets;
  Span<int const> start, numbers;
  Span<Spot const> sorted;
  BoxAroundSpots::value_type box;
  int images;  // 3 to the power of the number of periods
  int axis_of[3];
  double length_of[3];  // of periods, m

  /// Calls f(number, spot, x, y, z, squared) for each spot, including periodic images, that is nearer to a place than
  /// the width of a cell, until f returns false. (x, y, z) is the vector (m) from the spot to the place, `squared` its
  /// square.
  template <class F>
  SCREE_FN void for_each_near(double const* place, F const& f) const {
    bool goes_on = true;
    for (int image = 0; image < images && goes_on; ++image) {
      double shift[3] = {}, x[3] = {};
      find_shift(image, shift);
      bool is_near = true;
      for (int axis = 0; axis < 3; ++axis) {
        x[axis] = place[axis] - shift[axis];
        is_near = is_near && !(x[axis] < box.low[axis] - buckets.width || x[axis] > box.high[axis] + buckets.width);
      }
      if (!is_near) continue;
      buckets.for_each_around(x, [&](int bucket) {
        for (int k = start(bucket); k < start(bucket + 1) && goes_on; ++k) {
          Spot const spot = read_words(&sorted(k));
          double const dx = place[0] - (spot.x[0] + shift[0]), dy = place[1] - (spot.x[1] + shift[1]),
                       dz = place[2] - (spot.x[2] + shift[2]), squared = dx * dx + dy * dy + dz * dz;
          if (squared < buckets.width * buckets.width) goes_on = f(numbers(k), spot, dx, dy, dz, squared);
        }
      });
    }
  }
  /// Finds the vector (m) from particles to one of their periodic images.
  SCREE_FN void find_shift(int image, double* shift) const {
    for (int period = 0; image > 0; ++period, image /= 3)
      shift[axis_of[period]] = (image % 3 == 2 ? -1 : image % 3) * length_of[period];
  }
  /// Returns the lowest number of a particle in the cell of a point.
  SCREE_FN int first_of_cell(double const* place) const {
    auto const cell = buckets.cell_of(place);
    int const bucket = buckets.bucket_of(cell);
    int k = start(bucket);
    while (k + 1 < start(bucket + 1) && !(buckets.cell_of(sorted(k).x) == cell)) ++k;
    return numbers(k);
  }
};

struct CountSpots {
  Span<Spot const> spots;
  Buckets buckets;
  Span<int> start;
  SCREE_FN void operator()(int i) const {
    Kokkos::atomic_inc(&start(buckets.bucket_of(buckets.cell_of(spots(i).x)) + 1));
  }
};
struct FillBuckets {
  Span<Spot const> spots;
  Buckets buckets;
  Span<int const> start;
  Span<int> filled, numbers;
  SCREE_FN void operator()(int i) const {
    int const bucket = buckets.bucket_of(buckets.cell_of(spots(i).x));
    numbers(start(bucket) + Kokkos::atomic_fetch_add(&filled(bucket), 1)) = i;
  }
};
/// Copies the spots with the given numbers, in the order of the list of numbers.
struct PickSpots {
  Span<Spot const> spots;
  Span<int const> numbers;
  Span<Spot> picked;
  SCREE_FN void operator()(int k) const { picked(k) = spots(numbers(k)); }
};

/// Spots sorted by buckets.
template <class Space>
class SpotsInCells {
 public:
  /// The largest number of particles in a bucket. It suffices for several cells that are twice as dense as a lattice
  /// with the spacing of the particles. With fuller buckets, for instance if most particles are in one place, the
  /// search would take too long.
  static constexpr int most_in_bucket = 512;

  SpotsInCells(Spots<Space> const& spots, double width, int dimensions, std::vector<Period> const& periods) {
    Space const& space = spots.space();
    int const count = spots.all.size();
    std::size_t const buckets = std::bit_ceil(std::size_t(count) / 4 + 64);
    view_.buckets = Buckets{width, dimensions, std::uint64_t(buckets) - 1};
    start_ = {space, "scree::buckets", buckets + 1};
    for_each_index(space, "scree::count_spots", 0, count, CountSpots{spots.all, view_.buckets, start_});
    is_complete_ = reduce(space, "scree::fullest_bucket", start_.size(), LargestValue{start_}) <= most_in_bucket;
    if (!is_complete_) return;
    running_sum(space, "scree::bucket_start", start_.size(), SumUp{start_});
    ArrayIn<int, Space> const filled(space, "scree::buckets", buckets);
    numbers_ = {space, "scree::spots", std::size_t(count)};
    sorted_ = {space, "scree::spots", std::size_t(count)};
    for_each_index(space, "scree::fill_buckets", 0, count,
                   FillBuckets{spots.all, view_.buckets, start_, filled, numbers_});
    for_each_index(space, "scree::sort_buckets", 0, int(buckets), SortWithinCells{start_, numbers_});
    for_each_index(space, "scree::sort_spots", 0, count, PickSpots{spots.all, numbers_, sorted_});
    view_.start = start_, view_.numbers = numbers_, view_.sorted = sorted_;
    view_.box = reduce(space, "scree::box_around_spots", count, BoxAroundSpots{spots.all});
    view_.images = 1;
    for (std::size_t k = 0; k < periods.size(); ++k) {
      view_.axis_of[k] = periods[k].axis, view_.length_of[k] = periods[k].high - periods[k].low;
      view_.images *= 3;
    }
  }
  /// Whether no bucket has too many particles; otherwise there is no view.
  bool is_complete() const { return is_complete_; }
  /// Returns the view of the spots, which is valid as long as this object.
  SpotsView const& view() const { return view_; }
  /// The memory for each particle, bytes.
  static constexpr double bytes = sizeof(Spot) + 3 * sizeof(int);

 private:
  ArrayIn<int, Space> start_, numbers_;
  ArrayIn<Spot, Space> sorted_;
  SpotsView view_ = {};
  bool is_complete_ = false;
};

}  // namespace scree::detail

#ifdef SCREE_COMPILED
SCREE_INSTANCE class scree::detail::SpotsInCells<Kokkos::DefaultExecutionSpace>;
#endif
