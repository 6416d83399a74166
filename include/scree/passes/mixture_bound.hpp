// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/species.hpp"
#include "validity.hpp"

namespace scree {

/// The amount by which the concentrations of a particle violate the conditions for a mixture: the largest distance of a
/// concentration from [0, 1], or the distance of their sum from 1 if that is larger.
template <int N>
struct MixtureOutside {
  using reads = Fields<Concentrations<N>>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    auto const C = i[fields::concentrations<N>];
    using Real = std::remove_cvref_t<decltype(C[0] + C[0])>;
    Real outside = 0, total = -1;
    for (int k = 0; k < N; ++k) {
      outside = Kokkos::max(outside, Kokkos::max(-C[k], C[k] - 1));
      total += C[k];
    }
    return Kokkos::max(outside, Kokkos::abs(total));
  }
};

/// Returns the bound for models that need the concentrations of N species: the concentrations of a particle are between
/// 0 and 1 and add up to 1, with a tolerance of 1e-3.
template <int N>
auto mixture_bound() {
  return bound("distance of the concentrations from a mixture", MixtureOutside<N>{}, 1e-3,
               "each of them is a share of the grains, 0 to 1, and their sum is 1");
}

}  // namespace scree
