// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "wall_view.hpp"

#include <utility>

namespace scree::detail {

SCREE_BODY std::string WallView::text(ThinWall fault) const {
  double const thick = thickness / spacing;
  auto const rows = [](double number) {
    int const count = int(std::ceil(number));
    return count == 2 ? std::string("two") : count == 3 ? "three" : std::to_string(count);
  };
  switch (fault) {
    case ThinWall::none:
      return "";
    case ThinWall::few_rows:
      if (support <= usual_support)
        return "it has one row of particles, so that the support of the material in front is half empty; it needs two "
               "rows, better three";
      return formatted(
          "walls end %.2g spacings behind it, and the support of the kernel is %.3g spacings: the material in front "
          "sees "
          "through the wall; it needs %.0f rows (a smaller `smoothing` needs fewer)",
          depth / spacing, support, std::ceil(support * (1 - 1e-12)));
    case ThinWall::shows_both_sides:
      return formatted(
          "it has material on both sides, %.2g spacings apart, and shows each the mean of both; make it %.0f "
          "spacings thick, or %.0f and a plate (`using walls = PlateWalls`, field `on_plate`)",
          thick, 2 * (std::ceil(std::max(2.95, 0.8 * support)) - 1), std::ceil(thin()));
    case ThinWall::thin_plate:
      return formatted("material acts on material through a plate of %.2g spacings; a plate needs %s", thick,
                       rows(thin()).c_str());
    case ThinWall::turning_plate:
      return formatted(
          "a plate of %.2g spacings turns; it needs %s, because grains come closer to it than at the "
          "start and a run stops where material acts on material through a plate of less than %.3g",
          thick, rows(thin() + while_turning).c_str(), thin());
  }
  return "";
}

SCREE_BODY WallsLook::WallsLook(std::vector<Point> const& places, std::size_t owned, double spacing, int dimensions,
                                double support)
    : owned_(owned),
      spacing_(spacing),
      dimensions_(dimensions),
      support_(support),
      walls_(places, owned, places.size(), cell()),
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
  return PointsInCells(places, 0, owned_, cell(), &some);
}

SCREE_BODY WallView WallsLook::view(Point const& centre, Around& around) const {
  std::vector<std::pair<WallView::Point, double>> material;
  for (auto const& y : around.material)
    if_near(centre, y.x, [&](WallView::Point const& x, double squared) { material.emplace_back(x, squared); });
  WallView found;
  found.dimensions = dimensions_, found.spacing = spacing_, found.support = support_;
  found.look(
      [&](auto const& visit) {
        for (auto const& [x, squared] : material) visit(x, squared);
      },
      [&](auto const& visit) {
        for (auto const& y : around.walls(*this))
          if_near(centre, y.x, [&](WallView::Point const& x, double) { visit(x); });
      });
  return found;
}

}  // namespace scree::detail
