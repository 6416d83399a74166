// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../terms/density.hpp"
#include "../terms/gravity.hpp"
#include "wall.hpp"

#include <tuple>

// Walls without extrapolation, a cheaper alternative to adami.hpp: each particle of the material reads its own mirror
// image in the wall. Reflection needs no pass over the wall and no neighbour search from it, and stores nothing for the
// wall except its motion.
namespace scree {

/// Lens through which material particle i reads wall particle j with the velocity $u_j = u_w(x_j) - (u_i - u_w(x_i)) =
/// 2 u_w((x_i + x_j)/2) - u_i$, which is $\Omega \times x_j$ for rigid rotation. The stress is $\sigma_j = \sigma_i -
/// \rho \operatorname{diag}((g - a_w) \cdot (x_j - x_i))$, which is exact for a bed in equilibrium. The velocity field
/// u_w of the wall is affine, with the velocity gradient of the wall motion. At a slip wall (SlipNormal), velocity and
/// stress are mirror images. Unlike a mean over neighbours, the reflection does not smooth, but it ignores a free
/// surface above the wall.
template <class Rho>
struct MirrorLens {
  Rho rho;  ///< of the material
  Gravity gravity;
  bool operator==(MirrorLens const&) const = default;
  static constexpr bool takes_packs = true;
  using provides = Fields<Velocity, Stress>;
  using reads = Fields<Position, Velocity, Acceleration, VelocityGradient, SlipNormal>;
  using reads_i = Merge<Fields<Position, Volume, Velocity, Stress>, typename Rho::reads>;

  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const& i, J const& j) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(j[velocity])>;
    vector const wall_here = j[velocity] + j[velocity_gradient] * (i[position] - j[position]);
    return walls::mirrored<vector>(j[velocity], i[velocity] - wall_here, j[slip_normal]);
  }
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(j[velocity])>;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    vector const weight_force = typename vector::Scalar(rho.of(i)) * (gravity.vector<vector>() - j[acceleration]);
    Packed const here = walls::reflected<Packed, vector>(i[stress], j[slip_normal]);
    return walls::continued<Packed, vector>(here, weight_force, j[position] - i[position]);
  }
};

/// Wall scheme by reflection, see MirrorLens.
struct MirrorWalls {
  static constexpr bool shows_means = false;
  std::tuple<> velocity_passes() const { return {}; }
  template <class Rho>
  std::tuple<> stress_passes(Rho const&, Gravity const&) const {
    return {};
  }
  template <class Rho>
  MirrorLens<Rho> lens(Rho const& rho, Gravity const& gravity) const {
    return {rho, gravity};
  }
};

}  // namespace scree
