// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <vector>

/// Options of the oscillating shear box of Zhu, Peng & Wu (2024), section 5. Initialisers are defaults, and the paper's
/// values wherever it gives one. `shear_box --options` prints the table.
namespace shear_box {

enum class Scheme { hcsr, conservative };

enum class Flux { symmetric, asymmetric };

/// The length B in [V] = V T/B, [D] = D T/B^2 of (5.2): the paper's chi values need one, its quoted times the other.
enum class Reading { chi, times };

enum class Closure { constant, shear_rate };

enum class Precision { double_precision, single_precision };

enum class DepthBoundary { periodic, walled };

struct Geometry {
  double height = 0.087;   // m, H
  double width = 0.0348;   // m, 0.4 H
  double depth = 0.051;    // m, in 3D
  double period = 13;      // s, T
  double amplitude = 30;   // degrees; gamma0 is its tangent
  double d_small = 0.004;  // m, diameter of the small grains
  double d_large = 0.008;  // m, of the large ones
  bool upright = false;
};

struct Model {
  Scheme scheme = Scheme::conservative;
  Flux flux = Flux::symmetric;
  std::optional<double> A = {}, kappa = {};  // by the name of the flux when not given
  Reading reading = Reading::chi;
  Closure closure = Closure::constant;
  double V_star = 3.0e-2;   // [V] of (5.2)
  double D_star = 1.01e-3;  // [D] of (5.2)
  double d_bar = 0.006;     // m, (5.5)
};

struct Numerics {
  int dimension = 2;
  double spacing = 0.02;   // dr/H
  double smoothing = 1.5;  // h/dr
  Precision precision = Precision::double_precision;
  DepthBoundary depth_boundary = DepthBoundary::periodic;
  double jitter = 0;  // of dr
  int seed = 1;
};

struct Time {
  double periods = 120;           // T
  double strain_per_step = 0.05;  // of the box
  double cfl_segregation = 0.1;   // of h/(A V)
  double cfl_diffusion = 0.1;     // of h^2/D
};

struct Output {
  std::vector<double> compared = {20, 40, 60, 80, 120};  // T
  double history_interval = 0.5;                         // T
  double frame_interval = 5;                             // T
  double reference_spacing = 0.005;                      // of H
};

struct Options {
  Geometry geometry;
  Model model;
  Numerics numerics;
  Time time;
  Output output;

  /// F = A C (1 - C)(1 - kappa C). The paper's A for the asymmetric flux gives both about the same maximum.
  double flux_amplitude() const { return model.A.value_or(model.flux == Flux::symmetric ? 1.0 : 1.6); }
  double flux_asymmetry() const { return model.kappa.value_or(model.flux == Flux::symmetric ? 0.0 : 0.89); }
};

}  // namespace shear_box
