// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>

// Experimental results for columns of dry grains with the aspect ratio a = H0/L0 (height over width, or over radius).
namespace column_collapse {

struct Band {
  double least = 0, greatest = 0;
  bool contains(double value) const { return value >= least && value <= greatest; }
};

/// (L - L0)/L0 in channels: lower bound, Lube et al. (2005), 1.2 a up to the change of regime between a = 1.8 and 2.8,
/// then 1.9 a^(2/3); upper bound, Lajeunesse et al. (2005), 1.8 a up to a = 3, then 2.3 a^(2/3).
inline Band run_out_in_channels(double a) {
  double const power = std::pow(a, 2.0 / 3);
  return {a < 2.8 ? 1.2 * a : 1.9 * power, a < 3 ? 1.8 * a : 2.3 * power};
}

/// The same for cylinders that spread in all directions: Lube et al. (2004), 1.24 a up to a = 1.7, then 1.6 sqrt(a),
/// with 20 % on either side for the scatter and the reading of the rim.
inline Band run_out_of_cylinders(double a) {
  double const found = a < 1.7 ? 1.24 * a : 1.6 * std::sqrt(a);
  return {0.8 * found, 1.2 * found};
}

template <int Dim>
Band run_out_band(double a) {
  return Dim == 2 ? run_out_in_channels(a) : run_out_of_cylinders(a);
}

}  // namespace column_collapse
