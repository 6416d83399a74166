// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "species_closure.hpp"

#include <algorithm>
#include <string>

namespace scree {

/// N sizes of one density, by their ratios: $S_{kl} = S \dot\gamma \min(d_k, d_l) \ln(d_l/d_k)$ and $D = A \dot\gamma
/// d^2$ with $d = \sum_k C_k d_k$. The smaller species of a pair moves along gravity. S = 0.26 comes from simulations
/// of bounded heaps with two sizes whose ratio is 1 to 3 (Schlick et al. 2015; Zhu et al. 2024, eq. 5.8). Each pair of
/// more than two sizes segregates as in a mixture of two (Deng et al. 2018). A = 0.042 is the value that published
/// programs use with it.
template <int N>
struct SizeRatioClosure {
  static constexpr int species = N;
  Vec<N, double> diameters = zero<Vec<N, double>>();  ///< d_k, m
  double S = 0.26;
  double A = 0.042;

  using reads = Fields<Concentrations<N>, ShearRate>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  /// Throws std::invalid_argument where a parameter is out of range.
  void check() const {
    check_diameters<N>(diameters, "SizeRatioClosure");
    check_setting(S >= 0 && std::isfinite(S), "S of SizeRatioClosure", S, "0 or more");
    check_setting(A >= 0 && std::isfinite(A), "A of SizeRatioClosure", A, "0 or more");
  }
  /// A warning for a ratio of sizes outside of the range that S was fitted to; empty within it.
  std::string warning() const {
    double least = diameters[0], largest = diameters[0];
    for (int k = 1; k < N; ++k) least = std::min(least, diameters[k]), largest = std::max(largest, diameters[k]);
    return warning_of_size_ratio("SizeRatioClosure", largest / least, 3);
  }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    double const rate = double(i[shear_rate]), d = mean_of_species(i[concentrations<N>], diameters);
    auto& velocities = out[segregation_velocities<N>];
    for_each_pair_of_species<N>([&](auto k, auto l, auto pair) {
      double const smaller = Kokkos::min(diameters[k], diameters[l]);
      velocities[pair] = Real(S * rate * smaller * Kokkos::log(diameters[l] / diameters[k]));
    });
    out[diffusivity] = Real(A * rate * d * d);
  }
};

}  // namespace scree
