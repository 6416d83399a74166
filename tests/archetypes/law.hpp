// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/laws/law.hpp>

namespace scree::test::archetypes {

/// Pressure from the rate of volume alone.
struct Law {
  double rest_density = 0, K = 0;  // kg/m^3, Pa
  using reads = Fields<>;
  using history = Fields<>;
  SCREE_FN double density() const { return rest_density; }
  SCREE_FN double bulk_modulus() const { return K; }
  SCREE_FN double sound_speed() const { return Kokkos::sqrt(K / rest_density); }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const&, Mat<3, Real> const& L, Point const&) const {
    return Real(K) * trace(L) * identity_matrix<StressTensor<Real>>();
  }
  template <class Real, class Point, class Memory>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const&, Memory&&) const {
    return trial;
  }
};
static_assert(ConstitutiveLaw<Law>);

}  // namespace scree::test::archetypes
