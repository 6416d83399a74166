// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/advection.hpp>

namespace scree::test::archetypes {

struct WithTheFlow {
  using position = Position;
  template <class Rho, class Passes>
  auto stages(Rho const&, Passes const& acceleration_passes) const {
    return std::tuple(stage<Fields<Velocity, Position>>(acceleration_passes));
  }
};
static_assert(AdvectionScheme<WithTheFlow>);

}  // namespace scree::test::archetypes
