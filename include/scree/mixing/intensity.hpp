// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/sums.hpp"
#include "kinds.hpp"

#include <limits>

namespace scree {

/// The separation of the kinds of grains, evaluated particle by particle.
template <int Kinds>
struct SegregationIntensity {
  double value = std::numeric_limits<double>::quiet_NaN();   ///< 0: mixed, 1: separated; NaN for a single kind
  Vec<Kinds, double> mean = zero<Vec<Kinds, double>>();      ///< share of each kind in the material
  Vec<Kinds, double> variance = zero<Vec<Kinds, double>>();  ///< variance of each share
  double volume = 0;                                         ///< volume of the material, m^dim
};

namespace detail {

/// The terms V (C_k - mean_k)^2 of the variances of the shares.
template <class Kinds>
struct SquaresOfKinds {
  static constexpr int count = Kinds::kinds;
  using reads = Merge<Fields<Volume>, reads_of<Kinds>>;
  Kinds kinds;
  Vec<count, double> mean;
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    auto const C = kinds(i);
    Vec<count, double> terms;
    for (int k = 0; k < count; ++k) terms[k] = double(i[fields::volume]) * sq(C[k] - mean[k]);
    return terms;
  }
};

/// Returns $\sum_k P_k (1 - P_k)$, which for two separated kinds is twice the variance of a share.
template <int Kinds>
double variance_of_separated(Vec<Kinds, double> const& shares) {
  double sum = 0;
  for (int k = 0; k < Kinds; ++k) sum += shares[k] * (1 - shares[k]);
  return sum;
}

template <class S, class Kinds>
SegregationIntensity<Kinds::kinds> means_of_kinds(S const& solver, Kinds const& kinds, char const* what) {
  SegregationIntensity<Kinds::kinds> found;
  auto const volumes = sums_over(solver.whole(), VolumesOfKinds<Kinds>{kinds}, what);
  found.volume = volumes[0];
  for (int k = 0; k < Kinds::kinds; ++k) found.mean[k] = volumes[0] > 0 ? volumes[k + 1] / volumes[0] : 0;
  return found;
}

}  // namespace detail

/// Returns the intensity of segregation of Danckwerts (1952) for any number of kinds: the volume-weighted variance of
/// their shares, divided by the variance of separated kinds, $\sum_k \overline{(C_k - P_k)^2}/\sum_k P_k (1 - P_k)$
/// with the mean shares P_k. The intensity is 1 if each particle contains only one kind, and 0 if all particles have
/// the same shares. Motion without diffusion does not change the intensity. Particles are the samples, so the intensity
/// depends on their spacing if C varies within a spacing. Computed on the device, bitwise identical on any number of
/// ranks (WholeBody). Throws std::runtime_error if a value is not finite. By default, the kinds are the species in the
/// material.
template <class S, class Kinds = kinds_in<S>>
auto segregation_intensity(S const& solver, Kinds const& kinds = {}) {
  if constexpr (detail::explain_kinds<Kinds, S>()) {
    char const* const what = "the intensity of segregation";
    auto found = detail::means_of_kinds(solver, kinds, what);
    auto const squares = sums_over(solver.whole(), detail::SquaresOfKinds<Kinds>{kinds, found.mean}, what);
    double sum = 0;
    for (int k = 0; k < Kinds::kinds; ++k)
      found.variance[k] = found.volume > 0 ? squares[k] / found.volume : 0, sum += found.variance[k];
    double const apart = detail::variance_of_separated(found.mean);
    if (apart > 0) found.value = sum / apart;
    return found;
  } else {
    return SegregationIntensity<2>();
  }
}

}  // namespace scree
