// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <string>
#include <vector>

// What a simulation hands to the recorder: plain numbers on the host, SI units, in the order of the particles.
namespace drum {

/// The material at one time. x to the right, z upwards, y along the axis away from the viewer, all from the middle of
/// the drum.
struct State {
  double time = 0;  ///< s
  long steps = 0;
  std::vector<double> x, y, z;          ///< m; y may be empty in 2D
  std::vector<double> u, v, w;          ///< m/s; v may be empty in 2D
  std::vector<double> C;                ///< of small grains
  std::vector<double> shear_rate;       ///< 1/s, with the corrected gradient
  std::vector<double> number_density;   ///< sum_j V_j W_ij over material and wall; 1 is nominal
  std::vector<double> volume;           ///< m^Dim; empty: all spacing^Dim
  std::vector<double> V, D;             ///< of the segregation, m/s and m^2/s
  std::vector<double> gradient_V_rate;  ///< dC/dt from -F grad_g V, 1/s: figure 28's first
  std::vector<double> gradient_C_rate;  ///< dC/dt from -V F' grad_g C, 1/s
  std::vector<double> diffusion_rate;   ///< dC/dt from div(D grad C), the source q included, 1/s
  std::vector<double> stress;           ///< Pa, tension positive; xx, yy, zz, xy, yz, xz of each particle

  std::size_t size() const { return x.size(); }
};

/// What a finished (or stopped) run has to say of itself.
struct RunFigures {
  double time = 0;  ///< s
  long steps = 0, neighbour_builds = 0;
  int particles = 0, wall_particles = 0;
  std::map<std::string, long> steps_by_limit;
  std::string execution_space;
};

}  // namespace drum
