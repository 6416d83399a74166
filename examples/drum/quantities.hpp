// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

// Quantities that follow from the options by arithmetic alone, in SI units.
namespace drum {

/// rad/s about the y axis, which points away from the viewer of the x-z plane: positive is clockwise.
inline double angular_velocity(Options const& o) { return o.geometry.rotation_speed * 2 * std::numbers::pi / 60; }

/// Half a turn of the drum, s: the paper's flow is steady after it. Infinite in a drum at rest.
inline double half_turn(Options const& o) { return std::numbers::pi / std::abs(angular_velocity(o)); }

/// h, m.
inline double smoothing_length(Options const& o) { return o.numerics.smoothing * o.numerics.spacing; }

/// Height of the initial, level surface over the axis, m: H in figure 15; negative below the axis.
inline double initial_level(Options const& o) { return (2 * o.geometry.fill_depth - 1) * o.geometry.radius; }

/// Approximate number of particles in the bed.
inline double number_of_grains(Options const& o) {
  double const R = o.geometry.radius, level = initial_level(o), dr = o.numerics.spacing;
  double const area = R * R * std::acos(-level / R) + level * std::sqrt(R * R - level * level);
  return o.numerics.dimension == 2 ? area / (dr * dr) : area * o.geometry.length / (dr * dr * dr);
}

/// Moduli of the bed with the stiffness factor applied, Pa.
inline double young(Options const& o) { return o.material.stiffness_factor * o.material.young; }
inline double bulk_modulus(Options const& o) { return young(o) / (3 * (1 - 2 * o.material.poisson)); }
inline double shear_modulus(Options const& o) { return young(o) / (2 * (1 + o.material.poisson)); }

/// Speed of compression waves, m/s: sqrt((K + 4 G/3)/rho).
inline double sound_speed(Options const& o) {
  return std::sqrt((bulk_modulus(o) + 4 * shear_modulus(o) / 3) / o.material.density);
}

/// alpha of (3.10) that gives the wanted alpha c_s.
inline double artificial_viscosity(Options const& o) { return o.numerics.viscosity_speed / sound_speed(o); }

/// The shear viscosity that the artificial one is equivalent to, Pa s: rho alpha c_s h/(2 (Dim + 2)) in the continuum
/// limit (Monaghan 2005), halved because it acts between approaching particles only.
inline double artificial_dynamic_viscosity(Options const& o) {
  return o.material.density * o.numerics.viscosity_speed * smoothing_length(o) / (4 * (o.numerics.dimension + 2));
}

/// F = A C (1 - C)(1 - kappa C) with the paper's values.
inline double flux_amplitude(Options const& o) { return o.segregation.flux == Flux::symmetric ? 1.0 : 1.6; }
inline double flux_asymmetry(Options const& o) { return o.segregation.flux == Flux::symmetric ? 0.0 : 0.89; }

}  // namespace drum
