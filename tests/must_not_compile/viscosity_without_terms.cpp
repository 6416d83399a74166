// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `viscosity` is not a ViscosityScheme
#include <scree/granular/granular.hpp>

struct Viscosity {
  using computes = scree::Fields<>;
#ifdef FIXED
  template <scree::BodyTag Body, class Rho>
  auto terms(Rho const&, double) const {
    return std::tuple<>();
  }
#endif
};
struct Models : scree::GranularModels {
  using viscosity = Viscosity;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
