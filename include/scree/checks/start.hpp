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

// The search for initial positions that are certainly wrong. It runs on the host and does not depend on the
// formulation.
namespace scree {

/// Positions (m) and volumes (m^dim) of particles; the third coordinate of particles in a plane is 0.
struct PlacedParticles {
  std::vector<std::array<double, 3>> places;  ///< m
  std::vector<double> volumes;                ///< m^dim
  std::vector<int> numbers = {};              ///< numbers of particles in messages; empty: their indices in the lists

  /// Adds the particles of a body on this rank, or some of them by number, with their identities.
  template <class P, class... Numbers>
  [[gnu::cold]] void add_here(AnyParticles<P> const& body, Numbers const&... which) {
    using namespace fields;
    auto const x = body.to_host(position, which...);
    add_places(x);
    make_room(volumes, x.size()), make_room(numbers, x.size());
    for (auto const v : body.to_host(volume, which...)) volumes.push_back(double(v));
    for (int const number : body.to_host(identity, which...)) numbers.push_back(number);
  }
  /// Adds all particles of a body, or some of them by number. scree::compiled has instances for WholeBody::untyped().
  template <class... Of, class... Numbers>
  [[gnu::cold]] void add(WholeBody<Of...> const& body, Numbers const&... which) {
    using namespace fields;
    auto const order = body.order(which...);
    auto const x = order.of(body.here().to_host(position, which...));
    add_places(x);
    make_room(volumes, x.size());
    for (auto const v : order.of(body.here().to_host(volume, which...))) volumes.push_back(double(v));
  }
  /// Adds the particles of a body with their identities as names, or by add() if the whole case is here.
  template <class... Of, class... Numbers>
  void add_part(WholeBody<Of...> const& body, Numbers const&... which) {
    if (body.all_here())
      add(body.untyped(), which...);
    else
      add_here(body.here(), which...);
  }
  /// Adds points that all have the same volume (m^dim).
  template <class X>
  [[gnu::cold]] void add(std::vector<X> const& points, double volume_of_each) {
    add_places(points);
    volumes.resize(places.size(), volume_of_each);
  }

 private:
  /// Reserves memory for this many more values and for a quarter in addition: doubling would need twice the memory.
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

/// Returns the packing around particle i; particles from `first_wall` on are those of walls.
[[gnu::cold]] Crowding crowding_at(PlacedParticles const& all, std::size_t i, std::size_t first_wall, double spacing,
                                   int dimensions, std::vector<Period> const& periods);

}  // namespace detail

/// Data on the rest of the case, for check_start() of the particles that are here.
struct OtherPlaces {
  std::size_t first_wall = 0;          ///< index of the first wall particle; all before it are of the material
  std::function<long(long)> sum = {};  ///< sum over the whole case; empty: all particles are here
};

/// Checks initial positions. The particles of the material come first; there are `owned` of them. Throws
/// std::invalid_argument if
///   two particles, one of them of the material, are less than a tenth of a spacing apart;
///   particles of the material are more than 1.6 times as dense as their volumes allow; a lattice with random
///     displacements of 0.3 spacings along each axis reaches 1.32, two particles at each position 2;
///   most particles of the material, if there are 30 or more, have no neighbour within 1.5 spacings; in the sparsest
///     lattices the nearest neighbour is 1.13 spacings away;
///   spacing or volumes are not those of the particles or of the walls, see Packing::may_start() and
///     Packing::walls_may_start().
/// The last two checks are left out if particles may be sparse, and the last one also if `words` request this. The
/// threads of the host share the particles, which are checked cell by cell; the message names the first particle with a
/// fault, which does not depend on the number of threads. With several ranks, all ranks call the function together:
/// each checks its own particles among all particles that are near.
[[gnu::cold]] void check_start(PlacedParticles const& all, std::size_t owned, double spacing, int dimensions,
                               std::vector<Period> const& periods, StartWords const& words = {},
                               OtherPlaces const& others = {});

/// Returns the packing of the particles that check_start() checks. If `counted` is not empty, only particles with a
/// nonzero entry are included. With several ranks, all ranks call the function together.
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
