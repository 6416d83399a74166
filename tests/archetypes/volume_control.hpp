// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/volume_control.hpp>

namespace scree::test::archetypes {

/// The pressure follows the compactness over a shear strain of 1.
struct Control {
  static constexpr bool active = true;
  template <class Real>
  SCREE_FN Real pressure_per_strain(Real p, Real K, Real denser) const {
    return K * denser - p;
  }
};
static_assert(VolumeControl<Control>);

}  // namespace scree::test::archetypes
