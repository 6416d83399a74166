// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "adami.hpp"
#include "mirror_lens.hpp"
#include "on_plate.hpp"

// Thin walls with material on both sides, such as blades, baffles and gates. A wall particle of AdamiWalls has one
// stress, the mean of both sides. In a plate each particle of the material reads its own mirror image instead, so that
// the material on the other side does not affect it.
namespace scree {

/// Lens that acts like MirrorLens on plates and like the lens of AdamiWalls elsewhere.
template <class Rho>
struct PlateLens {
  MirrorLens<Rho> mirror;
  bool operator==(PlateLens const&) const = default;
  static constexpr bool takes_packs = true;
  using provides = typename MirrorLens<Rho>::provides;
  using reads = Merge<reads_of<MirrorLens<Rho>>, Fields<DummyVelocity, Stress, OnPlate>>;
  using reads_i = reads_i_of<MirrorLens<Rho>>;

  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const& i, J const& j) const {
    using namespace fields;
    return chosen(j, mirror(velocity, i, j), j[dummy_velocity]);
  }
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using namespace fields;
    return chosen(j, mirror(stress, i, j), j[stress]);
  }

 private:
  template <class J, class X>
  SCREE_FN static X chosen(J const& j, X const& on, X off) {
    using namespace math;
    for (int a = 0; a < X::RowsAtCompileTime; ++a) off[a] = select(j[fields::on_plate] > 0, on[a], off[a]);
    return off;
  }
};

/// AdamiWalls in which some wall particles belong to plates. A plate must be at least two spacings thick, and at least
/// three if it rotates: across a thinner plate, particles on opposite sides are neighbours.
struct PlateWalls : AdamiWalls {
  /// Returns the lens through which the material reads walls and plates.
  template <class Rho>
  PlateLens<Rho> lens(Rho const& rho, Gravity const& gravity) const {
    return {{rho, gravity}};
  }
};

}  // namespace scree
