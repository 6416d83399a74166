// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

/// Options of a column of grains that is released. `column_collapse --options` prints the table.
namespace column_collapse {

struct Geometry {
  double aspect = 2;    // H0/L0
  double width = 0.05;  // m, L0: half the width, or the radius
};

struct Model {
  double friction_at_rest = 0.382;  // k_mu, the tangent of an angle in plane shear
  double friction_at_speed = 0.682;
  double viscosity_speed = 0.5;  // m/s, alpha c_s of the artificial viscosity
};

struct Numerics {
  int dimension = 2;
  int across = 20;  // particles over L0
  double cfl = 0.4;
  std::optional<double> reach = {};  // L0, of the floor; by the aspect ratio when not given
};

struct Output {
  double duration = 7;          // sqrt(H0/g)
  double interval = 0.5;        // sqrt(H0/g)
  double reading_depth = 0.05;  // H0
};

struct Options {
  Geometry geometry;
  Model model;
  Numerics numerics;
  Output output;
};

}  // namespace column_collapse
