// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/field.hpp"
#include "section.hpp"

#include <concepts>

namespace scree {

/// A law whose density follows the mixture, see MixtureDensity, also within a modifier.
template <class Law>
concept DensityOfMixture = requires(Law const& law) {
  requires Law::species_of_density >= 2;
  law.densities;
};

/// A point as a law in MixtureDensity sees it: with the density of its mixture over that of the law, and the section
/// that it has otherwise.
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

/// A point that knows the density of its mixture.
template <class Point>
concept KnowsRelativeDensity = requires(Point const& point) {
  { point.relative_density } -> std::convertible_to<double>;
};

/// The density of the mixture at a point over the density of the law; 1 where all species have one density.
template <class Point>
SCREE_FN double relative_density_of([[maybe_unused]] Point const& point) {
  if constexpr (KnowsRelativeDensity<Point>)
    return point.relative_density;
  else
    return 1;
}

}  // namespace scree
