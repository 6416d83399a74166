// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "points_in_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// What particles of walls see of material and walls, on the host.
namespace scree::detail {

/// What one wall particle sees within a little less than a support of 3 spacings. `across` is the direction through the
/// wall.
struct WallView {
  using Point = PointsInCells::Point;
  struct Weighted {
    Point x;  // from the particle, m
    double weight, squared;
  };
  int dimensions = 2;
  std::vector<Weighted> material;
  Point across = {};
  double other_share = 0;   ///< share of the weight of the material on the side that has less of it
  int fewer = 0;            ///< particles of the material on the side that has fewer
  double thickness = 0;     ///< between the material of both sides, m
  bool is_edge = false;     ///< there is material to the side, or both sides are not opposite
  bool is_one_row = false;  ///< there is material in front and no wall behind

  static double product(Point const& a, Point const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  /// What is wrong with the wall here, which may be a plate and turn; "" if nothing is.
  [[gnu::cold]] std::string fault(bool plate, double spacing, bool turns = false) const;
  /// Adds a particle of the material, x from the wall particle (m).
  void add(Point const& x, double squared, double spacing) {
    double const r = std::sqrt(squared) / spacing, left = 1 - r / 3;
    material.push_back({x, left > 0 ? left * left * left * left * (1 + 4 * r / 3) : 0, squared});
  }
  /// Call it once `material` is known. for_each_wall(visit) calls visit(x) for the particles of walls within the same
  /// distance; it is called where walls behind are looked for.
  template <class ForEachWall>
  void look(double spacing, ForEachWall const& for_each_wall) {
    if (material.empty()) return;
    find_across();
    Point mean_here = {}, mean_there = {};
    double along = 0, aside = 0;  // second moments
    int count_there = 0;
    double here = 0, there = 0, least_here = 3 * spacing, least_there = least_here;
    for (auto const& [x, weight, squared] : material) {
      double const height = product(x, across), distance = std::sqrt(squared);
      (height < 0 ? there : here) += weight;
      count_there += height < 0;
      for (std::size_t axis = 0; axis < 3; ++axis) (height < 0 ? mean_there : mean_here)[axis] += weight * x[axis];
      double& least = height < 0 ? least_there : least_here;
      least = std::min(least, distance);
      along += weight * height * height;
      aside += weight * (squared - height * height) / (dimensions - 1);
    }
    other_share = std::min(here, there) / (here + there);
    fewer = std::min(count_there, int(material.size()) - count_there);
    double const lengths = std::sqrt(product(mean_here, mean_here) * product(mean_there, mean_there));
    is_edge = aside > 0.65 * along || product(mean_here, mean_there) > -0.8 * lengths;
    thickness = least_here + least_there - spacing;
    if (there > 0 || !(least_here < 1.6 * spacing)) return;
    bool has_wall_behind = false;
    int beside = 0;  // a few wall particles on their own are no row
    for_each_wall([&](Point const& x) {
      double const distance = std::sqrt(product(x, x));
      has_wall_behind = has_wall_behind || product(x, across) < -0.4 * distance;
      beside += distance < 1.6 * spacing;
    });
    is_one_row = !has_wall_behind && beside >= 2;
  }

 private:
  void find_across();
};

/// Evaluates what wall particles see. The particles of the material come first; there are `owned` of them.
class WallsLook {
 public:
  using Point = PointsInCells::Point;
  WallsLook(std::vector<Point> const& places, std::size_t owned, double spacing, int dimensions);
  /// The number of cells with wall particles.
  std::size_t cells() const { return walls_.size(); }
  /// visit(w, view) for those wall particles in some cells that see material.
  template <class Visit>
  void visit_cells(std::size_t from, std::size_t to, Visit const& visit) const {
    Around around;
    for (std::size_t cell = from; cell < to; ++cell) {
      around.find(*this, walls_.hull_of(cell));
      if (!around.material.empty())
        for (auto const* w = walls_.begin(cell); w != walls_.end(cell); ++w)
          visit(w->number - owned_, view(w->x, around));
    }
  }
  WallView operator()(Point const& x) const;

 private:
  /// The particles around a box. Those of walls are found where one of them is asked for.
  struct Around {
    std::vector<PointsInCells::Numbered> material;
    void find(WallsLook const& all, PointsInCells::Hull const& hull);
    std::vector<PointsInCells::Numbered> const& walls(WallsLook const& all) {
      if (!has_walls_) {
        walls_.clear();
        all.walls_.add_near(box_, all.reach(), {}, walls_);
        has_walls_ = true;
      }
      return walls_;
    }

   private:
    PointsInCells::Hull box_;
    std::vector<PointsInCells::Numbered> walls_;
    bool has_walls_ = false;
  };
  /// The particles of the material in cells that walls are near.
  PointsInCells material_near(std::vector<Point> const& places) const;
  double reach() const { return std::sqrt(8.7) * spacing_; }
  /// visit(x from `centre`, |x|^2) for a particle that is near.
  template <class Visit>
  void if_near(Point const& centre, Point const& y, Visit const& visit) const {
    Point const x = {y[0] - centre[0], y[1] - centre[1], y[2] - centre[2]};
    double const squared = WallView::product(x, x);
    if (squared > 0 && squared < 8.7 * spacing_ * spacing_) visit(x, squared);
  }
  WallView view(Point const& centre, Around& around) const;

  std::size_t owned_;
  double spacing_;
  int dimensions_;
  PointsInCells walls_, material_;  // the material near walls
};

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "wall_view.ipp"
#endif
