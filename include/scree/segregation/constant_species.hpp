// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "species_closure.hpp"

namespace scree {

/// Constant speeds of N species along gravity, S_kl = v_k - v_l, and a constant D. In equilibrium the concentrations
/// are $C_k = a_k \exp(v_k s/D)/\sum_l a_l \exp(v_l s/D)$ at the distance s along gravity.
template <int N>
struct ConstantSpecies {
  static constexpr int species = N;
  Vec<N, double> velocities = zero<Vec<N, double>>();  ///< v_k, m/s; only their differences matter
  double diffusivity = 0;                              ///< D, m^2/s

  static constexpr int factors = 1;
  using factors_of = ConstantSpecies;
  using reads = Fields<>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    for (int k = 0; k < N; ++k)
      check_setting(std::isfinite(velocities[k]),
                    detail::formatted("velocities[%d] (m/s) of ConstantSpecies", k).c_str(), velocities[k], "finite");
    check_setting(diffusivity >= 0 && std::isfinite(diffusivity), "diffusivity (m^2/s) of ConstantSpecies", diffusivity,
                  "0 or more");
  }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    write_velocities(*this, i, out);
  }
  template <class I>
  SCREE_FN Vec<1, double> factors_at(I const&) const {
    return Vec<1, double>(1.0);
  }
  template <class I>
  SCREE_FN double diffusivity_at(I const&) const {
    return diffusivity;
  }
  SCREE_FN Vec<1, double> speeds_of_pair(int k, int l) const { return Vec<1, double>(velocities[k] - velocities[l]); }
};

}  // namespace scree
