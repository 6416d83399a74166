// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../terms/kernel_sums.hpp"

#include <concepts>

// Volume control keeps the pressure consistent with the particle spacing. See docs/theory/granular.md.
namespace scree {

/// The number density $\sum_j V_j W_{ij}$ over material and walls, including the particle itself; 1 if the particles
/// are as dense as at the start.
struct NumberDensity : Scalar<"number density", "1"> {};
/// The asymmetry of the neighbours, $h \sum_j V_j \nabla W_{ij}$ over material and walls: it points towards the
/// particles and is 0 inside the material.
struct Asymmetry : Vector<"asymmetry of the neighbours", "1"> {};

namespace fields {
inline constexpr NumberDensity number_density{};
inline constexpr Asymmetry asymmetry{};
}  // namespace fields

/// Pair term for the sums for the number density and the asymmetry of the neighbours.
struct NumberDensitySum {
  using reads = Fields<Volume>;
  using adds = Fields<NumberDensity, Asymmetry>;
  static constexpr bool takes_packs = true;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[number_density] += j[volume] * ij.W();
    sum[asymmetry] += (j[volume] * ij.h() * ij.slope()) * ij.x;
  }
};

/// Whether a volume control depends on the rate of flow, see VolumeControl.
template <class V>
concept ControlOfFlow = requires(V const& control) {
  { control.pressure_per_strain(1.0, 1.0, 0.0, 0.0) } -> std::same_as<double>;
  { control.pressure_per_strain(1.0f, 1.0f, 0.0f, 0.0f) } -> std::same_as<float>;
};
/// A volume control is a struct with these members:
///   active                               constant: whether the pressure is controlled at all
///   pressure_per_strain(p, K, denser)    the change of the pressure per shear strain, Pa, from the pressure p (Pa),
///                                        the bulk modulus K (Pa) and the excess `denser` of the compactness over its
///                                        value at the start, see compactness(); only if `active` is true
/// or, in its place,
///   pressure_per_strain(p, K, denser, sheared)    the change of the pressure per shear strain, Pa, from p, K, `denser`
///                                                 and the shear strain `sheared` in the time in which sound travels h,
///                                                 gamma_dot h/c_s
/// and optionally
///   needs_memory                         constant: whether Granular evolves the stress by VolumeMemory<law>
template <class V>
concept VolumeControl = requires {
  { V::active } -> std::convertible_to<bool>;
}
&&(!V::active || ControlOfFlow<V> || requires(V const& control) {
  { control.pressure_per_strain(1.0, 1.0, 0.0) } -> std::same_as<double>;
  { control.pressure_per_strain(1.0f, 1.0f, 0.0f) } -> std::same_as<float>;
});

/// Whether a volume control acts on the gaps stored by VolumeMemory.
template <class V>
concept NeedsMemory = requires {
  requires V::needs_memory;
};

/// The volume control that does nothing, as in Zhu et al. (2024): the pressure follows from the volumetric strain rate
/// alone.
struct NoVolumeControl {
  static constexpr bool active = false;
};

/// Returns the compactness: the number density phi corrected for a support that is truncated by a surface. At a plane
/// surface both the missing part, 1 - Phi, and the asymmetry, W1, are functions of the distance to the surface, and the
/// ratio of asymmetry to phi, W1/Phi, determines this distance for any particle density. `at_surface` is the largest
/// asymmetry, W1(0). With $y = 1 - \sqrt{1 - W_1/W_1(0)}$ the fit 1 - Phi = y (0.19 + 2.283 y)/(1 + 3.946 y) is within
/// 0.005 of the integrals of the Wendland C2 kernel in 2D and 3D.
template <class Real>
SCREE_FN Real compactness(Real phi, Real asymmetry_of_phi, Real at_surface) {
  // Below a plane surface the ratio is less than 2; in the plane of the surface, where Phi = 1/2, it is 2.
  if (!(asymmetry_of_phi < 2 * at_surface * phi)) return 2 * phi;
  Real const ratio = asymmetry_of_phi / (at_surface * phi);
  Real const a = Real(0.19), b = Real(2.283), c = Real(3.946);
  // W1/W1(0) = y (2 - y) = ratio Phi(y) is a cubic in y; three Newton iterations from ratio/2 leave only rounding
  // errors.
  Real y = ratio / 2;
  for (int iteration = 0; iteration < 3; ++iteration) {
    Real const error = y * (2 - y) * (1 + c * y) - ratio * (1 + (c - a - b * y) * y);
    y -= error / (2 + (4 * c - 2) * y - 3 * c * y * y - ratio * (c - a - 2 * b * y));
  }
  return phi / (1 - y * (a + b * y) / (1 + c * y));
}

/// Volume control that relaxes the pressure towards p = K (phi - phi_0), the value that belongs to the compactness,
/// over a shear strain of 1/`per_strain`. If grains rearrange, the pressure follows the present packing instead of the
/// strain history; without shear the pressure is not changed.
struct VolumeConsistency {
  static constexpr bool active = true;
  double per_strain = 1;
  double largest_strain = 0.3;

  static constexpr auto parameters() {
    return std::array{parameter("per_strain", &VolumeConsistency::per_strain, "1",
                                "share of the error of volume taken back per shear strain", allowed::at_least(0)),
                      parameter("largest_strain", &VolumeConsistency::largest_strain, "1", "bound of phi - phi_0 - p/K",
                                allowed::at_least_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "VolumeConsistency"); }
  template <class Real>
  SCREE_FN Real pressure_per_strain(Real p, Real K, Real denser) const {
    Real const most = Real(largest_strain), lacking = denser - p / K;
    return Real(per_strain) * K * Kokkos::clamp(lacking, -most, most);
  }
};

}  // namespace scree
