// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "wall_view.hpp"

namespace scree::detail {

SCREE_BODY std::string WallView::fault(bool plate, double spacing, bool turns) const {
  double const thick = thickness / spacing;
  if (is_one_row)
    return "it has one row of particles, so that the support of the material in front is half empty; it needs two "
           "rows, better three";
  int const bed = dimensions == 2 ? 4 : 8;  // fewer particles are grains that have sunk into the wall
  if (is_edge || other_share < 0.05 || fewer < bed) return "";
  if (!plate)
    return formatted(
        "it has material on both sides, %.2g spacings apart, and shows each the mean of both; make it 4 "
        "spacings thick, or 2 and a plate (`using walls = PlateWalls`, field `on_plate`)",
        thick);
  if (thick < 1.75)
    return formatted("material acts on material through a plate of %.2g spacings; a plate needs two", thick);
  if (turns && thick < 2.5)
    return formatted(
        "a plate of %.2g spacings turns; it needs three, because grains come closer to it than at the "
        "start and a run stops where material acts on material through a plate of less than 1.75",
        thick);
  return "";
}

SCREE_BODY void WallView::find_across() {
  Weighted const* nearest = &material[0];
  for (Weighted const& m : material)
    if (m.squared < nearest->squared) nearest = &m;
  double const reach = std::sqrt(nearest->squared);
  for (std::size_t axis = 0; axis < 3; ++axis) across[axis] = nearest->x[axis] / reach;
  for (int iteration = 0; iteration < 4; ++iteration) {
    Point sum = {};
    for (auto const& [x, weight, squared] : material) {
      double const signed_weight = product(x, across) < 0 ? -weight : weight;
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += signed_weight * x[axis];
    }
    double const length = std::sqrt(product(sum, sum));
    if (!(length > 0)) break;
    Point const before = across;
    for (std::size_t axis = 0; axis < 3; ++axis) across[axis] = sum[axis] / length;
    if (across == before) break;
  }
}

SCREE_BODY WallsLook::WallsLook(std::vector<Point> const& places, std::size_t owned, double spacing, int dimensions)
    : owned_(owned),
      spacing_(spacing),
      dimensions_(dimensions),
      walls_(places, owned, places.size(), 3 * spacing),
      material_(material_near(places)) {}

SCREE_BODY WallView WallsLook::operator()(Point const& x) const {
  Around around;
  PointsInCells::Hull here;
  here.add(x);
  around.find(*this, here);
  return view(x, around);
}

SCREE_BODY void WallsLook::Around::find(WallsLook const& all, PointsInCells::Hull const& hull) {
  box_ = hull, has_walls_ = false;
  material.clear();
  all.material_.add_near(box_, all.reach(), {}, material);
}

SCREE_BODY PointsInCells WallsLook::material_near(std::vector<Point> const& places) const {
  CellNumbers const some = walls_.cells_near(reach());
  return PointsInCells(places, 0, owned_, 3 * spacing_, &some);
}

SCREE_BODY WallView WallsLook::view(Point const& centre, Around& around) const {
  WallView found;
  found.dimensions = dimensions_;
  for (auto const& y : around.material)
    if_near(centre, y.x, [&](Point const& x, double squared) { found.add(x, squared, spacing_); });
  found.look(spacing_, [&](auto const& visit) {
    for (auto const& y : around.walls(*this)) if_near(centre, y.x, [&](Point const& x, double) { visit(x); });
  });
  return found;
}

}  // namespace scree::detail
