// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "density.hpp"

namespace scree {

namespace detail {

/// Returns $m_j \Pi_{ij} \nabla W_{ij}$, m/s^2, with $\Pi_{ij} = (\alpha c_s) h/\rho_{ij} \, a/(\lvert x_{ij}\rvert^2 +
/// 0.01 h^2)$ and the mean density $\rho_{ij}$ of the two particles. `speed` is alpha c_s (m/s), `approach` is a
/// (m^2/s), 0 or less.
template <class Real, class IJ>
SCREE_LOOP_FN auto viscous_acceleration(Real const& rho_i, Real const& rho_j, Real const& volume_j, Real const& speed,
                                        Real const& approach, IJ const& ij) {
  using namespace math;
  Real const Pi = quotient(2 * speed * ij.h() * approach, (rho_i + rho_j) * (sq(ij.r) + Real(0.01) * sq(ij.h())));
  return (rho_j * volume_j * Pi * ij.slope()) * ij.x;
}

}  // namespace detail

/// ArtificialViscosity between the particles of two bodies with different densities. The forces on the two particles of
/// a pair are equal and opposite if both bodies use the same `speed`.
template <class Rho, class OtherRho>
struct InterfaceViscosity {
  static_assert(detail::explain_density<Rho>() && detail::explain_density<OtherRho>());
  Rho rho;             ///< density of i
  OtherRho other_rho;  ///< density of j
  double speed = 0;    ///< alpha c_s, m/s
  using reads = Fields<Volume, Velocity>;
  using reads_i = typename Rho::reads;
  using reads_j = typename OtherRho::reads;
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
    sum[acceleration] +=
        detail::viscous_acceleration<Real>(rho.of(i), other_rho.of(j), j[volume], Real(speed), approach, ij);
  }
};

/// The acceleration $du_i/dt = \sum_j m_j \Pi_{ij} \nabla W_{ij}$ with $\Pi_{ij} = (\alpha c_s) h/\rho_{ij} \, u_{ij}
/// \cdot x_{ij}/(\lvert x_{ij}\rvert^2 + 0.01 h^2)$, which repels approaching pairs (Monaghan 1992; Zhu et al. 2024,
/// eq. 3.10, for tension-positive stress). The term acts like a physical viscosity (see effective_viscosity()). `speed`
/// is the product alpha c_s, because this product must not change with the stiffness of the material.
template <class Rho = UniformDensity>
struct ArtificialViscosity {
  static_assert(detail::explain_density<Rho>());
  Rho rho;
  double speed = 0;  ///< alpha c_s, m/s
  using reads = Merge<Fields<Volume, Velocity>, typename Rho::reads>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    InterfaceViscosity<Rho, Rho>{rho, rho, speed}(i, j, ij, sum);
  }
};

/// Returns the kinematic viscosity nu = alpha c_s h/(4 (dim + 2)), m^2/s, to which the artificial viscosity is
/// equivalent in shear flow. With $u_{ij}$ expanded to second order, $\sum_j V_j (u_{ij} \cdot x_{ij})/r^2 \nabla
/// W_{ij} \to -1/2 \langle n n n n\rangle:(\nabla \nabla u) \int W' r \, dV$, $\langle n_a n_b n_c n_d\rangle =
/// (\delta_{ab} \delta_{cd} + \delta_{ac} \delta_{bd} + \delta_{ad} \delta_{bc})/(\dim (\dim + 2))$ and $-\int W' r \,
/// dV = \dim$. The result is alpha c_s h/(2 (dim + 2)) laplace(u) (Monaghan 2005), halved because only approaching
/// pairs contribute. With h = 1.5 spacings, a square lattice reaches 0.875 of nu and a cubic lattice 0.915; disordered
/// particles reach 0.91 in 2D and 0.94 in 3D.
inline double effective_viscosity(double speed, double h, int dim) { return speed * h / (4 * (dim + 2)); }

}  // namespace scree
