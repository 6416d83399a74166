// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"

namespace scree {

/// Volumetric strain by which a point has opened since it lost contact; zero while it is compressed.
struct Opening : Scalar<"opening", "1"> {};
inline constexpr Opening opening{};

/// A cohesionless law that remembers the volumetric gap strain: the gap must close before pressure returns. Without
/// this the stress stays at the apex while the material opens, and pressure recovers as soon as the motion reverses,
/// wherever that is. It removes the tensile strength of a cohesive law. An addition to Zhu et al. (2024).
///
/// The stored gap is capped at the number density that an isolated particle lacks, one minus its own share V W(0). On
/// the rest of the way back the particle meets others, or a wall, and would pass through them without resistance if the
/// gap were larger.
template <class Law>
struct VolumeMemory {
  Law law = {};
  bool remembers = true;         ///< off: the law without the gap
  double largest_opening = 0.5;  ///< -

  using reads = typename Law::reads;
  using history = Merge<Fields<Opening>, typename Law::history>;

  void check() const { check_settings_of(law); }
  /// Constants or functions of the state, as the law has them: `state` is the point of a density, sigma and the point
  /// of a stiffness.
  template <class... State>
  SCREE_FN auto density(State const&... state) const -> decltype(law.density(state...)) {
    return law.density(state...);
  }
  template <class... State>
  SCREE_FN auto bulk_modulus(State const&... state) const -> decltype(law.bulk_modulus(state...)) {
    return law.bulk_modulus(state...);
  }
  template <class... State>
  SCREE_FN auto sound_speed(State const&... state) const -> decltype(law.sound_speed(state...)) {
    return law.sound_speed(state...);
  }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    return law.stress_rate(sigma, L, point);
  }
  template <class Real, class Point, class Rates>
  SCREE_FN void history_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L, Point const& point,
                             Rates& rates) const requires EvolvesHistory<Law> {
    law.history_rate(sigma, L, point, rates);
  }
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return law.shear_strength(p, point);
  }
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    memory[opening] = Real(0);
    if (!remembers) return law.admissible(trial, point, memory);
    // p/K is the compression that the rate alone gives; it closes the gap first.
    Real const K = bulk_modulus_at(law, trial, point), gap = point[opening];
    Real const compression = pressure_of(trial) / K - gap;
    memory[opening] = compression > 0 ? Real(0) : Kokkos::min(-compression, Real(largest_opening));
    StressTensor<Real> closed = zero<StressTensor<Real>>();
    if (compression > 0) closed = trial + K * gap * identity_matrix<StressTensor<Real>>();
    // The law is evaluated while the gap is open as well, because it may have internal variables to write.
    return law.admissible(closed, point, memory);
  }
};

}  // namespace scree
