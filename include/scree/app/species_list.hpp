// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/species.hpp"
#include "schema.hpp"

#include <algorithm>
#include <cmath>
#include <string>
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
  /// Returns the number of sizes; 0 without a list.
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

namespace detail {

inline std::string fault_of_count(SpeciesList const& list) {
  int const n = list.count();
  if (n == 0 || (n >= 2 && n <= most_species)) return "";
  return fmt::format("{} diameter{}; a list has 2 to {}, and an empty one is no list", n, n == 1 ? "" : "s",
                     most_species);
}
inline std::string fault_of_shares(SpeciesList const& list) {
  if (list.shares.size() != list.diameters.size())
    return fmt::format("{} shares for {} species.diameters", list.shares.size(), list.diameters.size());
  double sum = 0;
  for (double const share : list.shares) sum += share;
  if (list.empty() || std::abs(sum - 1) <= 1e-6) return "";
  return fmt::format("they add up to {:.7g}, not to 1", sum);
}

}  // namespace detail

/// Adds a section "species" with the list. `order` is a text that explains the order of the list; `replaced` names the
/// options that a list replaces.
template <class T>
void describe_species(Schema<T>& schema, SpeciesList T::*list, std::string const& order,
                      std::vector<std::string> const& replaced) {
  schema.section("species", list, fmt::format("Instead of two sizes of grains a list of 2 to {}", most_species))
      .add("diameters", &SpeciesList::diameters,
           {.unit = "m", .range = {1e-6, 0.1}, .meaning = "of the grains of each size; []: two sizes. " + order})
      .add("shares", &SpeciesList::shares,
           {.range = {0, 1}, .meaning = "volume of the grains of each size over that of all; they add up to 1"});
  schema.complain({"species.diameters", [=](T const& o) { return detail::fault_of_count(o.*list); }});
  schema.complain({"species.shares", [=](T const& o) { return detail::fault_of_shares(o.*list); }});
  for (auto const& key : replaced)
    schema.only_when(
        {key, [=](T const& o) { return (o.*list).empty(); }, "has no effect while species.diameters is given"});
}

}  // namespace scree::app
