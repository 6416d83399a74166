// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../mesh/volume_below.hpp"
#include "height_field.hpp"

#include <optional>

namespace scree {

/// Material on the ground, with a vertical depth from a raster, as a shape: between the ground and the ground plus the
/// depth. The depth is interpolated at the points of the ground; it is zero where the raster has no value. The volume
/// of the release is that of its raster, the sum of the values times the area of a cell, to 1 %. Host only.
class Release {
 public:
  static constexpr int dim = 3;
  static constexpr char const* name = "Release";
  static constexpr bool costly_distance = true;

  /// Throws std::runtime_error with the file if the depth is negative, above 1e5 m or nowhere above zero, if material
  /// reaches the edge of the ground, or if the volume at the points of the ground is not that of the raster, because
  /// the raster is finer than the ground or extends beyond it.
  Release(HeightField const& ground, Raster const& depth) : ground_(ground), top_(raised(ground, depth)) {
    bounds_ = bounds_of(ground_.raster(), top_.raster());
  }

  /// Returns the signed distance, exact inside and a lower bound outside, m.
  double signed_distance(Vec<3, double> const& x) const {
    return std::max(top_.signed_distance(x), -ground_.signed_distance(x));
  }
  bool contains(Vec<3, double> const& x) const {
    return x[2] > ground_.height(x[0], x[1]) && x[2] < top_.height(x[0], x[1]);
  }
  Box<3> bounds() const { return bounds_; }
  /// Returns the volume below a level of z (m), m^3.
  std::optional<double> exact_volume_below(double level) const {
    detail::HeightGrid const low(ground_.raster()), high(top_.raster());
    double sum = 0;
    for (int j = 0; j + 1 < ground_.raster().rows; ++j)
      for (int i = 0; i + 1 < ground_.raster().columns; ++i) {
        if (low.triangles(i, j) == high.triangles(i, j)) continue;
        for (std::size_t k = 0; k < 4; ++k)
          sum += mean_below(high.triangles(i, j)[k], level) - mean_below(low.triangles(i, j)[k], level);
      }
    return sum * sq(ground_.raster().spacing) / 4;
  }
  /// Returns the ground on which the released grains lie.
  ///
  HeightField const& ground() const { return ground_; }

 private:
  static double mean_below(detail::Corners const& abc, double level) {
    return detail::mean_below({abc[0][2], abc[1][2], abc[2][2]}, level);
  }
  static Raster raised(HeightField const& ground, Raster const& depth) {
    Raster top = ground.raster();
    double in_raster = 0, on_ground = 0;  // sums of depths, m
    Raster filled = depth;
    for (std::size_t k = 0; k < depth.values.size(); ++k) {
      double& d = filled.values[k];
      if (std::isnan(d)) d = 0;
      if (!(d >= 0 && d <= detail::highest))
        throw std::runtime_error(detail::formatted(
            "%s: the depth of a release is %g m at x = %g, y = %g m; it must be 0 to %g m", depth.name.c_str(), d,
            depth.x_of(int(k) % depth.columns), depth.y_of(int(k) / depth.columns), detail::highest));
      in_raster += d;
    }
    for (int j = 0; j < top.rows; ++j)
      for (int i = 0; i < top.columns; ++i) {
        double const d = filled(top.x_of(i), top.y_of(j));
        if (!(d > 0)) continue;
        if (i == 0 || j == 0 || i == top.columns - 1 || j == top.rows - 1)
          throw std::runtime_error(
              detail::formatted("%s: the release reaches the edge of the ground at x = %g, y = %g m",
                                depth.name.c_str(), top.x_of(i), top.y_of(j)));
        on_ground += d;
        top.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(top.columns) + static_cast<std::size_t>(i)] +=
            d;
      }
    if (in_raster == 0) throw std::runtime_error(depth.name + ": there is no depth above zero");
    double const wanted = in_raster * sq(depth.spacing), found = on_ground * sq(top.spacing);
    if (!(std::abs(found - wanted) <= 0.01 * wanted))
      throw std::runtime_error(
          detail::formatted("%s: the release has %g m^3 in its raster, with points %g m apart, and %g m^3 at the "
                            "points of the ground, %g m "
                            "apart: use a ground that is as fine and reaches as far as the release",
                            depth.name.c_str(), wanted, depth.spacing, found, top.spacing));
    return top;
  }
  static Box<3> bounds_of(Raster const& low, Raster const& high) {
    double const infinity = std::numeric_limits<double>::infinity();
    Box<3> box{Vec<3, double>::Constant(infinity), Vec<3, double>::Constant(-infinity)};
    for (int j = 1; j + 1 < low.rows; ++j)
      for (int i = 1; i + 1 < low.columns; ++i) {
        if (high.at(i, j) == low.at(i, j)) continue;
        for (int const dj : {-1, 0, 1})
          for (int const di : {-1, 0, 1})
            for (double const z : {low.at(i + di, j + dj), high.at(i + di, j + dj)}) {
              Vec<3, double> const x(low.x_of(i + di), low.y_of(j + dj), z);
              box = detail::hull(box, Box<3>{x, x});
            }
      }
    return box;
  }

  HeightField ground_, top_;
  Box<3> bounds_{};
};

}  // namespace scree
