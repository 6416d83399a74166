// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "artificial_viscosity.hpp"
#include "velocity_gradient.hpp"

// An artificial viscosity for the part of the relative velocity of two particles that a linear velocity field does not
// explain. See docs/theory/granular.md.
namespace scree {

/// Returns the strain rate from the corrected velocity gradient, for use in predicting relative velocities. The strain
/// rate falls to zero if neighbours fill less of the support than at a plane surface, because a linear field explains
/// every relative velocity of a few neighbours. On a lattice with h = 1.5 spacings, the mean diagonal entry of the
/// negative first moment is 1 in the interior; in the row at a plane surface, it is 0.62 in 2D and 0.67 in 3D; with a
/// single neighbour at a distance of one spacing, it is 0.08 in 2D and 0.03 in 3D. The strain rate is not reduced if
/// this entry is above 0.5, and is zero if it is below 0.3.
template <int Dim, class Real>
SCREE_FN Vec<symmetric_size<Dim>, Real> trusted_strain_rate(Mat<Dim, Real> const& corrected,
                                                            Mat<Dim, Real> const& first_moment) {
  Real const filled = -trace(first_moment) / Dim;
  return Kokkos::clamp((filled - Real(0.3)) / Real(0.2), Real(0), Real(1)) * symmetric_part(corrected);
}

namespace detail {

/// Returns an approach $u_{ij} \cdot x_{ij}$ (m^2/s, 0 or less) minus the harmonic mean of two predictions of it. The
/// result lies between the approach and 0, and equals the approach if the particles separate according to one of the
/// predictions. The harmonic mean is the arithmetic mean times the limiter of van Leer (1974), $4 r/(1 + r)^2$ with the
/// ratio r of the predictions.
template <class Real>
SCREE_LOOP_FN Real unexplained(Real const& approach, Real const& by_i, Real const& by_j) {
  using namespace math;
  Real const a = max(Real(0), -by_i), b = max(Real(0), -by_j), both = a + b;
  return min(Real(0), approach + quotient(2 * a * b, select(both > Real(0), both, Real(1))));
}

}  // namespace detail

/// ArtificialViscosity with a residual in place of $u_{ij} \cdot x_{ij}$, for which the strain rates D of the two
/// particles predict $x_{ij} \cdot D_i x_{ij}$ and $x_{ij} \cdot D_j x_{ij}$. The force is zero in a linear velocity
/// field and acts in full on velocities that alternate between neighbours. It is antisymmetric and along $x_{ij}$, so
/// it conserves momentum and angular momentum, and it removes energy from every pair on which it acts.
template <class Rho = UniformDensity>
struct ResidualArtificialViscosity {
  static_assert(detail::explain_density<Rho>());
  Rho rho;
  double speed = 0;  ///< alpha c_s, m/s
  using reads = Merge<Fields<Volume, Velocity, StrainRate>, typename Rho::reads>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    using Real = typename IJ::real;
    Real const approach = min(Real(0), dot(i[velocity] - j[velocity], ij.x));
    if constexpr (quotient_is_slow<Real>)
      if (approach == 0) return;
    auto const xx = square_of(ij.x);
    Real const rest = detail::unexplained<Real>(approach, dot(i[strain_rate], xx), dot(j[strain_rate], xx));
    sum[acceleration] += detail::viscous_acceleration<Real>(rho.of(i), rho.of(j), j[volume], Real(speed), rest, ij);
  }
};

}  // namespace scree
