// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/principal.hpp"
#include "../passes/outside_validity.hpp"
#include "settings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// The extent of the particles of rigid bodies, and checks of settings and positions against it.
namespace scree::detail {

/// The extent of the particles of a rigid body at time zero.
template <int Dim>
struct ExtentOfBody {
  using X = Vec<Dim, double>;
  X low = X::Constant(std::numeric_limits<double>::infinity()), high = -low;  ///< bounding box, m
  double radius = 0;                                                          ///< about the centre of the body, m
  int particles = 0;

  [[gnu::cold]] void add(X const& x, X const& centre) {
    low = low.cwiseMin(x), high = high.cwiseMax(x);
    radius = std::max(radius, (x - centre).norm());
    ++particles;
  }
};

template <int Dim>
[[gnu::cold]] std::string text_of(Vec<Dim, double> const& x) {
  return Dim == 2 ? formatted("(%.6g, %.6g)", x[0], x[1]) : formatted("(%.6g, %.6g, %.6g)", x[0], x[1], x[Dim - 1]);
}

/// Throws std::invalid_argument if the centre of mass of a body that is free to move is outside the box around its
/// particles, or if the body is also free to rotate and has more inertia than its mass would have at the distance of
/// the farthest particle. Both the box and the distance are enlarged by a spacing (m).
template <int Dim>
[[gnu::cold]] void check_extent(Rigid<Dim> const& body, ExtentOfBody<Dim> const& extent, double spacing, int number) {
  auto const is_free = [](auto const& given) {
    return std::any_of(given.begin(), given.end(), [](auto const& each) { return !each; });
  };
  auto const refuse = [&](std::string const& what) {
    throw std::invalid_argument(
        formatted("scree: %s (rigid body %d); if this is meant, set `start_checks = false`", what.c_str(), number));
  };
  if (!is_free(body.given_velocity)) return;
  auto const& [mass, centre, inertia] = body.properties;
  Vec<Dim, double> const low = extent.low.array() - spacing, high = extent.high.array() + spacing;
  if (!((centre.array() >= low.array()).all() && (centre.array() <= high.array()).all()))
    refuse(
        formatted("centre of a rigid body (m) must be inside of the box of its particles, from %s to %s with a "
                  "spacing around it, not %s",
                  text_of<Dim>(low).c_str(), text_of<Dim>(high).c_str(), text_of<Dim>(centre).c_str()));
  double largest = inertia(0, 0);
  if constexpr (Dim == 3) largest = principal(inertia).values.maxCoeff();
  double const most = mass * sq(extent.radius + spacing);
  if (is_free(body.given_turning) && largest > most)
    refuse(
        formatted("largest principal moment of a rigid body (kg m^2) must be at most %.6g, that of its mass, %.6g kg, "
                  "a spacing beyond its farthest particle, not %.6g",
                  most, mass, largest));
}

/// Throws OutsideValidity if a rigid body is more than a support (m) outside a box, below it or to a side. The box is
/// first enlarged to contain the initial positions of all bodies.
template <int Dim, class X>
[[gnu::cold]] void check_inside(std::vector<Vec<Dim, double>> const& centres,
                                std::vector<ExtentOfBody<Dim>> const& extents, X const& box_low, X const& box_high,
                                double support) {
  Vec<Dim, double> low = box_low.template cast<double>(), high = box_high.template cast<double>();
  for (auto const& extent : extents) low = low.cwiseMin(extent.low), high = high.cwiseMax(extent.high);
  for (std::size_t k = 0; k < centres.size(); ++k) {
    double const beyond = std::max((low - centres[k]).maxCoeff(), (centres[k] - high).maxCoeff()) - extents[k].radius;
    if (beyond > support)
      throw OutsideValidity(
          formatted("scree: rigid body %zu with its centre at %s m is lost, %.6g m beyond walls and initial positions, "
                    "below them "
                    "or to a side (a support, %.6g m, is allowed); where bodies may leave, set `lost_share = 1`",
                    k, text_of<Dim>(centres[k]).c_str(), beyond, support));
  }
}

}  // namespace scree::detail
