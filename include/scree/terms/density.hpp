// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

#include <concepts>

// The density of a particle for use in terms, and the inverse density, which saves a division.
namespace scree {

/// Whether R is a density for use in terms, with
///   reads           the list of the fields that the density depends on
///   of(i)           the density of a particle, kg/m^3, of the same type as i[volume], which may be a pack
///   inverse_of(i)   one over the density of a particle, m^3/kg
template <class R>
concept DensityOf = requires(R const& rho, Record<detail::AnyPoint, Merge<Fields<Volume>, reads_of<R>>> const& i) {
  typename R::reads;
  { rho.of(i) } -> std::convertible_to<double>;
  { rho.inverse_of(i) } -> std::convertible_to<double>;
};
namespace detail {
template <class R>
constexpr bool explain_density() {
  static_assert(DensityOf<R>, "a density for terms needs a list `reads`, of(i) and inverse_of(i)");
  return DensityOf<R>;
}
}  // namespace detail

/// The constant density of all particles (Zhu et al. 2024 omit the continuity equation, eq. 2.3).
struct UniformDensity {
  double value = 0;            ///< rho, kg/m^3
  double inverse = 1 / value;  ///< m^3/kg
  using reads = Fields<>;
  bool operator==(UniformDensity const&) const = default;
  template <class I>
  SCREE_FN auto of(I const& i) const {
    return std::remove_cvref_t<decltype(i[fields::volume])>(value);
  }
  template <class I>
  SCREE_FN auto inverse_of(I const& i) const {
    return std::remove_cvref_t<decltype(i[fields::volume])>(inverse);
  }
};

/// The density of each particle, which evolves or differs between materials.
struct DensityOfParticle {
  using reads = Fields<Density>;
  bool operator==(DensityOfParticle const&) const = default;
  template <class I>
  SCREE_FN auto of(I const& i) const {
    return i[fields::density];
  }
  template <class I>
  SCREE_FN auto inverse_of(I const& i) const {
    return 1 / i[fields::density];
  }
};

}  // namespace scree
