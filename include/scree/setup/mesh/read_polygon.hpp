// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../shapes/polygon.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace scree {

/// The placement of a polygon, which maps x to R(angle) (scale x) + translation with a counter-clockwise rotation R.
struct PlanePlacement {
  double scale = 1;                                     ///< m per unit of the file, above 0
  double angle = 0;                                     ///< rad
  Vec<2, double> translation = Vec<2, double>::Zero();  ///< m

  Vec<2, double> operator()(Vec<2, double> const& x) const {
    double const c = std::cos(angle), s = std::sin(angle);
    return Vec<2, double>(scale * (c * x[0] - s * x[1]), scale * (s * x[0] + c * x[1])) + translation;
  }
};

/// Returns the polygons in the text of an OBJ file: its lines ("l 1 2 3 1"), in one or more pieces, or, if it has no
/// lines, the outlines of its polygons ("f 1 2 3"). Their plane is that of x and y if all z are equal, or that of x and
/// z if all y are equal. Throws std::invalid_argument if the scale is not positive, and std::runtime_error, with the
/// file and, if known, the line, if the text does not follow this format.
Polygon polygon_from_obj(std::string_view text, std::string const& name, PlanePlacement const& placement = {});

/// Returns the polygons in an OBJ file. Throws as polygon_from_obj() does, and std::runtime_error if the file cannot be
/// read.
Polygon read_polygon(std::filesystem::path const& file, PlanePlacement const& placement = {});

}  // namespace scree

#ifndef SCREE_COMPILED
#include "read_polygon.ipp"
#endif
