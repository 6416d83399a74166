// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `volume_control` is not a VolumeControl
#include <scree/granular/granular.hpp>

struct Control {
  static constexpr bool active = true;
#ifdef FIXED
  template <class Real>
  SCREE_FN Real pressure_per_strain(Real, Real K, Real denser) const {
    return K * denser;
  }
#endif
};
struct Models : scree::GranularModels {
  using volume_control = Control;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
