// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/pack.hpp"
#include "../core/root.hpp"
#include "../core/symmetric3.hpp"
#include "../fields/standard.hpp"
#include "../terms/density.hpp"
#include "../terms/gravity.hpp"
#include "../terms/kernel_sums.hpp"
#include "../terms/velocity_gradient.hpp"
#include "slip_normal.hpp"

#include <tuple>
#include <utility>

// Functions shared by all schemes for walls of dummy particles: they mirror the slip and extrapolate the stress into
// the wall.
namespace scree {

/// A scheme for walls of dummy particles is a struct with these members:
///   velocity_passes()             tuple of passes over the wall that compute the wall velocity used by the material
///   stress_passes(rho, gravity)   tuple of passes over the wall that compute the wall stress used by the material; rho
///                                 is the density of the material, see terms/density.hpp
///   lens(rho, gravity)            the lens through which the material reads the wall; it may provide velocity and
///                                 stress without passes
///   strain_term()                 optional: a term that adds the part of the wall to the velocity gradient of strain
///                                 rates, in place of VelocityGradientSum; it reads the wall without the lens
///   force_term(rho)               optional: a term over the wall that adds to the acceleration, in addition to the
///                                 divergence of the wall stress
///   shows_means                   optional: whether all material around a wall particle reads the same values from it.
///                                 If so, a wall between two beds must keep their means apart, and the wall also has a
///                                 mean antisymmetric stress; see shows_means
template <class W>
concept WallScheme = requires(W const& walls, UniformDensity const& rho, Gravity const& gravity) {
  std::tuple_size<decltype(walls.velocity_passes())>::value;
  std::tuple_size<decltype(walls.stress_passes(rho, gravity))>::value;
  walls.lens(rho, gravity);
};

/// Whether a wall scheme has its own term in strain rates.
template <class W>
concept HasStrainTerm = requires(W const& walls) {
  walls.strain_term();
};

/// Whether a wall scheme has its own term in the acceleration, for a density rho.
template <class W, class Rho>
concept HasForceTerm = requires(W const& walls, Rho const& rho) {
  walls.force_term(rho);
};

/// Whether all material reads the same values from a wall particle of a scheme: the constant `shows_means` of the
/// scheme if it has one, otherwise whether the scheme has passes that compute values for wall particles. If false, each
/// particle of the material reads its own values from the wall, as from a plate.
template <WallScheme W>
inline constexpr bool shows_means = [] {
  if constexpr (requires { bool(W::shows_means); }) {
    return bool(W::shows_means);
  } else {
    using Velocities = decltype(std::declval<W const&>().velocity_passes());
    using Stresses = decltype(std::declval<W const&>().stress_passes(std::declval<UniformDensity const&>(),
                                                                     std::declval<Gravity const&>()));
    return std::tuple_size_v<Velocities> + std::tuple_size_v<Stresses> > 0;
  }
}();

namespace detail {
struct NoWalls {};
/// The wall scheme of a physics model: its type `Walls`, or the type `Walls` of its `mechanics`; NoWalls for models
/// without a wall scheme.
template <class Physics>
struct walls_of {
  using type = NoWalls;
};
template <class Physics>
requires requires { typename Physics::Walls; }
struct walls_of<Physics> {
  using type = typename Physics::Walls;
};
template <class Physics>
requires(
    !requires { typename Physics::Walls; } &&
    requires { typename decltype(Physics::mechanics)::Walls; }) struct walls_of<Physics> {
  using type = typename decltype(Physics::mechanics)::Walls;
};
}  // namespace detail

/// A lens that also gives a wall particle the density of the particle that reads it.
template <class Lens>
struct WithDensityOfTarget : Lens {
  static constexpr bool takes_packs = scree::takes_packs<Lens>;
  using provides = Merge<provides_of<Lens>, Fields<Density>>;
  using reads = Merge<Fields<Volume>, reads_of<Lens>>;
  using reads_i = Merge<Fields<Density>, reads_i_of<Lens>>;
  bool operator==(WithDensityOfTarget const&) const = default;
  using Lens::operator();
  template <class I, class J>
  SCREE_FN auto operator()(Density, I const& i, J const& j) const {
    using namespace fields;
    return std::remove_cvref_t<decltype(j[volume])>(i[density]);
  }
};

namespace walls {

/// Returns the velocity of a wall particle for material that slips past the wall with u = `slip`: u_w - u, so that the
/// slip vanishes halfway between them; at a slip wall (unit normal n), $u_w + u - 2 n (n \cdot u)$.
template <class X>
SCREE_FN X mirrored(X const& wall_velocity, X const& slip, X const& n) {
  using namespace math;
  using Real = typename X::Scalar;
  Real const sign = select(squared_norm(n) > 0, Real(1), Real(-1));
  return wall_velocity + sign * slip - 2 * dot(n, slip) * n;
}

/// Returns $\sigma + s n^T + n s^T$: adds a shear stress s on planes with the unit normal n.
template <class Packed, class X>
SCREE_FN Packed with_shear(Packed sigma, X const& s, X const& n) {
  for (int a = 0; a < X::RowsAtCompileTime; ++a) sigma[a] += 2 * s[a] * n[a];
  sigma[3] += s[0] * n[1] + n[0] * s[1];
  if constexpr (X::RowsAtCompileTime == 3) {
    sigma[4] += s[0] * n[2] + n[0] * s[2];
    sigma[5] += s[1] * n[2] + n[1] * s[2];
  }
  return sigma;
}

/// Returns the stress of a wall particle for material with the stress sigma: sigma itself or, at a slip wall (unit
/// normal n), the mirror image of sigma, so that the shear stress along the wall vanishes halfway between the two
/// particles.
template <class Packed, class X>
SCREE_FN Packed reflected(Packed const& sigma, X const& n) {
  X const traction = product(sigma, n);
  X const shear = traction - dot(n, traction) * n;
  return with_shear<Packed, X>(sigma, -2 * shear, n);
}

/// Returns the stress of one particle, extrapolated over `offset` (m) into a wall with the weight of the material:
/// sigma_aa - f_a offset_a, f = rho (g - a_w). This is eq. 4.3 of Zhu et al. (2024) with its sign corrected, so that
/// the stress becomes more compressive downwards. The sum over a wall of sigma - (f offset^T) would be independent of
/// the axes; the sum with the diagonal alone is nearly so.
template <class Packed, class X>
SCREE_FN Packed continued(Packed sigma, X const& f, X const& offset) {
  for (int a = 0; a < X::RowsAtCompileTime; ++a) sigma[a] -= f[a] * offset[a];
  return sigma;
}

/// Returns a mean stress, extrapolated over the mean `offset` (m) into a wall with the weight of the material, f = rho
/// (g - a_w). The direction n of the offset points out of the material. Each normal stress changes by $-f \cdot r$ with
/// the offset r. If the wall `holds`, the shear stress on planes normal to n changes by -f_t |offset|, $f_t = f - (n
/// \cdot f) n$, as in a layer that is uniform along the wall. In a uniform layer the ratio of shear stress to normal
/// stress is f_t/f_n. If the ratio of the material in front of the wall is less than two thirds of f_t/f_n, the change
/// of the shear stress is reduced in proportion, because the pressure carries the weight along a wall next to a bed at
/// rest. On walls steeper than 45 degrees (|f_t| > |f_n|), where no layer can rest, the shear stress does not change.
/// See docs/theory/granular.md, "The stress that a wall shows".
template <class Packed, class X>
SCREE_FN Packed extrapolated(Packed sigma, X const& f, X const& offset, bool holds) {
  using Real = typename X::Scalar;
  Real const added = -dot(f, offset);
  auto const within = [](Real const& part) { return Kokkos::min(Real(1), Kokkos::max(Real(0), part)); };
  if (holds) {
    X const n = math::unit_vector(offset), traction = product(sigma, n);
    Real const normal = dot(n, traction), across = dot(n, f);
    X const shear = traction - normal * n, along = f - across * n;
    Real const scale = squared_norm(along) * normal;
    if (scale < 0) {
      Real const ratio = dot(along, shear) * across / scale;  // of the material over that of a uniform layer
      Real const steep = squared_norm(along) / (across * across);
      Real const share = within(4 - 4 * steep) * within(Real(1.5) * ratio);
      sigma = with_shear<Packed, X>(sigma, -share * norm(offset) * along, n);
    }
  }
  for (int a = 0; a < X::RowsAtCompileTime; ++a) sigma[a] += added;
  return sigma;
}

}  // namespace walls
}  // namespace scree
