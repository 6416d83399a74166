// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "packing.hpp"

namespace scree {

SCREE_BODY std::string Packing::text() const {
  if (full == 0) return "no grains with others on all sides";
  return detail::formatted("%.3f, %.2f to %.2f in %ld grains", density, loose, dense, full);
}

SCREE_BODY double detail::quantile(std::function<long(double)> const& count, long members, int twentieths) {
  double low = 0, high = 4;
  for (int halving = 0; halving < 40; ++halving) {
    double const middle = (low + high) / 2;
    (20 * count(middle) >= twentieths * members ? high : low) = middle;
  }
  return high;
}

SCREE_BODY void detail::PackingOfMany::add(Crowding const& at, double spacing) {
  nearest_.push_back(at.nearest / spacing), volume_.push_back(at.volume);
  if (at.is_full) density_.push_back(at.density), by_number_.push_back(at.by_number);
  if (at.judges_walls) walls_.push_back(at.walls);
  facing_ += at.faces_walls, facing_little_ += at.faces_too_little();
}

SCREE_BODY void detail::PackingOfMany::add(PackingOfMany const& other) {
  auto const append = [](auto& to, auto const& from) { to.insert(to.end(), from.begin(), from.end()); };
  append(nearest_, other.nearest_), append(volume_, other.volume_);
  append(density_, other.density_), append(by_number_, other.by_number_), append(walls_, other.walls_);
  append(fill_of_walls_, other.fill_of_walls_);
  facing_ += other.facing_, facing_little_ += other.facing_little_, facing_sparse_ += other.facing_sparse_;
}

SCREE_BODY Packing detail::PackingOfMany::of_all(std::function<long(long)> const& sum) const {
  Packing found;
  found.particles = sum(long(nearest_.size())), found.full = sum(long(density_.size()));
  if (found.particles > 0) found.nearest = quantile(nearest_, sum), found.volume = quantile(volume_, sum);
  if (found.full > 0) {
    found.density = quantile(density_, sum), found.by_number = quantile(by_number_, sum);
    found.loose = quantile(density_, sum, 1), found.dense = quantile(density_, sum, 19);
  }
  found.at_walls = sum(long(walls_.size()));
  found.facing = sum(facing_), found.facing_little = sum(facing_little_);
  found.facing_sparse = sum(facing_sparse_);
  if (found.at_walls > 0) found.walls = quantile(walls_, sum);
  if (found.at_walls + found.facing > 0) found.fill_of_walls = quantile(fill_of_walls_, sum);
  return found;
}

SCREE_BODY double detail::PackingOfMany::quantile(std::vector<double> const& values,
                                                  std::function<long(long)> const& sum, int twentieths) {
  auto const count = [&](double bar) {
    return sum(std::count_if(values.begin(), values.end(), [&](double value) { return value <= bar; }));
  };
  return detail::quantile(count, sum(long(values.size())), twentieths);
}

SCREE_BODY std::string fault_of_packing(Packing const& packing, double spacing, int dimensions,
                                        std::string const& where) {
  if (packing.may_start()) return "";
  using detail::formatted;
  if (packing.is_thin() && packing.is_near_enough())
    return formatted(
        "scree: %s the volumes of the particles are %.4g times spacing^%d (median; from 0.75 to 1.25 is "
        "allowed), where settings.spacing is %.6g m",
        where.c_str(), packing.volume, dimensions, spacing);
  if (packing.is_thin())
    return formatted(
        "scree: %s the nearest neighbour of a particle is %.4g times settings.spacing, %.6g m, away "
        "(median; from 0.7 to 1.2 is allowed): a spacing of about %.4g m would fit",
        where.c_str(), packing.nearest, spacing, packing.nearest * spacing);
  std::string const found = formatted(
      "scree: %s the volumes of the particles fill %.4g times the space between them (median of sum V W over "
      "particles with others on all sides; from 0.95 to 1.05 is allowed)",
      where.c_str(), packing.density);
  if (Packing::fits(packing.by_number, 0.05))
    return found + formatted("; their distances fit settings.spacing, %.6g m, so the volumes are too %s", spacing,
                             packing.density > 1 ? "large" : "small");
  return found + formatted(": is settings.spacing, %.6g m, that of the particles? About %.4g m would fit", spacing,
                           spacing * std::pow(packing.by_number, -1.0 / dimensions));
}

SCREE_BODY std::string fault_of_walls(Packing const& packing, double spacing, std::string const& where) {
  if (packing.walls_may_start()) return "";
  if (packing.walls_are_sparse())
    return detail::formatted(
        "scree: %s the particles of walls are too far apart: their volumes are %.4g times the space that they have "
        "(median; from 0.85 to 1.15 is allowed), and %ld of %ld particles of the material beside them see less than "
        "%.4g of the wall that belongs there: are spacing and volumes of the walls those that belong to "
        "settings.spacing, %.6g m?",
        where.c_str(), packing.fill_of_walls, packing.facing_little, packing.facing, detail::Crowding::least_of_walls,
        spacing);
  return detail::formatted(
      "scree: %s the particles of walls fill %.4g times the space that the material leaves to them, and their volumes "
      "are %.4g times the space that they have themselves (medians; from 0.85 to 1.15 is allowed): are spacing and "
      "volumes of the walls those that belong to settings.spacing, %.6g m?",
      where.c_str(), packing.walls, packing.fill_of_walls, spacing);
}

SCREE_BODY std::string warning_of_sparse_wall(Packing const& packing, double spacing) {
  if (!packing.a_wall_is_sparse()) return "";
  return detail::formatted(
      "scree: warning: the particles of a wall are far apart: %ld particles of the material beside it have less than "
      "%.4g of the wall that belongs there, and its volumes are less than %.4g times the space that they have. "
      "Material leaks into such a wall unless it is meant as a grate: are spacing and volumes of this wall those that "
      "belong to "
      "settings.spacing, %.6g m?",
      packing.facing_sparse, detail::Crowding::least_of_walls, detail::Crowding::sparse_fill, spacing);
}

}  // namespace scree
