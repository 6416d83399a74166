// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "points.hpp"

#include <scree/setup/lattice.hpp>
#include <scree/setup/rings.hpp>
#include <scree/setup/shapes.hpp>
#include <scree/setup/walls.hpp>

#include <cmath>
#include <utility>

namespace drum {
namespace {

/// The walls have the number of rows that the support needs.
int wall_rows(Options const& o) { return static_cast<int>(std::ceil(2 * o.numerics.smoothing)); }

/// The interior of the drum.
template <int Dim>
auto inside(Options const& o) {
  double const R = o.geometry.radius, length = o.geometry.length;
  if constexpr (Dim == 2)
    return scree::Ball<2>{.centre = {0, 0}, .radius = R};
  else
    return scree::Cylinder{.axis = 1, .centre = {0, 0, 0}, .radius = R, .from = -length / 2, .to = length / 2};
}

template <int Dim>
auto wall_points(Options const& o) {
  auto const shape = inside<Dim>(o);
  if constexpr (Dim == 2) {
    return scree::wall_rings(shape, o.numerics.spacing, wall_rows(o));
  } else {
    auto const ends = o.geometry.ends == Ends::walled ? scree::EndWalls::discs : scree::EndWalls::none;
    return scree::wall_rings(shape, o.numerics.spacing, wall_rows(o), ends);
  }
}

}  // namespace

template <int Dim>
Points<Dim> points(Options const& o) {
  double const dr = o.numerics.spacing;
  scree::Vec<Dim, double> top = scree::Vec<Dim, double>::Zero(), up = top;
  top[Dim - 1] = initial_level(o);
  up[Dim - 1] = 1;
  scree::HalfSpace<Dim> const below{.point = top, .normal = up};
  Points<Dim> result{.material = {}, .wall = wall_points<Dim>(o), .volumes = {}};
  if (o.numerics.filling == Filling::rings) {
    auto filled = scree::fill_rings(inside<Dim>(o), dr, below);
    result.material = std::move(filled.points);
    result.volumes = std::move(filled.volumes);
  } else {
    result.material = scree::fill_lattice(inside<Dim>(o) & below, dr);
    result.volumes.assign(result.material.size(), std::pow(dr, Dim));
  }
  return result;
}

template Points<2> points(Options const&);
template Points<3> points(Options const&);

}  // namespace drum
