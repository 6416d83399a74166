// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"

#include <cmath>
#include <numbers>

// Quantities that follow from the options by arithmetic alone, in SI units.
namespace shear_box {

inline double gamma0(Options const& o) { return std::tan(o.geometry.amplitude * std::numbers::pi / 180); }

/// dr, m.
inline double spacing(Options const& o) { return o.numerics.spacing * o.geometry.height; }

/// V and D of (5.2), m/s and m^2/s. B = H gamma0 ("chi") or H ("times").
struct Coefficients {
  double V, D;
};
inline Coefficients coefficients(Options const& o) {
  double const H = o.geometry.height, T = o.geometry.period;
  double const B = o.model.reading == Reading::chi ? H * gamma0(o) : H;
  return {.V = o.model.V_star * B / T, .D = o.model.D_star * B * B / T};
}

}  // namespace shear_box
