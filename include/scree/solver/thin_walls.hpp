// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/on_plate.hpp"
#include "start.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Finds walls that are too thin for the support of the kernel. It runs on the host and does not depend on the
// formulation.
namespace scree {

struct SlipNormal;
struct DummyVelocity;

namespace detail {

/// What one wall particle sees within a little less than a support of 3 spacings. `across` is the direction through the
/// wall.
struct WallView {
  using Point = PointsInCells::Point;
  int dimensions = 2;
  std::vector<Point> material, wall;  // from the particle, m
  Point across = {};
  double other_share = 0;   ///< share of the weight of the material on the side that has less of it
  int fewer = 0;            ///< particles of the material on the side that has fewer
  double thickness = 0;     ///< between the material of both sides, m
  bool is_edge = false;     ///< there is material to the side, or both sides are not opposite
  bool is_one_row = false;  ///< there is material in front and no wall behind

  [[gnu::cold]] static double product(Point const& a, Point const& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  /// What is wrong with the wall here; "" if nothing is.
  [[gnu::cold]] std::string fault(bool plate, double spacing) const {
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
    return "";
  }
  /// Call it once `material` and `wall` are known.
  [[gnu::cold]] void look(double spacing) {
    if (material.empty()) return;
    Point const* nearest = &material[0];
    for (Point const& m : material)
      if (product(m, m) < product(*nearest, *nearest)) nearest = &m;
    double const reach = std::sqrt(product(*nearest, *nearest));
    for (std::size_t axis = 0; axis < 3; ++axis) across[axis] = (*nearest)[axis] / reach;
    for (int iteration = 0; iteration < 4; ++iteration) {
      Point sum = {};
      for (Point const& m : material)
        for (std::size_t axis = 0; axis < 3; ++axis)
          sum[axis] += (product(m, across) < 0 ? -1 : 1) * weight(m, spacing) * m[axis];
      double const length = std::sqrt(product(sum, sum));
      if (!(length > 0)) break;
      for (std::size_t axis = 0; axis < 3; ++axis) across[axis] = sum[axis] / length;
    }
    Point mean_here = {}, mean_there = {};
    double along = 0, aside = 0;  // second moments
    int count_there = 0;
    double here = 0, there = 0, least_here = 3 * spacing, least_there = least_here;
    for (Point const& m : material) {
      double const height = product(m, across), distance = std::sqrt(product(m, m));
      (height < 0 ? there : here) += weight(m, spacing);
      count_there += height < 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        (height < 0 ? mean_there : mean_here)[axis] += weight(m, spacing) * m[axis];
      double& least = height < 0 ? least_there : least_here;
      least = std::min(least, distance);
      along += weight(m, spacing) * height * height;
      aside += weight(m, spacing) * (distance * distance - height * height) / (dimensions - 1);
    }
    other_share = std::min(here, there) / (here + there);
    fewer = std::min(count_there, int(material.size()) - count_there);
    double const lengths = std::sqrt(product(mean_here, mean_here) * product(mean_there, mean_there));
    is_edge = aside > 0.65 * along || product(mean_here, mean_there) > -0.8 * lengths;
    thickness = least_here + least_there - spacing;
    if (there == 0 && least_here < 1.6 * spacing) is_one_row = !has_wall_behind(spacing);
  }

 private:
  [[gnu::cold]] static double weight(Point const& m, double spacing) {
    double const r = std::sqrt(product(m, m)) / spacing, left = 1 - r / 3;
    return left > 0 ? left * left * left * left * (1 + 4 * r / 3) : 0;
  }
  /// A few wall particles on their own are no row.
  [[gnu::cold]] bool has_wall_behind(double spacing) const {
    int beside = 0;
    for (Point const& w : wall) {
      double const height = product(w, across), distance = std::sqrt(product(w, w));
      if (height < -0.4 * distance) return true;
      beside += distance < 1.6 * spacing;
    }
    return beside < 2;
  }
};

}  // namespace detail

/// The particles of the material, `owned` of them, then those of walls, and which of the latter belong to plates; of
/// all parts of the case.
struct ParticlesAtWalls {
  PlacedParticles all;
  std::size_t owned = 0;
  std::vector<bool> is_plate;

  template <class Parts, class Body>
  [[gnu::cold]] ParticlesAtWalls(Parts const& parts, Body const& material) {
    all.add(parts, material);
    owned = all.places.size();
  }
  /// Adds the particles of a wall that granular mechanics see. Walls that extrapolate show a mean of the material
  /// except on plates (boundaries/plates.hpp); those without an extrapolated velocity are like plates.
  template <class Parts, class Body>
  [[gnu::cold]] void add_wall([[maybe_unused]] Parts const& parts, [[maybe_unused]] Body const& body) {
    using Given = typename Body::fields;
    if constexpr (OneOf<SlipNormal, Given>) {
      all.add(parts, body);
      if constexpr (OneOf<OnPlate, Given>)
        for (auto const on : parts.order_of(body).of(body.to_host(OnPlate{}))) is_plate.push_back(on > 0);
      else
        is_plate.resize(all.places.size() - owned, !OneOf<DummyVelocity, Given>);
    }
  }
};

/// What is wrong with the first wall that is too thin; "" if none is.
///   a wall with material on both sides, of which one of its particles shows each side a mean with a share of the other
///     above 5 %; walls of 4 spacings stay below
///   a plate of less than 1.75 spacings with material on both sides, which then act on each other
///   a wall of one row of particles with material in front
/// Three wall particles must have a fault, so that single grains that have sunk into a wall do not count.
/// Edges and bodies of a few spacings, which have material all around, and the feet of plates are not looked at, and
/// periods are not followed. With more than 20 000 wall particles, a sample is looked at.
[[gnu::cold]] inline std::string fault_of_thin_walls(ParticlesAtWalls const& particles, double spacing,
                                                     int dimensions) {
  PlacedParticles const& all = particles.all;
  std::size_t const owned = particles.owned, walls = particles.is_plate.size(), sample = walls / 20'000 + 1;
  if (owned == 0 || walls == 0) return "";
  detail::PointsInCells const cells(all.places, 3 * spacing, dimensions);
  int faults = 0;
  for (std::size_t w = 0; w < walls; ++w) {
    if (static_cast<std::uint32_t>(w * 2654435761u) % sample != 0) continue;
    auto const& x = all.places[owned + w];
    detail::WallView view;
    view.dimensions = dimensions;
    cells.around(x, [&](std::size_t j) {
      auto const& y = all.places[j];
      detail::PointsInCells::Point const from = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
      double const squared = detail::WallView::product(from, from);
      if (squared > 0 && squared < 8.7 * spacing * spacing) (j < owned ? view.material : view.wall).push_back(from);
    });
    view.look(spacing);
    std::string const fault = view.fault(particles.is_plate[w], spacing);
    if (!fault.empty() && ++faults == 3)
      return detail::formatted(
          "scree: the wall is too thin at its particle %zu at (%.6g, %.6g%s) m: %s; if this is meant, set "
          "`start_checks "
          "= false`",
          w, x[0], x[1], dimensions == 2 ? "" : detail::formatted(", %.6g", x[2]).c_str(), fault.c_str());
  }
  return "";
}

}  // namespace scree
