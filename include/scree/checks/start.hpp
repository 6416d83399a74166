// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "../fields/standard.hpp"
#include "../fields/whole_body.hpp"
#include "../kernels/default_bases.hpp"
#include "../system/periodic.hpp"
#include "start_faults.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

// Finds initial positions that are certainly wrong. It runs on the host and does not depend on the formulation.
namespace scree {

/// Positions (m) and volumes (m^dim) of particles; the third coordinate of particles in a plane is 0.
struct PlacedParticles {
  std::vector<std::array<double, 3>> places;  ///< m
  std::vector<double> volumes;                ///< m^dim
  std::vector<int> numbers = {};              ///< their names in messages; empty: their indices in the lists

  /// Adds the particles of a body that are here, or some of them by number, and their identities.
  template <class P, class... Numbers>
  [[gnu::cold]] void add_here(AnyParticles<P> const& body, Numbers const&... which) {
    using namespace fields;
    auto const x = body.to_host(position, which...);
    add_places(x);
    make_room(volumes, x.size()), make_room(numbers, x.size());
    for (auto const v : body.to_host(volume, which...)) volumes.push_back(double(v));
    for (int const number : body.to_host(identity, which...)) numbers.push_back(number);
  }
  /// Adds all particles of a body, or some of them by number. scree::compiled contains it for WholeBody::untyped().
  template <class... Of, class... Numbers>
  [[gnu::cold]] void add(WholeBody<Of...> const& body, Numbers const&... which) {
    using namespace fields;
    auto const order = body.order(which...);
    auto const x = order.of(body.here().to_host(position, which...));
    add_places(x);
    make_room(volumes, x.size());
    for (auto const v : order.of(body.here().to_host(volume, which...))) volumes.push_back(double(v));
  }
  /// add_here() with the identities as names, unless the whole case is here: then add().
  template <class... Of, class... Numbers>
  void add_part(WholeBody<Of...> const& body, Numbers const&... which) {
    if (body.all_here())
      add(body.untyped(), which...);
    else
      add_here(body.here(), which...);
  }
  /// Adds points with one volume (m^dim).
  template <class X>
  [[gnu::cold]] void add(std::vector<X> const& points, double volume_of_each) {
    add_places(points);
    volumes.resize(places.size(), volume_of_each);
  }

 private:
  /// Makes room for this many more and some that follow: doubling would need twice the memory.
  template <class T>
  [[gnu::cold]] static void make_room(std::vector<T>& values, std::size_t more) {
    std::size_t const needed = values.size() + more;
    if (values.capacity() < needed) values.reserve(needed + needed / 4);
  }
  template <class X>
  [[gnu::cold]] void add_places(std::vector<X> const& points) {
    make_room(places, points.size());
    for (X const& x : points) {
      std::array<double, 3> all = {};
      for (int axis = 0; axis < X::RowsAtCompileTime; ++axis) all[std::size_t(axis)] = double(x[axis]);
      places.push_back(all);
    }
  }
};

namespace detail {

/// The largest number of wall particles whose volumes are compared with the distances between them.
inline constexpr std::size_t walls_looked_at = 4096;

/// The packing around particle i; those from `first_wall` on are of walls.
[[gnu::cold]] Crowding crowding_at(PlacedParticles const& all, std::size_t i, std::size_t first_wall, double spacing,
                                   int dimensions, std::vector<Period> const& periods);

}  // namespace detail

/// The rest of the case, for check_start() of those that are here.
struct OtherPlaces {
  std::size_t first_wall = 0;          ///< particles before it, behind those owned, are of the material, too
  std::function<long(long)> sum = {};  ///< over the whole case; none: all particles are here
};

/// The particles of the material come first; there are `owned` of them. Throws std::invalid_argument if
///   two particles, one of them of the material, are less than a tenth of a spacing apart;
///   particles of the material are more than 1.6 times as dense as their volumes allow; a lattice with random
///     displacements of 0.3 spacings along each axis reaches 1.32, two particles at each position 2;
///   most particles of the material, if there are 30 or more, have no neighbour within 1.5 spacings; in the sparsest
///     lattices it is 1.13 spacings away;
///   spacing or volumes are not those of the particles, see Packing::may_start().
/// The last two are left out where particles may be sparse, the last one also if `words` say so.
/// The threads of the host share the particles, which are checked cell by cell; the message names the first with a
/// fault, on any number of threads. With several ranks, all call it together: each checks its own particles among all
/// particles that are near.
[[gnu::cold]] void check_start(PlacedParticles const& all, std::size_t owned, double spacing, int dimensions,
                               std::vector<Period> const& periods, StartWords const& words = {},
                               OtherPlaces const& others = {});

/// The packing of the particles that check_start() checks. If `counted` is not empty, only particles with a nonzero
/// entry count. With others, all ranks call it together.
[[gnu::cold]] Packing packing_of(PlacedParticles const& all, std::size_t owned, double spacing, int dimensions,
                                 std::vector<Period> const& periods, OtherPlaces const& others = {},
                                 std::vector<char> const& counted = {});

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P)                                                                          \
  SCREE_INSTANCE void scree::PlacedParticles::add(scree::WholeBody<scree::AnyParticles<P>> const&); \
  SCREE_INSTANCE void scree::PlacedParticles::add(scree::WholeBody<scree::AnyParticles<P>> const&,  \
                                                  scree::Array<P, int const> const&)
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);
#undef SCREE_INSTANCES
#else
#include "start.ipp"
#endif
