// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `walls` is not a WallScheme: it needs velocity_passes\(\), stress_passes\(rho, gravity\) and lens\(rho
#include <scree/granular/granular.hpp>

struct Bare {
  std::tuple<> velocity_passes() const { return {}; }
  template <class Rho>
  std::tuple<> stress_passes(Rho const&, scree::Gravity const&) const {
    return {};
  }
#ifdef FIXED
  template <class Rho>
  scree::AsIs lens(Rho const&, scree::Gravity const&) const {
    return {};
  }
#endif
};
struct Models : scree::GranularModels {
  using walls = Bare;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
