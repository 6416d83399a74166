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

// Functions that all schemes for walls of dummy particles share: they mirror the slip and extrapolate the stress behind
// the wall.
namespace scree {

/// A scheme for walls of dummy particles, as a value:
///   velocity_passes()             tuple of passes over the wall for the velocity that the material sees
///   stress_passes(rho, gravity)   the same for the stress; rho is the density of the material, see terms/density.hpp
///   lens(rho, gravity)            the lens through which the material sees the wall; it may provide both without
///                                 passes
///   strain_term()                 optional: a term over the wall as it is, without the lens, that adds to the velocity
///                                 gradient of strain rates, in place of VelocityGradientSum
///   force_term(rho)               optional: a term over the wall that adds to the acceleration, beside the divergence
///                                 of the stress that the wall shows
///   shows_means                   optional: whether a wall particle shows all material around it the same values, so
///                                 that a wall between two beds must keep their means apart, and also the mean of an
///                                 antisymmetric stress; see shows_means
template <class W>
concept WallScheme = requires(W const& walls, UniformDensity const& rho, Gravity const& gravity) {
  std::tuple_size<decltype(walls.velocity_passes())>::value;
  std::tuple_size<decltype(walls.stress_passes(rho, gravity))>::value;
  walls.lens(rho, gravity);
};

/// A scheme with a term of its own in strain rates.
template <class W>
concept HasStrainTerm = requires(W const& walls) {
  walls.strain_term();
};

/// A scheme with a term of its own in the acceleration, for a density rho.
template <class W, class Rho>
concept HasForceTerm = requires(W const& walls, Rho const& rho) {
  walls.force_term(rho);
};

/// Whether a wall particle of a scheme shows all material the same values: the declaration of the scheme if it has one,
/// otherwise whether it computes something for wall particles. Without that each particle of the material sees values
/// of its own, as behind a plate.
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
/// The wall scheme of a physics model, its type `Walls` or that of its `mechanics`; NoWalls for models without one.
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

/// A lens through which a wall also has the density of the particle that sees it.
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

/// Velocity of a wall particle as seen by the material, which slips past the wall with u = `slip`: u_w - u, so that the
/// slip vanishes half way; at a slip wall (unit normal n), $u_w + u - 2 n (n \cdot u)$.
template <class X>
SCREE_FN X mirrored(X const& wall_velocity, X const& slip, X const& n) {
  using namespace math;
  using Real = typename X::Scalar;
  Real const sign = select(squared_norm(n) > 0, Real(1), Real(-1));
  return wall_velocity + sign * slip - 2 * dot(n, slip) * n;
}

/// $\sigma + s n^T + n s^T$: with a shear stress s on planes with the unit normal n.
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

/// Stress of a wall particle as seen by the material: that of the material; at a slip wall (unit normal n), its mirror
/// image, so that the shear stress along the wall vanishes half way.
template <class Packed, class X>
SCREE_FN Packed reflected(Packed const& sigma, X const& n) {
  X const traction = product(sigma, n);
  X const shear = traction - dot(n, traction) * n;
  return with_shear<Packed, X>(sigma, -2 * shear, n);
}

/// Returns the stress of one particle, extrapolated over `offset` (m) into a wall with the weight of the material:
/// sigma_aa - f_a offset_a, f = rho (g - a_w). Zhu et al. (2024), eq. 4.3 with its sign corrected: downwards the stress
/// becomes more compressive. The sum over a wall of sigma - (f offset^T) would be the same in any axes; its diagonal is
/// nearly so.
template <class Packed, class X>
SCREE_FN Packed continued(Packed sigma, X const& f, X const& offset) {
  for (int a = 0; a < X::RowsAtCompileTime; ++a) sigma[a] -= f[a] * offset[a];
  return sigma;
}

/// Returns a mean stress, extrapolated over the mean `offset` (m) into a wall with the weight of the material, f = rho
/// (g - a_w). The direction n of the offset is that out of the material. Each normal stress changes by $-f \cdot r$
/// with the offset r, and, where the wall `holds`, the shear stress on planes across n by -f_t |offset|, $f_t = f - (n
/// \cdot f) n$, as in a layer that is the same all along the wall. In such a layer the ratio of shear stress to normal
/// stress is f_t/f_n; where that of the material in front is less than two thirds of it, the shear stress grows in
/// proportion less: the pressure carries the weight along a wall next to a bed at rest. On walls steeper than 45
/// degrees (|f_t| > |f_n|), where no layer can rest, it does not grow. See docs/theory/granular.md, "The stress that a
/// wall shows".
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
      Real const ratio = dot(along, shear) * across / scale;  // of the material, over that of a layer
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
