// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../shapes/polygon.hpp"
#include "raster.hpp"

namespace scree {

/// Returns the ground along a straight line over a raster, as a polygon in the plane. The first coordinate is the
/// distance from `from`, the second one the height, by bilinear interpolation at steps of about the spacing of the
/// raster. The polygon is closed at `below` (m) under its lowest point. Throws std::runtime_error with the file if a
/// point of the line has no value, and std::invalid_argument if the line has no length or is not shorter than 10 000
/// spacings of the raster, or if `below` is not positive.
inline Polygon profile_along(Raster const& raster, Vec<2, double> const& from, Vec<2, double> const& to, double below) {
  double const length = (to - from).norm();
  check_setting(length > 0 && std::isfinite(length), "length of a profile (m)", length, "above 0");
  check_setting(below > 0 && std::isfinite(below), "depth of a profile below its lowest point (m)", below, "above 0");
  check_setting(length < 1e4 * raster.spacing, "length of a profile in spacings of the raster", length / raster.spacing,
                "below 10 000");
  int const steps = std::max(1, static_cast<int>(std::lround(length / raster.spacing)));
  Polygon::Loop loop;
  double lowest = std::numeric_limits<double>::infinity();
  for (int k = steps; k >= 0; --k) {
    Vec<2, double> const x = from + (to - from) * (double(k) / steps);
    double const height = raster(x[0], x[1]);
    if (!std::isfinite(height))
      throw std::runtime_error(detail::formatted("%s: there is no value at x = %g, y = %g m, on the line of a profile",
                                                 raster.name.c_str(), x[0], x[1]));
    loop.push_back({length * k / steps, height});
    lowest = std::min(lowest, height);
  }
  loop.push_back({0, lowest - below});
  loop.push_back({length, lowest - below});
  return Polygon(loop);
}

}  // namespace scree
