// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `advection` is not an AdvectionScheme
#include <scree/granular/granular.hpp>

struct Fast {
  using position = scree::Position;
#ifdef FIXED
  template <class Rho, class Passes>
  auto stages(Rho const&, Passes const& passes) const {
    return std::tuple(scree::stage<scree::Fields<scree::Velocity, scree::Position>>(passes));
  }
#endif
};
struct Models : scree::GranularModels {
  using advection = Fast;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
