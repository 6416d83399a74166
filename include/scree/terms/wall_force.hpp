// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

// The force of the material on a wall, which is the reaction to the force of the wall on the material.
namespace scree {

/// The force F of the material on a wall particle, in 2D on a slice one metre deep. Summed over the particles of a
/// wall, F is the force on the wall, (x - c) x F is the moment about c, and $F \cdot u_w$ is the power that the wall
/// takes from the material.
struct WallForce : Vector<"wall force", "N"> {};

namespace fields {
inline constexpr WallForce wall_force{};
}  // namespace fields

/// The force $F_w = -\sum_i m_i a_{iw}$ on wall particle w, summed over the material particles i, with m = rho V. a_iw
/// is the contribution of w to the acceleration of i, with the values of w that the lens gives for i.
template <class Rho, class Lens, class... Terms>
struct Reaction : Terms... {
  Rho rho;
  Lens lens;
  using reads = Fields<Position>;
  // The wall particle is the target of the pass (i); the material particle is its neighbour (j).
  using reads_i = Merge<Without<Merge<detail::record_j<Terms>...>, provides_of<Lens>>, reads_of<Lens>>;
  using reads_j = Merge<Fields<Volume>, typename Rho::reads, detail::record_i<Terms>..., reads_i_of<Lens>>;
  using adds = Fields<WallForce>;

  /// Takes the density of the material, the lens for the values of the wall, and the terms of the acceleration of the
  /// material.
  Reaction(Rho const& r, Lens const& l, Terms const&... terms) : Terms(terms)..., rho(r), lens(l) {}

  template <class W, class I, class WI, class S>
  SCREE_FN void operator()(W const& wall, I const& i, WI const& wi, S& sum) const {
    using namespace fields;
    WI iw = wi;
    iw.x = -wi.x;
    SeenWall<W, I> const seen{lens, wall, i};
    Felt<typename WI::vector> felt{zero<typename WI::vector>()};
    (static_cast<Terms const&>(*this)(i, seen, iw, felt), ...);
    sum[wall_force] += (-rho.of(i) * i[volume]) * felt.acceleration;
  }

 private:
  template <class W, class I>
  struct SeenWall {
    Lens const& lens;
    W const& wall;
    I const& i;
    template <Field F>
    SCREE_FN auto operator[](F field) const {
      if constexpr (OneOf<F, provides_of<Lens>>)
        return lens(field, i, wall);
      else
        return wall[field];
    }
  };
  template <class X>
  struct Felt {
    X acceleration;
    SCREE_FN X& operator[](Acceleration) { return acceleration; }
  };
};

}  // namespace scree
