// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "intensity.hpp"
#include "samples.hpp"

#include <limits>
#include <stdexcept>
#include <vector>

namespace scree {

/// Settings of the samples for Lacey's index.
struct LaceySettings {
  double cell = 0;    ///< edge of the cells, m; 0: four spacings
  double fill = 0.5;  ///< a cell is a sample if its particles fill at least this share of it
  /// The bed volume per grain of each kind (m^dim): the volume of a grain divided by the solid fraction. One number for
  /// all kinds, or one for each kind. If `grains` is empty, samples have infinitely many grains.
  std::vector<double> grains = {};
};

/// Lacey's index, with the variances from which it is computed.
struct LaceyIndex {
  double index = std::numeric_limits<double>::quiet_NaN();  ///< 0: separated, 1: mixed at random; NaN for a single kind
  double variance = 0;                                      ///< variance s^2 of the samples, summed over the kinds
  double separated = 0;                                     ///< variance s_0^2 of separated kinds
  double random = 0;                                        ///< variance s_r^2 of a random mixture
  int samples = 0;
};

namespace detail {

/// Returns the variance of the shares of the kinds in samples of a random mixture, summed over the kinds and multiplied
/// by the volume of a sample (m^dim): $\sum_k P_k ((1 - 2 P_k) v_k + P_k \bar v)$ with $\bar v = \sum_l P_l v_l$, where
/// v_k is the bed volume per grain of kind k.
template <int Kinds>
double variance_of_random(Vec<Kinds, double> const& shares, std::vector<double> const& grains) {
  if (grains.empty()) return 0;
  auto const v = [&](int k) { return grains[grains.size() == 1 ? 0 : std::size_t(k)]; };
  double mean = 0, sum = 0;
  for (int k = 0; k < Kinds; ++k) mean += shares[k] * v(k);
  for (int k = 0; k < Kinds; ++k) sum += shares[k] * ((1 - 2 * shares[k]) * v(k) + shares[k] * mean);
  return sum;
}

[[gnu::cold]] inline void check_lacey(LaceySettings const& settings, int kinds) {
  check_setting(settings.cell >= 0, "cell (m) of Lacey's index", settings.cell, "0 or more");
  check_setting(settings.fill > 0 && settings.fill <= 1, "fill of Lacey's index", settings.fill,
                "above 0 and at most 1");
  if (settings.grains.size() > 1 && settings.grains.size() != std::size_t(kinds))
    throw std::invalid_argument("scree: grains of Lacey's index has " + std::to_string(settings.grains.size()) +
                                " volumes; it needs one for all kinds, or one for each of the " +
                                std::to_string(kinds));
  for (double const volume : settings.grains)
    check_setting(volume > 0 && std::isfinite(volume), "a volume (m^dim) in grains of Lacey's index", volume,
                  "above 0");
}

}  // namespace detail

/// Returns Lacey's (1954) index of mixing for any number of kinds: $(s_0^2 - s^2)/(s_0^2 - s_r^2)$. Here s^2 is the
/// variance of the shares in samples, weighted by the volume of the samples, about the shares P_k of the whole
/// material; $s_0^2 = \sum_k P_k (1 - P_k)$ is the variance of separated kinds; and s_r^2 is the variance of a random
/// mixture.
///
/// A sample is a cell of a grid that is fixed in space. Particles are not grains: the concentration is a continuous
/// field, whose variance can fall to 0, below the variance of any mixture of grains. Therefore, s_r^2 is 0 unless the
/// volumes of the grains are given. It is then the variance that grains drawn one by one would have
/// (docs/theory/mixing.md), and an index above 1 means that the field is smoother than such a random mixture. The index
/// depends on the cells: compare only values for equal cells.
///
/// The index is computed on the device and is bitwise identical on any number of ranks (WholeBody). It is NaN if no
/// cell is filled to the share `fill`. Throws std::invalid_argument for settings that are out of range, for instance a
/// cell smaller than the spacing. By default, the kinds are the species in the material.
template <class S, class Kinds = kinds_in<S>>
LaceyIndex lacey_index(S const& solver, LaceySettings settings = {}, Kinds const& kinds = {}) {
  LaceyIndex found;
  if constexpr (detail::explain_kinds<Kinds, S>()) {
    detail::check_lacey(settings, Kinds::kinds);
    if (settings.cell == 0) settings.cell = 4 * solver.resolution().spacing;
    auto const whole = detail::means_of_kinds(solver, kinds, "Lacey's index");
    double const full = std::pow(settings.cell, S::policy::dim);
    double volume = 0;
    for (auto const& sample : samples_of(solver, settings.cell, kinds)) {
      if (sample.volume < settings.fill * full) continue;
      for (int k = 0; k < Kinds::kinds; ++k) found.variance += sample.volume * sq(sample.shares[k] - whole.mean[k]);
      volume += sample.volume;
      ++found.samples;
    }
    if (found.samples == 0) return found;
    found.variance /= volume;
    found.separated = detail::variance_of_separated(whole.mean);
    // The mean over samples of weight V of a variance proportional to 1/V.
    found.random = detail::variance_of_random(whole.mean, settings.grains) * found.samples / volume;
    if (found.separated > 0) found.index = (found.separated - found.variance) / (found.separated - found.random);
  }
  return found;
}

}  // namespace scree
