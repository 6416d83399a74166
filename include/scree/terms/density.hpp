// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

// The density of a particle for use in terms, and its inverse, which saves a division.
namespace scree {

/// Constant density of all particles (Zhu et al. 2024 switch (2.3) off).
struct UniformDensity {
  double value = 0;            ///< rho, kg/m^3
  double inverse = 1 / value;  ///< m^3/kg
  using reads = Fields<>;
  bool operator==(UniformDensity const&) const = default;
  template <class I>
  SCREE_FN auto of(I const& i) const {
    return std::remove_cvref_t<decltype(i[volume])>(value);
  }
  template <class I>
  SCREE_FN auto inverse_of(I const& i) const {
    return std::remove_cvref_t<decltype(i[volume])>(inverse);
  }
};

/// The density of each particle, which evolves or differs between materials.
struct DensityOfParticle {
  using reads = Fields<Density>;
  bool operator==(DensityOfParticle const&) const = default;
  template <class I>
  SCREE_FN auto of(I const& i) const {
    return i[density];
  }
  template <class I>
  SCREE_FN auto inverse_of(I const& i) const {
    return 1 / i[density];
  }
};

}  // namespace scree
