// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/axial.hpp"
#include "../core/symmetric.hpp"
#include "../core/symmetric3.hpp"
#include "density.hpp"
#include "kernel_correction.hpp"

// The spin of the material from its plain velocity gradient L, and the stress that is adjoint to the spin. A rotation W
// has the plain gradient W A with the moment $A = -\sum_j V_j x_{ij} \otimes \nabla W_{ij}$, which acts like a moment
// of inertia. See docs/theory/granular.md, "Soil that turns".
namespace scree {

/// The axial vector of the antisymmetric part of the stress in the momentum balance.
struct AntisymmetricStress : Axial<"antisymmetric stress", "Pa"> {};

namespace fields {
inline constexpr AntisymmetricStress antisymmetric_stress{};
}  // namespace fields

/// Returns the axial vector w with (tr(A) - A) w = b. In 2D, w = b/tr(A). The same holds in 3D if the neighbours lie on
/// a line, which leaves the component of w along the line undetermined. `moment` is -A.
template <int Dim, class Real>
SCREE_FN Vec<axial_size<Dim>, Real> over_inertia(Vec<axial_size<Dim>, Real> const& b, Mat<Dim, Real> const& moment) {
  auto w = zero<Vec<axial_size<Dim>, Real>>();
  Real const size = -trace(moment);
  if (size > 0) w = b / size;
  if constexpr (Dim == 3) {
    Mat<3, Real> inertia = moment;
    for (int a = 0; a < 3; ++a) inertia(a, a) += size;
    solve_positive_definite<3, Real>(inertia, b, Real(1e-3), w);
  }
  return w;
}

/// Returns the rotation W (1/s) whose plain gradient W A has the same antisymmetric part as L.
template <int Dim, class Real>
SCREE_FN Mat<Dim, Real> spin_of(Mat<Dim, Real> const& L, Mat<Dim, Real> const& moment) {
  return antisymmetric<Dim, Real>(over_inertia<Dim, Real>(twice_axial<Dim, Real>(L), moment));
}

/// The antisymmetric part a of the stress, which makes (sigma + a x) A symmetric, so the stress does no work on a
/// rotation.
struct AntisymmetricStressOf {
  using reads = Fields<Stress, FirstMoment>;
  using writes = Fields<AntisymmetricStress>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Matrix = std::remove_cvref_t<decltype(i[first_moment])>;
    using Real = typename Matrix::Scalar;
    constexpr int dim = Matrix::RowsAtCompileTime;
    Matrix const moment = i[first_moment];
    Mat<3, Real> const full = unpacked(i[stress]);
    Matrix sigma;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) sigma(a, b) = full(a, b);
    // A = -moment
    out[antisymmetric_stress] = over_inertia<dim, Real>(twice_axial<dim, Real>(sigma * moment), moment);
  }
};

/// The contribution of the antisymmetric stress a to the acceleration, $(1/\rho_i) \sum_j V_j (a_i + a_j) \times \nabla
/// W_{ij}$.
template <class Rho>
struct AntisymmetricStressDivergence {
  static_assert(detail::explain_density<Rho>());
  Rho rho;  ///< density of i
  using reads = Fields<Volume, AntisymmetricStress>;
  using reads_i = typename Rho::reads;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[acceleration] +=
        (rho.inverse_of(i) * j[volume] * ij.slope()) * cross(i[antisymmetric_stress] + j[antisymmetric_stress], ij.x);
  }
};

}  // namespace scree
