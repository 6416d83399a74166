// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/boundaries/wall.hpp>
#include <scree/pairs/term.hpp>

namespace scree::test::archetypes {

/// The material sees wall particles as they are.
struct Walls {
  std::tuple<> velocity_passes() const { return {}; }
  template <class Rho>
  std::tuple<> stress_passes(Rho const&, Gravity const&) const {
    return {};
  }
  template <class Rho>
  AsIs lens(Rho const&, Gravity const&) const {
    return {};
  }
};
static_assert(WallScheme<Walls>);

}  // namespace scree::test::archetypes
