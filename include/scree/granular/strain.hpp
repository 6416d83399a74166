// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/law.hpp"
#include "../terms/antisymmetric_stress.hpp"
#include "../terms/residual_viscosity.hpp"
#include "volume_control.hpp"

namespace scree {

/// The choice of the velocity gradient that the stress follows: a struct with a constant `corrected` and an optional
/// constant `objective`, both bool.
template <class S>
concept StrainChoice = requires {
  { S::corrected } -> std::convertible_to<bool>;
};

/// Choice of strain in which the stress follows the plain velocity gradient, which is work-conjugate to the stress
/// divergence: the stress stores the energy that it takes from the motion.
struct PlainStrain {
  static constexpr bool corrected = false;
};
/// Choice of strain in which the stress follows the corrected velocity gradient, which is exact for linear velocity
/// fields. If particles are disordered, the plain gradient has errors that act as friction in fast flows; the corrected
/// gradient avoids these errors but sacrifices energy consistency.
struct CorrectedStrain {
  static constexpr bool corrected = true;
};

/// Choice of strain in which the stress follows the plain gradient without its spurious strain in a rotation: $L - W
/// (A - 1)$ in place of L. The moment $A = -\sum_j V_j x_{ij} \otimes \nabla W_{ij}$ is the identity if the support is
/// full and the particles are not strained. W is the rotation whose plain gradient W A has the same antisymmetric part
/// as L. A body of soil can then rotate by any angle without spurious stress. The forces contain an antisymmetric
/// stress, with which their power equals the power of the stress on this strain (terms/antisymmetric_stress.hpp).
/// Momentum and energy are conserved as with PlainStrain, and the angular momentum of a free body is conserved, too.
struct ObjectiveStrain {
  static constexpr bool corrected = false, objective = true;
};

namespace granular {
/// Whether a choice of strain removes the spurious strain of the plain gradient in a rotation.
template <class S>
concept IsObjective = requires {
  requires S::objective;
};
/// Returns the velocity gradient for a choice of strain; `moment` is -A, see ObjectiveStrain.
template <class Strain, class Matrix>
SCREE_FN Matrix gradient_of(Matrix const& plain, Matrix const& corrected, [[maybe_unused]] Matrix const& moment) {
  if constexpr (Strain::corrected) {
    return corrected;
  } else if constexpr (IsObjective<Strain>) {
    constexpr int dim = Matrix::RowsAtCompileTime;
    return plain + spin_of<dim, typename Matrix::Scalar>(plain, moment) * (moment + Matrix::Identity());
  } else {
    return plain;
  }
}
/// The point that is passed to a law when rates are computed: a particle with the shear rate of the present state in
/// place of the stored one.
template <class I, class Real>
struct Strained {
  I const& i;
  Real gamma_dot;  // 1/s
  template <Field F>
  SCREE_FN auto const& operator[](F field) const {
    if constexpr (std::is_same_v<F, ShearRate>)
      return gamma_dot;
    else
      return i[field];
  }
};

/// The fields of a particle that functions of a law may read.
template <class Law>
using point_of = Merge<reads_of<Law>, typename Law::history>;
}  // namespace granular

/// Computes the rates of one particle from the sums over neighbours: the rates of stress and history, by the law from
/// the velocity gradient, and the shear rate, from the corrected gradient, which a truncated support does not reduce.
/// The trace of the plain gradient is minus the rate of the number density, so that pressure and spacing stay
/// consistent; with the corrected gradient only volume control keeps them consistent.
template <class Law, class Volume, class Strain = PlainStrain, class Also = Fields<>>
struct StrainRates {
  Law law;
  Volume volume_control;
  double phi_at_rest;           ///< number density of the initial lattice, -
  double asymmetry_at_surface;  ///< asymmetry of a particle on a plane surface, -
  double h = 0;                 ///< smoothing length, m
  double step = 0;              ///< time step over which the rates are integrated, s; 0: none

  using sums = std::conditional_t<Volume::active, Fields<NumberDensity, Asymmetry>, Fields<>>;
  using reads = Merge<Fields<Stress>, Without<granular::point_of<Law>, Fields<ShearRate>>>;
  using writes = Merge<Fields<StressRate, ShearRate>, rates_of_evolved<typename Law::history>,
                       std::conditional_t<Volume::active, Fields<NumberDensity>, Fields<>>, Also>;

  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    using Matrix = std::remove_cvref_t<decltype(total[velocity_gradient])>;
    using Real = typename Matrix::Scalar;
    constexpr int dim = Matrix::RowsAtCompileTime;
    Matrix const plain = total[velocity_gradient], corrected = corrected_gradient(plain, total[first_moment]);
    auto const L = in_three_dimensions(granular::gradient_of<Strain, Matrix>(plain, corrected, total[first_moment]));
    StressTensor<Real> const sigma = turned_by_half(unpacked(i[stress]), L);
    granular::Strained<I, Real> const point{i, shear_rate_of(corrected)};
    out[stress_rate] = packed<dim>(StressTensor<Real>(law.stress_rate(sigma, L, point)));
    if constexpr (EvolvesHistory<Law>) law.history_rate(sigma, L, point, out);
    out[shear_rate] = point.gamma_dot;
    if constexpr (OneOf<FirstMoment, Also>) out[first_moment] = total[first_moment];
    if constexpr (OneOf<StrainRate, Also>) out[strain_rate] = trusted_strain_rate(corrected, total[first_moment]);
    if constexpr (Volume::active) {
      out[number_density] = total[number_density];
      Real const change = pressure_per_strain(sigma, point, total) * point.gamma_dot;
      for (int a = 0; a < 3; ++a) out[stress_rate][a] -= change;
    }
  }

 private:
  /// Returns the stress rotated by half of the rotation in the step. A step with the rate of rotation of this stress
  /// keeps the invariants of the stress to fourth order in the step, a step with the rate of rotation of the stress
  /// itself to second order only.
  template <class Real>
  SCREE_FN StressTensor<Real> turned_by_half(StressTensor<Real> const& sigma, Mat<3, Real> const& L) const {
    return sigma + Real(step / 2) * rate_of_rotation(sigma, L);
  }
  /// Returns the change of the pressure per shear strain by volume control, dp/d(gamma), Pa.
  template <class Real, class Point, class T>
  SCREE_FN Real pressure_per_strain(StressTensor<Real> const& sigma, Point const& point, T const& total) const {
    using namespace fields;
    Real const p = pressure_of(sigma), K = bulk_modulus_at(law, sigma, point);
    Real const phi = compactness(total[number_density], norm(total[asymmetry]), Real(asymmetry_at_surface));
    Real const denser = phi - Real(phi_at_rest);
    if constexpr (ControlOfFlow<Volume>) {
      Real const sheared = point.gamma_dot * Real(h) / sound_speed_at(law, sigma, point);
      return volume_control.pressure_per_strain(p, K, denser, sheared);
    } else {
      return volume_control.pressure_per_strain(p, K, denser);
    }
  }
};

}  // namespace scree
