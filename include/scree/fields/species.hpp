// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "field.hpp"

#include <cmath>

// Fields of a mixture of N species of grains, such as N grain sizes. For two sizes, Concentration (fields/standard.hpp)
// is enough.
namespace scree {

/// The base of a field with N numbers per particle, one for each species.
template <int N, Label Name, Label Unit>
struct PerSpecies : Labelled<Name, Unit> {
  static_assert(N >= 2, "a mixture has two species or more");
  template <int Dim, class Real>
  using value = Vec<N, Real>;
};

/// The rates of the concentrations of the species.
template <int N>
struct ConcentrationRates : PerSpecies<N, "concentration rates", "1/s"> {};
/// The volume concentrations C_k of the species, each from 0 to 1, with a sum of 1.
template <int N>
struct Concentrations : PerSpecies<N, "concentrations", "1"> {
  using rate = ConcentrationRates<N>;
  static constexpr bool compensated = true;
};

namespace fields {
template <int N>
inline constexpr ConcentrationRates<N> concentration_rates{};
template <int N>
inline constexpr Concentrations<N> concentrations{};
}  // namespace fields

/// Returns the mean of a value over the species, $\sum_k C_k v_k$.
template <int N, class Real>
SCREE_FN double mean_of_species(Vec<N, Real> const& C, Vec<N, double> const& values) {
  double sum = 0;
  for (int k = 0; k < N; ++k) sum += double(C[k]) * values[k];
  return sum;
}

/// Throws std::invalid_argument unless the diameters (m) of all species of a model are finite and above 0.
template <int N>
void check_diameters(Vec<N, double> const& diameters, char const* model) {
  for (int k = 0; k < N; ++k)
    check_setting(diameters[k] > 0 && std::isfinite(diameters[k]),
                  detail::formatted("diameters[%d] (m) of %s", k, model).c_str(), diameters[k], "above 0");
}

/// Throws std::invalid_argument unless the densities (kg/m^3) of all species of a model are finite and above 0.
template <int N>
void check_densities(Vec<N, double> const& densities, char const* model) {
  for (int k = 0; k < N; ++k)
    check_setting(densities[k] > 0 && std::isfinite(densities[k]),
                  detail::formatted("densities[%d] (kg/m^3) of %s", k, model).c_str(), densities[k], "above 0");
}

}  // namespace scree
