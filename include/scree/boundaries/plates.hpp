// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "conserving.hpp"
#include "on_plate.hpp"

// Thin walls with material on both sides, such as blades, baffles and gates. A wall particle of ConservingWalls shows
// one stress, the mean of both sides; in a plate each particle of the material sees its own mirror image instead, so
// that the other side does not affect it.
namespace scree {

/// Positive on plates and at walls with a `slip_normal`.
struct PlatesAndSlipWalls {
  using reads = Fields<OnPlate, SlipNormal>;
  template <class J>
  SCREE_FN auto operator()(J const& j) const {
    return j[fields::on_plate] + squared_norm(j[fields::slip_normal]);
  }
};

/// ConservingWalls in which some wall particles are those of plates, which are mirrors as of MirrorWalls. A plate must
/// be two spacings thick at least, and three if it turns: in a thinner one, grains on both sides are neighbours.
struct PlateWalls : conserving::Walls<PlatesAndSlipWalls> {};

}  // namespace scree
