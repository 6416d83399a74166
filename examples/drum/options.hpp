// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

/// Options of the rotating drum of Zhu, Peng & Wu (2024), section 6. Initialisers are defaults: their case EV with
/// Table 1, but softer grains (stiffness_factor), which a CPU can afford. `drum --options` prints the table.
namespace drum {

enum class Ends { periodic, walled };

enum class Scheme { conservative, hcsr };

enum class Flux { symmetric, asymmetric };

enum class Closure { shear_rate, constant, none };

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
};

struct Time {
  double duration = 40;      // s
  std::string restart_from;  // a checkpoint
};

struct Output {
  double history_interval = 0.05;                                       // s
  double frame_interval = 0.5;                                          // s
  std::vector<double> profile_times = {1, 2, 3, 5, 6, 10, 20, 30, 40};  // s
  double profile_average = 0.5;                                         // s
  double checkpoint_interval = 600;                                     // s of wall clock
};

struct Options {
  Geometry geometry;
  Material material;
  Segregation segregation;
  Numerics numerics;
  Time time;
  Output output;
};

}  // namespace drum
