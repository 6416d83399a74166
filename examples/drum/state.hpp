// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace drum {

/// The material at one time. x to the right, z upwards, y along the axis away from the viewer, all from the middle of
/// the drum.
struct State {
  double time = 0;  ///< s
  long steps = 0;
  std::vector<double> x, y, z;          ///< m; y may be empty in 2D
  std::vector<double> u, v, w;          ///< m/s; v may be empty in 2D
  std::vector<double> C;                ///< of small grains, of the smallest ones of a list of sizes
  std::vector<double> shear_rate;       ///< 1/s, with the corrected gradient
  std::vector<double> number_density;   ///< sum_j V_j W_ij over material and wall; 1 is nominal
  std::vector<double> volume;           ///< m^Dim; empty: all spacing^Dim
  std::vector<double> V, D;             ///< of the segregation, m/s and m^2/s
  std::vector<double> gradient_V_rate;  ///< dC/dt from -F grad_g V, 1/s: figure 28's first
  std::vector<double> gradient_C_rate;  ///< dC/dt from -V F' grad_g C, 1/s
  std::vector<double> diffusion_rate;   ///< dC/dt from div(D grad C), the source q included, 1/s
  /// Concentration of each size of a list; none without a list, and V and rates of C only without one.
  std::vector<std::vector<double>> species = {};
  std::vector<double> stress;  ///< Pa, tension positive; xx, yy, zz, xy, yz, xz of each particle
  /// Measures of mixing: intensity of segregation (1: apart, 0: mixed), and Lacey's index in cells of four spacings.
  double intensity = std::numeric_limits<double>::quiet_NaN(), lacey = std::numeric_limits<double>::quiet_NaN();

  std::size_t size() const { return x.size(); }
};

}  // namespace drum
