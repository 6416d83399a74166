// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

/// Options of a flow of grains down a rough slope. `inclined_flow --options` prints the table.
namespace inclined_flow {

struct Slope {
  double angle = 24;       // degrees
  double diameter = 5e-4;  // m, of the grains
  double depth = 10;       // of grains
  double start = 0.7;      // of the exact velocity
};

struct Model {
  double mu_s = 0.382;
  double mu_d = 0.682;
  double I0 = 0.279;
  double viscosity_speed = 0.05;  // m/s, alpha c_s of the artificial viscosity
};

struct Numerics {
  int rows = 20;           // of particles over the depth
  double sound_speed = 4;  // m/s
  double cfl = 0.4;
};

struct Output {
  double duration = 4;     // settling times of the exact flow
  double interval = 0.25;  // settling times
};

struct Options {
  Slope slope;
  Model model;
  Numerics numerics;
  Output output;
};

}  // namespace inclined_flow
