// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "walls.hpp"

#include <numbers>

namespace scree {
namespace detail {

SCREE_BODY void add_rings_around(PlanePoints& plane, double radius, double spacing, int rows) {
  for (int row = 0; row < rows; ++row) plane.add_annulus(radius + (row + 0.5) * spacing, spacing);
}
SCREE_BODY PlanePoints rings_around(double radius, double spacing, int rows) {
  check_spacing(spacing);
  check_rows(rows);
  check_memory(2 * std::numbers::pi * (radius / spacing + rows) * rows, sizeof(Vec<2, double>) + sizeof(double));
  PlanePoints plane;
  add_rings_around(plane, radius, spacing, rows);
  return plane;
}

}  // namespace detail

SCREE_BODY std::vector<Vec<2, double>> wall_rings(Ball<2> const& disc, double spacing, int rows) {
  disc.check();
  auto points = detail::rings_around(disc.radius, spacing, rows).points;
  for (auto& x : points) x += disc.centre;
  return points;
}

SCREE_BODY std::vector<Vec<3, double>> wall_rings(Cylinder const& cylinder, double spacing, int rows, EndWalls ends) {
  cylinder.check();
  detail::PlanePoints const around = detail::rings_around(cylinder.radius, spacing, rows);
  detail::PlanePoints disc = detail::disc_of_rings(cylinder.radius, spacing);
  detail::add_rings_around(disc, cylinder.radius, spacing, rows);
  long const layers = detail::layers_of(cylinder, spacing);
  long const beyond = ends == EndWalls::discs ? rows : 0;
  check_memory(double(layers) * double(around.points.size()) + 2.0 * double(beyond) * double(disc.points.size()),
               sizeof(Vec<3, double>));
  std::vector<Vec<3, double>> points;
  for (long layer = -beyond; layer < layers + beyond; ++layer) {
    bool const beside = layer >= 0 && layer < layers;
    double const along = detail::layer_position(cylinder, layer, spacing);
    for (auto const& x : (beside ? around : disc).points) points.push_back(detail::lifted(x, along, cylinder));
  }
  return points;
}

}  // namespace scree
