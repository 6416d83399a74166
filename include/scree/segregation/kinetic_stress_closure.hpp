// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "species_closure.hpp"

namespace scree {

/// Grains of N sizes and one density that share the kinetic stress of the flow in proportion to 1/d_k (after Marks et
/// al. 2012). Grains of species k move along gravity at $c \dot\gamma (1/(d_k m) - 1)$ with $m = \sum_l C_l/d_l$, so
/// that $S_{kl} = c \dot\gamma (1/d_k - 1/d_l)/m$. The diffusivity is $D = A \dot\gamma d^2$ with $d = \sum_k C_k d_k$.
/// The length c has not been fitted to any grains: you must choose it. The increase of the kinetic stress along gravity
/// is assumed to be proportional to the shear rate.
///
/// The equilibrium does not depend on the shear rate.
template <int N>
struct KineticStressClosure {
  static constexpr int species = N;
  Vec<N, double> diameters = zero<Vec<N, double>>();  ///< d_k, m
  double c = 0;                                       ///< length, m, above 0
  double A = 0.042;

  static constexpr int factors = 1;
  using factors_of = KineticStressClosure;
  using reads = Fields<Concentrations<N>, ShearRate>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_diameters<N>(diameters, "KineticStressClosure");
    check_setting(c > 0 && std::isfinite(c), "c (m) of KineticStressClosure", c, "above 0");
    check_setting(A >= 0 && std::isfinite(A), "A of KineticStressClosure", A, "0 or more");
  }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    write_velocities(*this, i, out);
  }
  template <class I>
  SCREE_FN Vec<1, double> factors_at(I const& i) const {
    auto const& C = i[fields::concentrations<N>];
    double m = 0;
    for (int k = 0; k < N; ++k) m += double(C[k]) / diameters[k];
    return Vec<1, double>(c * double(i[fields::shear_rate]) / m);
  }
  template <class I>
  SCREE_FN double diffusivity_at(I const& i) const {
    double const d = mean_of_species(i[fields::concentrations<N>], diameters);
    return A * double(i[fields::shear_rate]) * d * d;
  }
  SCREE_FN Vec<1, double> speeds_of_pair(int k, int l) const {
    return Vec<1, double>(1 / diameters[k] - 1 / diameters[l]);
  }
};

}  // namespace scree
