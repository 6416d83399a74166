// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/species_list.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

// Options of the rotating drum of Zhu, Peng & Wu (2024), section 6. Initialisers are defaults: their case EV with
// Table 1, but softer grains (stiffness_factor), which a CPU can afford. `drum --options` prints the table.
namespace drum {

enum class Ends { periodic, walled };

enum class Scheme { conservative, hcsr };

enum class Flux { symmetric, asymmetric };

enum class Closure { shear_rate, schlick, trewhela, constant, none };

enum class Precision { double_precision, single_precision };

enum class StressFilter { none, shepard, linear };

/// Models that keep the pressure consistent with the spacing of the particles; the paper has none.
enum class VolumeControl { none, memory, consistency };

enum class Filling { rings, cartesian };

struct Geometry {
  double radius = 0.035;     // m, R
  double fill_depth = 0.42;  // of 2 R; EN: 0.591
  double length = 0.01;      // m, in 3D
  Ends ends = Ends::periodic;
  double rotation_speed = 5;  // rpm, clockwise with x to the right and z upwards
  double gravity = 9.81;      // m/s^2
};

struct Material {
  double young = 10e6;  // Pa
  double poisson = 0.3;
  double density = 1500;        // kg/m^3, of the bed
  double grain_density = 2500;  // kg/m^3
  double mu_s = 0.382;
  double mu_d = 0.682;
  double I0 = 0.279;
  double d_small = 0.25e-3;        // m
  double d_large = 0.5e-3;         // m
  double stiffness_factor = 0.01;  // of young
};

struct Segregation {
  Scheme scheme = Scheme::conservative;
  Flux flux = Flux::symmetric;
  Closure closure = Closure::shear_rate;
  double C0 = 0.5;      // EN: 1/9
  double chi_V = 0.11;  // (2.7)
  double chi_D = 0.0307;
  double V = 2e-4;         // m/s, of the constant closure
  double D = 2e-8;         // m^2/s
  double interval = 1e-3;  // s
};

struct Numerics {
  int dimension = 2;
  double spacing = 1e-3;   // m, dr
  double smoothing = 1.5;  // h/dr
  Precision precision = Precision::double_precision;
  Filling filling = Filling::rings;
  double cfl = 0.4;
  double viscosity_speed = 0.5;  // m/s, alpha c_s
  StressFilter stress_filter = StressFilter::linear;
  int filter_period = 30;  // steps
  VolumeControl volume_control = VolumeControl::consistency;
  double volume_rate = 3;  // per shear strain
  int ranks = 1;
};

struct Time {
  double duration = 40;  // s
};

struct Output {
  double history_interval = 0.05;                                       // s
  double frame_interval = 0.5;                                          // s
  std::vector<double> profile_times = {1, 2, 3, 5, 6, 10, 20, 30, 40};  // s
  double profile_average = 0.5;                                         // s
  double checkpoints = 600;                                             // s of wall time
  std::string restart_from = {};
};

struct Options {
  Geometry geometry;
  Material material;
  Segregation segregation;
  scree::app::SpeciesList species;  // empty: d_small, d_large and C0
  Numerics numerics;
  Time time;
  Output output;
};

// Quantities that follow from the options by arithmetic alone, in SI units.

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
