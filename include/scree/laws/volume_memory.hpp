// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"

namespace scree {

/// Volume by which a point has opened since it lost contact, relative to its own; zero while it is compressed.
struct Opening : Scalar<"opening", "1"> {};
inline constexpr Opening opening{};

/// A cohesionless law that remembers how far it was pulled apart: what opened closes before pressure returns. The law
/// alone forgets it, because its stress stays at the apex, and recovers pressure on the way back from wherever it
/// turns. Of a law with cohesion it takes the tension away. An addition to Zhu et al. (2024).
///
/// Only so much is remembered as a particle can lack that has left its neighbours, one minus its own share V W(0) of
/// the number density; the rest of the way it meets others, or a wall, which it would pass unresisted.
template <class Law>
struct VolumeMemory {
  Law law = {};
  bool remembers = true;         ///< off: the law as it is
  double largest_opening = 0.5;  ///< -

  using reads = typename Law::reads;
  using history = Merge<Fields<Opening>, typename Law::history>;

  void check() const { check_settings_of(law); }
  SCREE_FN double bulk_modulus() const { return law.bulk_modulus(); }
  SCREE_FN double density() const { return law.density(); }
  double sound_speed() const { return law.sound_speed(); }

  template <class Real>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L) const {
    return law.stress_rate(sigma, L);
  }
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return law.shear_strength(p, point);
  }
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    memory[opening] = Real(0);
    if (!remembers) return law.admissible(trial, point, memory);
    // p/K is the compression that the rate alone gives; what is still open takes it up first.
    Real const K = Real(law.bulk_modulus()), gap = point[opening];
    Real const compression = pressure_of(trial) / K - gap;
    memory[opening] = compression > 0 ? Real(0) : Kokkos::min(-compression, Real(largest_opening));
    StressTensor<Real> closed = zero<StressTensor<Real>>();
    if (compression > 0) closed = trial + K * gap * identity_matrix<StressTensor<Real>>();
    // The law is asked also while the point is open, for it may have a history of its own to write.
    return law.admissible(closed, point, memory);
  }
};

}  // namespace scree
