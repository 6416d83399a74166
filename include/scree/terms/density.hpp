// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

// What terms take for the density of a particle.
namespace scree {

/// The same for all particles at all times (Zhu et al. 2024 switch (2.3) off).
struct UniformDensity {
  double value = 0;  ///< rho, kg/m^3
  using reads = Fields<>;
  template <class I>
  SCREE_FN auto of(I const& i) const {
    return std::remove_cvref_t<decltype(i[volume])>(value);
  }
};

/// That of each particle, which the formulation evolves.
struct EvolvedDensity {
  using reads = Fields<Density>;
  template <class I>
  SCREE_FN auto of(I const& i) const {
    return i[density];
  }
};

}  // namespace scree
