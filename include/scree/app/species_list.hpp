// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/species.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// A list of grain sizes in the case file of a program, in place of small and large grains.
namespace scree::app {

/// The largest number of sizes in a list: programs have one model for all lists of 2 to this number of sizes. Species
/// beyond the end of a list are absent: their concentrations are and remain 0 everywhere, which does not affect the
/// results of the other species.
inline constexpr int most_species = 5;

/// Grain sizes in any order. Without diameters there is no list, and the program uses its two sizes.
struct SpeciesList {
  std::vector<double> diameters = {};  ///< m
  std::vector<double> shares = {};     ///< share of each size in the volume of all grains

  /// Whether there is no list.
  bool empty() const { return diameters.empty(); }
  /// Returns the number of grain sizes; 0 if there is no list.
  int count() const { return int(diameters.size()); }
  /// Returns the index of the smallest grains in the list, which must not be empty.
  int smallest() const { return int(std::ranges::min_element(diameters) - diameters.begin()); }

  using Mixture = Vec<most_species, double>;
  /// Returns the diameters (m) for models of `most_species` species; absent species have the diameter of the last one.
  Mixture all_diameters() const {
    Mixture d;
    for (int k = 0; k < most_species; ++k) d[k] = diameters[std::size_t(std::min(k, count() - 1))];
    return d;
  }
  /// Returns the mixture of all grains. Its sum is 1, apart from rounding errors.
  Mixture mixed() const {
    double total = 0;
    for (double const share : shares) total += share;
    Mixture C = Mixture::Zero();
    for (int k = 0; k < count(); ++k) C[k] = shares[std::size_t(k)] / total;
    return C;
  }
  /// Returns the mixture of a particle that fills a bed from the share `from` of its volume to the share `to`. The bed
  /// has layers in the order of the list.
  Mixture layer(double from, double to) const {
    Mixture const all = mixed();
    Mixture C;
    double below = 0;
    for (int k = 0; k < most_species; ++k) {
      double const above = below + all[k];
      C[k] = std::max(0.0, std::min(to, above) - std::max(from, below));
      below = above;
    }
    // The tops of the last layer and of the bed may differ by rounding errors; a particle between them gets the last
    // species.
    return C.sum() > 0 ? Mixture(C / C.sum()) : Mixture(Mixture::Unit(count() - 1));
  }
};

}  // namespace scree::app
