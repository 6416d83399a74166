// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/law.hpp"
#include "../terms/velocity_gradient.hpp"
#include "volume_control.hpp"

namespace scree {

/// The stress follows the plain velocity gradient, which is work-conjugate to the stress divergence: the stress stores
/// the energy that it takes from the motion.
struct PlainStrain {
  static constexpr bool corrected = false;
};
/// The stress follows the corrected gradient, which is exact for linear velocities. Among disordered particles the
/// plain gradient has errors that act as friction in fast flows; the corrected one gives up energy consistency.
struct CorrectedStrain {
  static constexpr bool corrected = true;
};

/// Computes the rates of one particle from the sums over neighbours: the stress rate of the law from the velocity
/// gradient, and the shear rate from the corrected gradient, which a truncated support does not lower. The trace of the
/// plain gradient is minus the rate of the number density, so that pressure and spacing stay consistent; with the
/// corrected gradient only volume control keeps them so.
template <class Law, class Volume, class Strain = PlainStrain>
struct StrainRates {
  Law law;
  Volume volume_control;
  double phi_at_rest;           ///< number density of the initial lattice, -
  double asymmetry_at_surface;  ///< of a particle on a plane surface, -

  using sums = std::conditional_t<Volume::active, Fields<NumberDensity, Asymmetry>, Fields<>>;
  static constexpr bool stores_sums = false;
  using reads = Fields<Stress>;
  using writes =
      Merge<Fields<StressRate, ShearRate>, std::conditional_t<Volume::active, Fields<NumberDensity>, Fields<>>>;

  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using Matrix = std::remove_cvref_t<decltype(total[velocity_gradient])>;
    using Real = typename Matrix::Scalar;
    constexpr int dim = Matrix::RowsAtCompileTime;
    auto const sigma = unpacked(i[stress]);
    Matrix const plain = total[velocity_gradient], corrected = corrected_gradient(plain, total[first_moment]);
    auto const rate = law.stress_rate(sigma, in_three_dimensions(Strain::corrected ? corrected : plain));
    out[stress_rate] = packed<dim>(StressTensor<Real>(rate));
    out[shear_rate] = shear_rate_of(corrected);
    if constexpr (Volume::active) {
      out[number_density] = total[number_density];
      Real const change = consistency_rate(pressure_of(sigma), total) * out[shear_rate];
      for (int a = 0; a < 3; ++a) out[stress_rate][a] -= change;
    }
  }

 private:
  /// dp/d(gamma), Pa.
  template <class Real, class T>
  SCREE_FN Real consistency_rate(Real p, T const& total) const {
    Real const K = Real(law.bulk_modulus()), most = Real(volume_control.largest_strain);
    Real const phi = compactness(total[number_density], norm(total[asymmetry]), Real(asymmetry_at_surface));
    Real const lacking = phi - Real(phi_at_rest) - p / K;
    return Real(volume_control.per_strain) * K * Kokkos::clamp(lacking, -most, most);
  }
};

}  // namespace scree
