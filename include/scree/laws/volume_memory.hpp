// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"
#include "response.hpp"

namespace scree {

/// Volumetric strain by which the material has opened since it lost contact; zero while it is compressed.
struct Opening : Scalar<"opening", "1"> {};

namespace fields {
inline constexpr Opening opening{};
}  // namespace fields

/// A law that stores the volumetric strain of the gap that opens under tension; the gap must close before pressure
/// returns. Without this memory the stress stays at the apex while the material opens, and pressure recovers as soon as
/// the motion reverses, however far the material has opened. VolumeMemory removes the tensile strength of a cohesive
/// law. It is an addition to Zhu et al. (2024). All other functions are inherited from the law, which is the base class
/// and is initialised first: VolumeMemory<MuOfI<>>{{.elastic = ...}, false}.
///
/// The stored gap is limited to the number density that an isolated particle lacks, one minus its own contribution V
/// W(0). If the gap were larger, a returning particle would pass through other particles or a wall without resistance.
template <class Law>
struct VolumeMemory : Law {
  bool remembers = true;  ///< false: the law without the gap
  double largest_opening = 0.5;

  using history = Merge<Fields<Opening>, typename Law::history>;

  static constexpr auto parameters() {
    return std::array{parameter("largest_opening", &VolumeMemory::largest_opening, "1",
                                "largest strain of a gap that must close again", allowed::at_least_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_settings_of(static_cast<Law const&>(*this));
    detail::check_response(static_cast<Law const&>(*this));
    check_parameters(*this, "VolumeMemory");
  }
  /// Returns the stress of the law if the gap has closed, and zero while the gap is open. Stores the new gap in
  /// `memory`.
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    using namespace fields;
    memory[opening] = Real(0);
    if (!remembers) return Law::admissible(trial, point, memory);
    // p/K is the compression that results from the rate alone; it closes the gap before pressure builds up.
    Real const K = bulk_modulus_at(static_cast<Law const&>(*this), trial, point), gap = point[opening];
    Real const compression = pressure_of(trial) / K - gap;
    memory[opening] = compression > 0 ? Real(0) : Kokkos::min(-compression, Real(largest_opening));
    StressTensor<Real> closed = zero<StressTensor<Real>>();
    if (compression > 0) closed = trial + K * gap * identity_matrix<StressTensor<Real>>();
    // The law is also evaluated while the gap is open, because it may have internal variables to write.
    return Law::admissible(closed, point, memory);
  }
};

}  // namespace scree
