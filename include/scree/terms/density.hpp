// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

#include <concepts>

// The density of a particle for use in terms, and its inverse, which saves a division.
namespace scree {

/// A density for use in terms, as a value:
///   reads           fields of a particle that it depends on
///   of(i)           the density of a particle, kg/m^3, a number of the kind of i[volume], so that it may be a pack
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

/// Constant density of all particles (Zhu et al. 2024 switch (2.3) off).
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
