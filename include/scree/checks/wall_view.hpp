// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/algebra.hpp"
#include "../core/setting.hpp"
#include "../core/types.hpp"
#include "points_in_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// The surroundings of wall particles: material and walls.
namespace scree::detail {

/// A way in which a wall is too thin at one of its particles.
enum class ThinWall { none, few_rows, shows_both_sides, thin_plate, turning_plate };

/// The surroundings of one wall particle within a little less than a support, on the host or on a device. A function
/// `for_each_material` visits particles of the material: it calls visit(x, squared) with the vector x from the wall
/// particle (m) and its square, each time in the same order.
struct WallView {
  using Point = Vec<3, double>;
  // Thresholds of the checks below. Lengths are in spacings.
  static constexpr double second_row = 1.6;  // the first row of a lattice and its diagonals are nearer, not the second
  static constexpr double while_turning = 0.75;   // grains come closer to a turning plate by at most this distance
  static constexpr double usual_support = 3;      // of a kernel with a support of 2 h and the default smoothing length
  static constexpr double least_share = 0.05;     // of the weight; with less, only grains that have sunk in are there
  static constexpr double cosine_behind = 0.4;    // within 66 degrees of straight behind
  static constexpr double cosine_opposite = 0.8;  // within 37 degrees of opposite
  // The largest ratio of the second moment across the normal to that along it. A lattice in front of a flat wall has
  // 0.49 (0.48 in space); the surroundings of the end of a plate of one row have 0.67 or more.
  static constexpr double widest = 0.65;

  int dimensions = 2;
  double spacing = 1;              ///< m
  double support = usual_support;  ///< of the kernel, spacings; values below 3 are treated as 3
  double other_share = 0;          ///< share of the weight of the material on the side that has less of it
  int fewer = 0;                   ///< particles of the material on the side that has fewer
  double thickness = 0;            ///< between the material on both sides, m
  bool is_edge = false;            ///< whether there is material to the side, or both sides are not opposite
  bool has_few_rows = false;       ///< whether there is material in front, and walls do not fill its support
  double depth = 0;                ///< largest distance of wall particles behind, m; 0 if there is no second row

  /// Returns the fault of the wall at this particle. `plate`: whether it is a plate; `turns`: whether it turns, now or
  /// later.
  SCREE_FN ThinWall fault(bool plate, bool turns) const {
    if (has_few_rows) return ThinWall::few_rows;
    int const bed = dimensions == 2 ? 4 : 8;  // fewer particles are grains that have sunk into the wall
    if (is_edge || other_share < least_share || fewer < bed) return ThinWall::none;
    if (!plate) return ThinWall::shows_both_sides;
    if (thickness < thin() * spacing) return ThinWall::thin_plate;
    return turns && thickness < (thin() + while_turning) * spacing ? ThinWall::turning_plate : ThinWall::none;
  }
  /// Returns the distance up to which the surroundings of a wall particle are examined, spacings. If the support is
  /// wider than usual, the weight beyond it is at most 0.3 % of that at distance zero. With the usual support the
  /// distance is slightly less than 3 spacings, so that rounding does not decide whether a row of particles there is
  /// included.
  SCREE_FN static double reach(double support) { return Kokkos::max(Kokkos::sqrt(8.7), 0.85 * support); }
  /// Returns the width of the cells for this search, spacings.
  SCREE_FN static double cell(double support) { return Kokkos::max(double(usual_support), 0.85 * support); }
  /// Returns the thickness below which material acts on material through a plate, spacings. With the usual support, a
  /// plate of two rows is thicker, even if grains have come closer than at the start.
  SCREE_FN double thin() const { return Kokkos::max(1.75, 0.8 * support - 1); }
  /// Returns the distance behind the first row up to which there must be particles of walls, spacings; 0 if a second
  /// row is enough. The next row, which is missing, is then farther from the material than 0.82 supports.
  SCREE_FN double least_depth() const { return support > usual_support ? 0.82 * support - 2 : 0; }
  /// Returns the sentence about a fault of this wall; "" if there is none.
  [[gnu::cold]] std::string text(ThinWall fault) const;
  /// Sets the members above. for_each_wall(visit) calls visit(x) for the particles of walls within the same distance;
  /// it is called only if the walls behind the particle are needed.
  template <class ForEachMaterial, class ForEachWall>
  SCREE_FN void look(ForEachMaterial const& for_each_material, ForEachWall const& for_each_wall) {
    Point across;  // the direction through the wall
    if (!find_across(for_each_material, across)) return;
    Point mean_here = zero<Point>(), mean_there = zero<Point>();
    double along = 0, aside = 0;  // second moments
    int count_here = 0, count_there = 0;
    double here = 0, there = 0, least_here = Kokkos::max(double(usual_support), support) * spacing,
           least_there = least_here;
    double const squared_near = sq(near_ * spacing);
    for_each_material([&](Point const& x, double squared) {
      double const height = dot(x, across), distance = Kokkos::sqrt(squared), share = weight_at(distance);
      bool const is_there = height < 0;
      (is_there ? there : here) += share;
      ++(is_there ? count_there : count_here);
      double& least = is_there ? least_there : least_here;
      least = Kokkos::min(least, distance);
      if (squared > squared_near) return;
      (is_there ? mean_there : mean_here) += share * x;
      along += share * height * height;
      aside += share * (squared - height * height) / (dimensions - 1);
    });
    other_share = Kokkos::min(here, there) / (here + there);
    fewer = Kokkos::min(count_here, count_there);
    double const lengths = norm(mean_here) * norm(mean_there);
    is_edge = aside > widest * along || dot(mean_here, mean_there) > -cosine_opposite * lengths;
    thickness = least_here + least_there - spacing;
    if (there > 0 || !(least_here < second_row * spacing)) return;
    int beside = 0;  // a few isolated wall particles are not a row
    for_each_wall([&](Point const& x) {
      double const distance = norm(x), behind = -dot(x, across);
      if (behind > cosine_behind * distance) depth = Kokkos::max(depth, behind);
      beside += distance < second_row * spacing;
    });
    has_few_rows = (depth == 0 || depth < least_depth() * spacing) && beside >= 2;
  }

 private:
  double near_ = 0;  // distance up to which the shape of the surroundings is examined, spacings

  SCREE_FN double weight_at(double distance) const {
    double const R = Kokkos::max(double(usual_support), support), r = distance / spacing, left = 1 - r / R;
    return left > 0 ? left * left * left * left * (1 + 4 * r / R) : 0;
  }
  /// Finds the direction through the wall, starting from that of the nearest particle. Returns false if there is no
  /// material.
  template <class ForEachMaterial>
  SCREE_FN bool find_across(ForEachMaterial const& for_each_material, Point& across) {
    double least = Kokkos::Experimental::infinity_v<double>;
    for_each_material([&](Point const& x, double squared) {
      if (squared < least) least = squared, across = x;
    });
    if (!(least < Kokkos::Experimental::infinity_v<double>)) return false;
    near_ = Kokkos::max(double(usual_support), usual_support * Kokkos::sqrt(least) / spacing);
    across /= Kokkos::sqrt(least);
    for (int iteration = 0; iteration < 4; ++iteration) {
      Point sum = zero<Point>();
      for_each_material([&](Point const& x, double squared) {
        double const share = weight_at(Kokkos::sqrt(squared));
        sum += (dot(x, across) < 0 ? -share : share) * x;
      });
      double const length = norm(sum);
      if (!(length > 0)) break;
      Point const before = across;
      across = sum / length;
      if (squared_norm(Point(across - before)) == 0) break;
    }
    return true;
  }
};

/// An evaluation of the surroundings of wall particles, on the host. The particles of the material come first; there
/// are `owned` of them.
class WallsLook {
 public:
  using Point = PointsInCells::Point;
  WallsLook(std::vector<Point> const& places, std::size_t owned, double spacing, int dimensions,
            double support = WallView::usual_support);
  /// Returns the number of cells with wall particles.
  std::size_t cells() const { return walls_.size(); }
  /// Calls visit(w, view) for the wall particles in the cells from `from` up to, but not including, `to` that have
  /// material near them.
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
  /// The particles around a box. Those of walls are found only when one of them is needed.
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
  /// Returns the particles of the material in cells that are near walls.
  PointsInCells material_near(std::vector<Point> const& places) const;
  double cell() const { return WallView::cell(support_) * spacing_; }
  double reach() const { return WallView::reach(support_) * spacing_; }
  /// Calls visit(x, |x|^2) with the vector x (m) from `centre` to y if y is near.
  ///
  template <class Visit>
  void if_near(Point const& centre, Point const& y, Visit const& visit) const {
    WallView::Point const x = {y[0] - centre[0], y[1] - centre[1], y[2] - centre[2]};
    double const squared = squared_norm(x);
    if (squared > 0 && squared < reach() * reach()) visit(x, squared);
  }
  WallView view(Point const& centre, Around& around) const;

  std::size_t owned_;
  double spacing_;
  int dimensions_;
  double support_;
  PointsInCells walls_, material_;  // the material near walls
};

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "wall_view.ipp"
#endif
