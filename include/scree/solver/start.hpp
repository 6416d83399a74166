// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/periodic.hpp"
#include "../core/setting.hpp"
#include "../fields/standard.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Finds initial positions that are certainly wrong. It runs on the host and does not depend on the formulation.
namespace scree {

/// Positions (m) and volumes (m^dim) of particles; the third coordinate of particles in a plane is 0.
struct PlacedParticles {
  std::vector<std::array<double, 3>> places;
  std::vector<double> volumes;

  /// Adds the particles of a body, or some of them by number, of all parts of the case (core/one_part.hpp).
  template <class Parts, class Body, class... Numbers>
  [[gnu::cold]] void add(Parts const& parts, Body const& body, Numbers const&... which) {
    using namespace fields;
    auto const order = parts.order_of(body, which...);
    for (auto const& x : order.of(body.to_host(position, which...))) place(x);
    for (auto const v : order.of(body.to_host(volume, which...))) volumes.push_back(double(v));
  }
  /// Adds points with one volume (m^dim).
  template <class X>
  [[gnu::cold]] void add(std::vector<X> const& points, double volume_of_each) {
    for (X const& x : points) place(x), volumes.push_back(volume_of_each);
  }

 private:
  template <class X>
  [[gnu::cold]] void place(X const& x) {
    places.push_back({});
    for (int axis = 0; axis < x.size(); ++axis) places.back()[std::size_t(axis)] = double(x[axis]);
  }
};

namespace detail {

/// Points sorted into the cells of a grid; a hash finds the cells.
class PointsInCells {
 public:
  using Point = std::array<double, 3>;
  using Cell = std::array<std::int64_t, 3>;

  [[gnu::cold]] PointsInCells(std::vector<Point> const& points, double width, int dimensions)
      : points_(points), width_(width), layers_(dimensions == 2 ? 0 : 1), next_(points.size()) {
    while (mask_ < points.size()) mask_ = 2 * mask_ + 1;
    first_.resize(mask_ + 1, none);
    for (std::size_t i = points.size(); i-- > 0;) {
      std::size_t const k = bucket(cell_of(points[i]));
      next_[i] = first_[k], first_[k] = i;
    }
  }
  /// visit(j) for each point in the cell of x and in those around it.
  template <class Visit>
  [[gnu::cold]] void around(Point const& x, Visit const& visit) const {
    Cell const centre = cell_of(x);
    for (int a = -1; a <= 1; ++a)
      for (int b = -1; b <= 1; ++b)
        for (int c = -layers_; c <= layers_; ++c) {
          Cell const cell = {centre[0] + a, centre[1] + b, centre[2] + c};
          for (std::size_t j = first_[bucket(cell)]; j != none; j = next_[j])
            if (cell_of(points_[j]) == cell) visit(j);
        }
  }

 private:
  /// Positions that are not finite, or too far away for an integer cell index, share a cell.
  Cell cell_of(Point const& x) const {
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double const place = std::floor(x[axis] / width_);
      cell[axis] = std::abs(place) < 1e15 ? static_cast<std::int64_t>(place) : std::int64_t(1) << 60;
    }
    return cell;
  }
  std::size_t bucket(Cell const& cell) const {
    auto const bits = [](std::int64_t number) { return static_cast<std::uint64_t>(number); };
    std::uint64_t const mixed =
        bits(cell[0]) * 0x9E3779B97F4A7C15u ^ bits(cell[1]) * 0xC2B2AE3D27D4EB4Fu ^ bits(cell[2]) * 0x165667B19E3779F9u;
    return static_cast<std::size_t>(mixed ^ mixed >> 29) & mask_;
  }

  std::vector<Point> const& points_;
  double width_;
  int layers_;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::size_t mask_ = 1;
  std::vector<std::size_t> first_, next_;  // a list of points for each bucket
};

/// The packing around one particle of the material.
struct Crowding {
  double density = 0;  ///< sum V W with Wendland's C2, h = 1.5 spacings; 1 on a lattice
  double nearest = std::numeric_limits<double>::infinity();  ///< distance of its nearest neighbour, m
  std::size_t neighbour = 0;
};

/// Evaluates the packing around a particle, including periodic images.
class StartLook {
 public:
  [[gnu::cold]] StartLook(PlacedParticles const& all, double spacing, int dimensions,
                          std::vector<Period> const& periods)
      : all_(all), cells_(all.places, 3 * spacing, dimensions), h_(1.5 * spacing), periods_(periods) {
    constexpr double pi = 3.14159265358979;
    scale_ = dimensions == 2 ? 7 / (4 * pi * h_ * h_) : 21 / (16 * pi * h_ * h_ * h_);
  }
  [[gnu::cold]] Crowding operator()(std::size_t i) const {
    Crowding found;
    found.density = all_.volumes[i] * scale_;
    add(i, all_.places[i], 0, found);
    return found;
  }

 private:
  [[gnu::cold]] void add(std::size_t i, PointsInCells::Point const& x, std::size_t period, Crowding& found) const {
    if (period < periods_.size()) {
      auto const [axis, low, high] = periods_[period];
      auto image = x;
      for (double const shift : {0.0, high - low, low - high}) {
        image[std::size_t(axis)] = x[std::size_t(axis)] + shift;
        if (image[std::size_t(axis)] > low - 2 * h_ && image[std::size_t(axis)] < high + 2 * h_)
          add(i, image, period + 1, found);
      }
      return;
    }
    cells_.around(x, [&](std::size_t j) {
      double squared = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        squared += (x[axis] - all_.places[j][axis]) * (x[axis] - all_.places[j][axis]);
      double const r = std::sqrt(squared), left = 1 - r / (2 * h_);
      if (j == i && x == all_.places[i]) return;
      if (left > 0) found.density += all_.volumes[j] * scale_ * left * left * left * left * (1 + 2 * r / h_);
      if (r < found.nearest) found.nearest = r, found.neighbour = j;
    });
  }

  PlacedParticles const& all_;
  PointsInCells cells_;
  double h_, scale_ = 0;
  std::vector<Period> const& periods_;
};

}  // namespace detail

/// How messages of check_start() name the particles, and what it allows.
struct StartWords {
  char const* when = "at the start";
  char const* of_others = " of the wall";
  bool may_be_sparse = false;  ///< whether particles may be without neighbours
};

/// The particles of the material come first; there are `owned` of them. Throws std::invalid_argument if
///   two particles, one of them of the material, are less than a tenth of a spacing apart;
///   particles of the material are more than 1.6 times as dense as their volumes allow; a lattice with random
///     displacements of 0.3 spacings along each axis reaches 1.32, two particles at each position 2;
///   most particles of the material, if there are 30 or more, have no neighbour within 1.5 spacings; in the sparsest
///     lattices it is 1.13 spacings away.
/// With more than 100 000 particles, a sample is checked.
[[gnu::cold]] inline void check_start(PlacedParticles const& all, std::size_t owned, double spacing, int dimensions,
                                      std::vector<Period> const& periods, StartWords const& words = {}) {
  std::size_t const sample = owned / 100'000 + 1;
  auto const refuse = [&](std::size_t i, std::string const& what) {
    auto const& x = all.places[i];
    throw std::invalid_argument(detail::formatted(
        "scree: %s particle %zu at (%.6g, %.6g%s) m %s; if this is meant, set `start_checks = false`", words.when, i,
        x[0], x[1], dimensions == 2 ? "" : detail::formatted(", %.6g", x[2]).c_str(), what.c_str()));
  };
  detail::StartLook const look(all, spacing, dimensions, periods);
  std::size_t looked_at = 0, alone = 0, last_alone = 0;
  for (std::size_t i = 0; i < owned; ++i) {
    if (static_cast<std::uint32_t>(i * 2654435761u) % sample != 0) continue;
    auto const found = look(i);
    bool const of_wall = found.neighbour >= owned;
    if (found.nearest < 0.1 * spacing)
      refuse(i, detail::formatted("is %.6g m from particle %zu%s: a tenth of the spacing, %.6g m, is the least allowed",
                                  found.nearest, found.neighbour - (of_wall ? owned : 0),
                                  of_wall ? words.of_others : "", 0.1 * spacing));
    if (found.density > 1.6)
      refuse(i, detail::formatted(
                    "stands in a material and walls %.6g times as dense as the volumes of the particles allow (at most "
                    "1.6): do bodies overlap, or is the spacing in the settings, %.6g m, larger than that of the "
                    "particles?",
                    found.density, spacing));
    ++looked_at;
    if (!(found.nearest > 1.5 * spacing)) continue;
    ++alone, last_alone = i;
  }
  if (!words.may_be_sparse && owned >= 30 && 2 * alone > looked_at)
    refuse(last_alone, detail::formatted(
                           "has no neighbour within 1.5 spacings (%.6g m), as %zu of %zu particles: is the spacing in "
                           "the settings smaller than that of the particles?",
                           1.5 * spacing, alone, looked_at));
}

}  // namespace scree
