// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../terms/kernel_sums.hpp"

// What ties the pressure to the spacing of the particles. See docs/theory/granular.md.
namespace scree {

/// sum_j V_j W_ij over material and walls, the particle itself included; 1 where particles stand as densely as at the
/// start.
struct NumberDensity : Scalar<"number density", "1"> {};
inline constexpr NumberDensity number_density{};
/// h sum_j V_j gradW_ij over material and walls: points to where particles are, 0 inside.
struct Asymmetry : Vector<"asymmetry of the neighbours", "1"> {};
inline constexpr Asymmetry asymmetry{};

struct NumberDensitySum {
  using reads = Fields<Volume>;
  using adds = Fields<NumberDensity, Asymmetry>;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    sum[number_density] += j[volume] * ij.W();
    sum[asymmetry] += (j[volume] * ij.h() * ij.slope()) * ij.x;
  }
};

/// As in Zhu et al. (2024): the pressure follows from the rate of volume alone.
struct NoVolumeControl {
  static constexpr bool active = false;
};

/// Relaxes the pressure towards the one that belongs to the number density, p = K (phi - phi_0), over a shear strain of
/// 1/`per_strain`: where grains rearrange, they forget where they were and feel how densely they stand; where nothing
/// is sheared, nothing is added.
struct VolumeConsistency {
  static constexpr bool active = true;
  double per_strain = 1;        ///< -
  double largest_strain = 0.3;  ///< of phi - phi_0 - p/K that counts, -
  double surface = 0.18;        ///< asymmetry beyond which a particle lies at a surface and is left alone, -
};

}  // namespace scree
