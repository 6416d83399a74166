// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/field.hpp"
#include "section.hpp"

#include <concepts>

namespace scree {

/// Whether the density of a law follows the mixture (see MixtureDensity); also true if MixtureDensity is inside a
/// modifier.
template <class Law>
concept DensityOfMixture = requires(Law const& law) {
  requires Law::species_of_density >= 2;
  law.densities;
};

/// The point that MixtureDensity passes to its law: a point with the density of its mixture over the density of the
/// law, and with its own section.
template <class Point>
struct PointOfMixture {
  using section = section_at<Point>;
  Point const& point;
  double relative_density;  ///< -
  template <Field F>
  SCREE_FN decltype(auto) operator[](F field) const {
    return point[field];
  }
};

/// Whether a point has the relative density of its mixture.
template <class Point>
concept KnowsRelativeDensity = requires(Point const& point) {
  { point.relative_density } -> std::convertible_to<double>;
};

/// Returns the density of the mixture at a point over the density of the law; 1 if all species have the same density.
template <class Point>
SCREE_FN double relative_density_of([[maybe_unused]] Point const& point) {
  if constexpr (KnowsRelativeDensity<Point>)
    return point.relative_density;
  else
    return 1;
}

}  // namespace scree
