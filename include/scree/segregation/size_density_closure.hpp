// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "size_ratio_closure.hpp"

#include <cmath>
#include <string>

namespace scree {

/// N species that differ in size and density: $S_{kl} = \dot\gamma [S \min(d_k, d_l) \ln(d_l/d_k) + S_\rho d
/// \ln(\rho_k/\rho_l)]$ and $D = A \dot\gamma d^2$ with $d = \sum_k C_k d_k$. Small and heavy grains move along
/// gravity. The first term of S_kl is that of SizeRatioClosure. In simulations, grains that differ in both size and
/// density segregate in proportion to the shear rate, and their direction depends on the mixture (Duan et al. 2020,
/// abstract). The form of the second term is not confirmed, and you must choose its factor S_rho. A mixture of two
/// species does not segregate if its mean diameter is $d = (S/S_\rho) \min(d_k, d_l) \ln(d_l/d_k)/\ln(\rho_l/\rho_k)$.
template <int N>
struct SizeDensityClosure {
  static constexpr int species = N;
  Vec<N, double> diameters = zero<Vec<N, double>>();  ///< d_k, m
  Vec<N, double> densities = zero<Vec<N, double>>();  ///< rho_k, kg/m^3; only their ratios matter
  double S_density = 0;                               ///< S_rho, dimensionless, above 0
  double S = 0.26;
  double A = 0.042;

  static constexpr int factors = 2;
  using factors_of = SizeDensityClosure;
  using reads = Fields<Concentrations<N>, ShearRate>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    of_sizes().check("SizeDensityClosure");
    check_densities<N>(densities, "SizeDensityClosure");
    check_setting(S_density > 0 && std::isfinite(S_density), "S_density of SizeDensityClosure", S_density,
                  "above 0; it has no default, because no published value was read");
  }
  /// Returns a warning if the size ratio is beyond the range to which S was fitted; otherwise an empty text.
  std::string warning() const { return of_sizes().warning("S of SizeDensityClosure"); }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    write_velocities(*this, i, out);
  }
  template <class I>
  SCREE_FN Vec<2, double> factors_at(I const& i) const {
    double const rate = double(i[fields::shear_rate]);
    return {rate, rate * mean_of_species(i[fields::concentrations<N>], diameters)};
  }
  template <class I>
  SCREE_FN double diffusivity_at(I const& i) const {
    return of_sizes().diffusivity_at(i);
  }
  SCREE_FN Vec<2, double> speeds_of_pair(int k, int l) const {
    return {speed_of_sizes(S, diameters[k], diameters[l]), S_density * Kokkos::log(densities[k] / densities[l])};
  }

 private:
  SCREE_FN SizeRatioClosure<N> of_sizes() const { return {diameters, S, A}; }
};

}  // namespace scree
