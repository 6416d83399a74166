// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/species.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// A list of sizes of grains in the case file of a program, in place of small and large ones.
namespace scree::app {

/// The largest number of sizes in a list: programs have one model for all lists of 2 to this number. Species beyond
/// those of a list are absent: their concentrations are 0 everywhere and stay so, which changes no result of the
/// others.
inline constexpr int most_species = 5;

/// Sizes of grains, in any order. Without diameters there is no list, and the program has its two sizes.
struct SpeciesList {
  std::vector<double> diameters = {};  ///< m
  std::vector<double> shares = {};     ///< of the volume of all grains

  /// Whether there is no list.
  bool empty() const { return diameters.empty(); }
  /// 0 without a list.
  int count() const { return int(diameters.size()); }
  /// The number, from 0, of the smallest grains; the list is not empty.
  int smallest() const { return int(std::ranges::min_element(diameters) - diameters.begin()); }

  using Mixture = Vec<most_species, double>;
  /// For models of `most_species` species; absent ones have the diameter of the last.
  Mixture all_diameters() const {
    Mixture d;
    for (int k = 0; k < most_species; ++k) d[k] = diameters[std::size_t(std::min(k, count() - 1))];
    return d;
  }
  /// The mixture of all grains. Its sum is 1 to rounding.
  Mixture mixed() const {
    double total = 0;
    for (double const share : shares) total += share;
    Mixture C = Mixture::Zero();
    for (int k = 0; k < count(); ++k) C[k] = shares[std::size_t(k)] / total;
    return C;
  }
  /// Layers in the order of the list: the mixture of a particle that fills the bed from the share `from` of its volume
  /// to the share `to`.
  Mixture layer(double from, double to) const {
    Mixture const all = mixed();
    Mixture C;
    double below = 0;
    for (int k = 0; k < most_species; ++k) {
      double const above = below + all[k];
      C[k] = std::max(0.0, std::min(to, above) - std::max(from, below));
      below = above;
    }
    // The borders of the last layer and of the bed differ by rounding.
    return C.sum() > 0 ? Mixture(C / C.sum()) : Mixture(Mixture::Unit(count() - 1));
  }
};

}  // namespace scree::app
