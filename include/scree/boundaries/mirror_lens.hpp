// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "wall.hpp"

#include <tuple>

// Walls without extrapolation, the cheap alternative to adami.hpp: each particle of the material sees itself in the
// wall. No pass over the wall, no search from the wall, and nothing is kept of the wall but what its motion gives.
namespace scree {

/// Material particle i sees wall particle j with
///   u_j = u_w(x_j) - (u_i - u_w(x_i)) = 2 u_w((x_i + x_j)/2) - u_i,  which is Omega x x_j for rigid rotation,
///   sigma_j = sigma_i - rho diag((g - a_w) . (x_j - x_i)),           which is exact for a bed in equilibrium,
/// the wall's own velocity field u_w being affine (gradient from the motion). Where the wall lets slip (SlipNormal),
/// both are mirror images. Unlike a mean over neighbours it does not smooth, but neither does it know of a free surface
/// above the wall.
template <class Gravity>
struct MirrorLens {
  double rho;  ///< of the material, kg/m^3
  Gravity gravity;
  static constexpr bool takes_packs = true;
  using provides = Fields<Velocity, Stress>;
  using reads = Fields<Position, Velocity, Acceleration, VelocityGradient, SlipNormal>;

  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const& i, J const& j) const {
    using vector = std::remove_cvref_t<decltype(j[velocity])>;
    vector const wall_here = j[velocity] + j[velocity_gradient] * (i[position] - j[position]);
    return walls::mirrored<vector>(j[velocity], i[velocity] - wall_here, j[slip_normal]);
  }
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using vector = std::remove_cvref_t<decltype(j[velocity])>;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    vector const weight_force = typename vector::Scalar(rho) * (gravity.template vector<vector>() - j[acceleration]);
    Packed const here = walls::reflected<Packed, vector>(i[stress], j[slip_normal]);
    return walls::continued<Packed, vector>(here, weight_force, j[position] - i[position]);
  }
};

/// Walls by reflection.
struct MirrorWalls {
  template <class Gravity>
  std::tuple<> passes(double /*rho*/, Gravity const&) const {
    return {};
  }
  std::tuple<> velocity_passes() const { return {}; }
  template <class Gravity>
  std::tuple<> stress_passes(double /*rho*/, Gravity const&) const {
    return {};
  }
  template <class Gravity>
  MirrorLens<Gravity> lens(double rho, Gravity const& gravity) const {
    return {rho, gravity};
  }
};

}  // namespace scree
