// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "species_closure.hpp"

#include <algorithm>
#include <string>

namespace scree {

/// Returns `factor` times $\min(d_k, d_l) \ln(d_l/d_k)$: the speed along gravity at which grains of diameter d_k (m)
/// move through grains of diameter d_l (m) because of their sizes alone; m/s if the factor is in 1/s.
SCREE_FN double speed_of_sizes(double factor, double d_k, double d_l) {
  return factor * Kokkos::min(d_k, d_l) * Kokkos::log(d_l / d_k);
}

/// Grains of N sizes and one density: $S_{kl} = S \dot\gamma \min(d_k, d_l) \ln(d_l/d_k)$ and $D = A \dot\gamma d^2$
/// with $d = \sum_k C_k d_k$. The smaller species of a pair moves along gravity. S = 0.26 comes from simulations of
/// bounded heaps with two sizes whose ratio is 1 to 3 (Schlick et al. 2015; Zhu et al. 2024, eq. 5.8). In mixtures of
/// more than two sizes, each pair segregates as in a mixture of two (Deng et al. 2018). A = 0.042 is the value that
/// published programs use with this S.
template <int N>
struct SizeRatioClosure {
  static constexpr int species = N;
  Vec<N, double> diameters = zero<Vec<N, double>>();  ///< d_k, m
  double S = 0.26;
  double A = 0.042;

  static constexpr int factors = 1;
  using factors_of = SizeRatioClosure;
  using reads = Fields<Concentrations<N>, ShearRate>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  /// Throws std::invalid_argument if a parameter is out of range; the message names `model`.
  void check(char const* model = "SizeRatioClosure") const {
    check_diameters<N>(diameters, model);
    check_setting(S >= 0 && std::isfinite(S), detail::formatted("S of %s", model).c_str(), S, "0 or more");
    check_setting(A >= 0 && std::isfinite(A), detail::formatted("A of %s", model).c_str(), A, "0 or more");
  }
  /// Returns a warning, which names `model`, if the size ratio is beyond the range to which S was fitted; otherwise an
  /// empty text.
  std::string warning(char const* model = "SizeRatioClosure") const {
    double least = diameters[0], largest = diameters[0];
    for (int k = 1; k < N; ++k) least = std::min(least, diameters[k]), largest = std::max(largest, diameters[k]);
    return warning_of_size_ratio(model, largest / least, 3);
  }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    double const rate = double(i[shear_rate]);
    for_each_pair_of_species<N>([&](auto k, auto l, auto pair) {
      out[segregation_velocities<N>][pair] = Real(speed_of_sizes(S * rate, diameters[k], diameters[l]));
    });
    out[diffusivity] = Real(diffusivity_at(i));
  }
  template <class I>
  SCREE_FN Vec<1, double> factors_at(I const& i) const {
    return Vec<1, double>(double(i[fields::shear_rate]));
  }
  template <class I>
  SCREE_FN double diffusivity_at(I const& i) const {
    double const d = mean_of_species(i[fields::concentrations<N>], diameters);
    return A * double(i[fields::shear_rate]) * d * d;
  }
  Vec<1, double> speeds_of_pair(int k, int l) const {
    return Vec<1, double>(speed_of_sizes(S, diameters[k], diameters[l]));
  }
};

}  // namespace scree
