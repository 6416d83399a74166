// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "species_closure.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace scree {

/// N species that differ in size and density: $S_{kl} = \dot\gamma [S \min(d_k, d_l) \ln(d_l/d_k) + S_\rho d
/// \ln(\rho_k/\rho_l)]$ and $D = A \dot\gamma d^2$ with $d = \sum_k C_k d_k$. Small and heavy grains move along
/// gravity. The first part is that of SizeRatioClosure. That grains which differ in both segregate in proportion to the
/// shear rate, and change their direction with the mixture, was found in simulations (Duan et al. 2020, abstract); the
/// form of the second part is not confirmed, and its factor is yours. A mixture whose mean diameter is $d = (S/S_\rho)
/// \min(d_k, d_l) \ln(d_l/d_k)/\ln(\rho_l/\rho_k)$ of two species does not segregate.
template <int N>
struct SizeDensityClosure {
  static constexpr int species = N;
  Vec<N, double> diameters = zero<Vec<N, double>>();  ///< d_k, m
  Vec<N, double> densities = zero<Vec<N, double>>();  ///< rho_k, kg/m^3; only their ratios matter
  double S_density = 0;                               ///< S_rho, -, above 0
  double S = 0.26;
  double A = 0.042;

  using reads = Fields<Concentrations<N>, ShearRate>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  /// Throws std::invalid_argument where a parameter is out of range.
  void check() const {
    check_diameters<N>(diameters, "SizeDensityClosure");
    check_densities<N>(densities, "SizeDensityClosure");
    check_setting(S_density > 0 && std::isfinite(S_density), "S_density of SizeDensityClosure", S_density,
                  "above 0; it has no default, because no published value was read");
    check_setting(S >= 0 && std::isfinite(S), "S of SizeDensityClosure", S, "0 or more");
    check_setting(A >= 0 && std::isfinite(A), "A of SizeDensityClosure", A, "0 or more");
  }
  /// A warning for a ratio of sizes outside of the range that S was fitted to; empty within it.
  std::string warning() const {
    double least = diameters[0], largest = diameters[0];
    for (int k = 1; k < N; ++k) least = std::min(least, diameters[k]), largest = std::max(largest, diameters[k]);
    return warning_of_size_ratio("S of SizeDensityClosure", largest / least, 3);
  }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    double const rate = double(i[shear_rate]), d = mean_of_species(i[concentrations<N>], diameters);
    auto& velocities = out[segregation_velocities<N>];
    for_each_pair_of_species<N>([&](auto k, auto l, auto pair) {
      double const smaller = Kokkos::min(diameters[k], diameters[l]);
      double const of_size = S * smaller * Kokkos::log(diameters[l] / diameters[k]);
      double const of_density = S_density * d * Kokkos::log(densities[k] / densities[l]);
      velocities[pair] = Real(rate * (of_size + of_density));
    });
    out[diffusivity] = Real(A * rate * d * d);
  }
};

}  // namespace scree
