// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/array.hpp"
#include "../fields/standard.hpp"
#include "../kernels/default_bases.hpp"
#include "../system/pick.hpp"
#include "points_in_cells.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

// The search for particles that are near some points of the host. It runs where the particles are, so that only those
// found need to be copied.
namespace scree::detail {

/// Whether a particle may be within the width of a cell of one of the points: true for all particles within it and for
/// some others.
struct MaybeNear {
  using reads = Fields<Position>;
  Span<std::uint32_t const> marks;  // a bit for each value of the hash of a cell
  double width;                     // of cells, m

  SCREE_FN static std::uint64_t hash(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t const mixed = std::uint64_t(x) * 0x9E3779B97F4A7C15u ^ std::uint64_t(y) * 0xC2B2AE3D27D4EB4Fu ^
                                std::uint64_t(z) * 0x165667B19E3779F9u;
    return mixed ^ mixed >> 29;
  }
  /// Returns PointsInCells::cell_of() for one coordinate.
  SCREE_FN static std::int64_t index_of(double x, double width) {
    double const place = x / width, far = 1e15;
    return std::int64_t(Kokkos::floor(place > -far ? Kokkos::min(place, far) : -far));
  }
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    std::int64_t cell[3] = {};
    auto const& x = i[fields::position];
    for (int axis = 0; axis < x.size(); ++axis) cell[axis] = index_of(double(x[axis]), width);
    std::uint64_t const bit = hash(cell[0], cell[1], cell[2]) & (std::uint64_t(marks.size()) * 32 - 1);
    return (marks(int(bit / 32)) >> (bit % 32) & 1) != 0;
  }
};

/// Returns the marks of the cells around points.
[[gnu::cold]] std::vector<std::uint32_t> marks_around(std::vector<PointsInCells::Point> const& points, double width);

/// Returns the numbers of the owned particles of a body that may be within a width (m) of some points. All particles
/// within the width are included, and possibly some others.
template <class P>
[[gnu::cold]] Array<P, int const> those_near(std::vector<PointsInCells::Point> const& points, double width,
                                             AnyParticles<P> const& body) {
  auto const marks = array_of<P>(body.space(), marks_around(points, width));
  return pick(body, MaybeNear{marks, width});
}

}  // namespace scree::detail

#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P)                                             \
  SCREE_INSTANCE scree::Array<P, int const> scree::detail::those_near( \
      std::vector<scree::detail::PointsInCells::Point> const&, double, scree::AnyParticles<P> const&)
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);
#undef SCREE_INSTANCES
#else
#include "near_cells.ipp"
#endif
