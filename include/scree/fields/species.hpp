// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

// Fields of a mixture of N species of grains, for instance of N sizes. For two sizes, Concentration
// (fields/standard.hpp) is enough.
namespace scree {

/// A field with one number for each of N species.
template <int N, Label Name, Label Unit>
struct PerSpecies : Labelled<Name, Unit> {
  static_assert(N >= 2, "a mixture has two species or more");
  template <int Dim, class Real>
  using value = Vec<N, Real>;
};

template <int N>
struct ConcentrationRates : PerSpecies<N, "concentration rates", "1/s"> {};
/// Volume concentrations C_k of the species, each from 0 to 1; their sum is 1.
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

}  // namespace scree
