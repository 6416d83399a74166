// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "../terms/artificial_viscosity.hpp"
#include "../terms/residual_viscosity.hpp"

#include <concepts>
#include <tuple>
#include <type_traits>

namespace scree {

/// An artificial viscosity is a struct with these members:
///   computes                  Fields<StrainRate> if the terms read the strain rate of the material, otherwise Fields<>
///   terms<Body>(rho, speed)   tuple of pair terms over the particles of a body, each of which adds to `acceleration`;
///                             `speed` is alpha c_s, m/s
/// Here rho is the density, see terms/density.hpp.
template <class V>
concept ViscosityScheme = requires(V const& viscosity, UniformDensity const& rho) {
  typename V::computes;
  requires std::is_same_v<typename V::computes, Fields<>> || std::is_same_v<typename V::computes, Fields<StrainRate>>;
  std::tuple_size<decltype(viscosity.template terms<Material>(rho, 1.0))>::value;
  std::tuple_size<decltype(viscosity.template terms<Wall>(rho, 1.0))>::value;
};

/// The artificial viscosity of Monaghan (1992), eq. 3.10 of Zhu et al. (2024). This viscosity acts on all approaching
/// pairs and therefore adds to the friction of a flow, see effective_viscosity().
struct PlainViscosity {
  using computes = Fields<>;
  template <BodyTag Body, class Rho>
  auto terms(Rho const& rho, double speed) const {
    return std::tuple(ArtificialViscosity<Rho>{rho, speed});
  }
};

/// PlainViscosity minus the contribution of a linear velocity field (terms/residual_viscosity.hpp). This viscosity acts
/// on disorder, not on the mean shear, and keeps the particle rows of steady flows in order. Sums over walls use
/// PlainViscosity.
struct ResidualViscosity {
  using computes = Fields<StrainRate>;
  template <BodyTag Body, class Rho>
  auto terms(Rho const& rho, double speed) const {
    if constexpr (std::is_same_v<Body, Material>)
      return std::tuple(ResidualArtificialViscosity<Rho>{rho, speed});
    else
      return PlainViscosity{}.terms<Body>(rho, speed);
  }
};

}  // namespace scree
