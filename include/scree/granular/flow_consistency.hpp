// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "volume_control.hpp"

namespace scree {

/// Volume control that relaxes the pressure towards K (phi - phi_0), the value that belongs to the compactness, like
/// VolumeConsistency, but only where the material flows or carries no load. Where loaded material hardly moves, its
/// stress follows from its history, so that a heap does not subside. The measure of flow is $N = (\dot\gamma h/c_s)
/// \sqrt{K/p}$, about the velocity difference of neighbours over $\sqrt{p/\rho}$. Loaded material is not controlled if
/// N is below `rest` and fully controlled if N is above `flow`; in between the share of the control rises smoothly.
/// Where the material carries no load, the gap of VolumeMemory takes the place of the pressure.
struct FlowConsistency {
  static constexpr bool active = true;
  static constexpr bool needs_memory = true;
  double per_strain = 1;
  double per_strain_unloaded = 3;
  double rest = 3e-3;
  double flow = 3e-2;
  double largest_strain = 0.3;

  static constexpr auto parameters() {
    return std::array{
        parameter("per_strain", &FlowConsistency::per_strain, "1",
                  "share of the error of volume taken back per shear strain in flow under load", allowed::at_least(0)),
        parameter("per_strain_unloaded", &FlowConsistency::per_strain_unloaded, "1", "the same without pressure",
                  allowed::at_least(0)),
        parameter("rest", &FlowConsistency::rest, "1",
                  "N, see flow_consistency.hpp, up to which loaded material is left alone", allowed::at_least(0)),
        parameter("flow", &FlowConsistency::flow, "1", "N from which it is controlled in full",
                  allowed::above(0, "above 0, and not below `rest`")),
        parameter("largest_strain", &FlowConsistency::largest_strain, "1", "bound of phi - phi_0 - p/K",
                  allowed::at_least_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_parameters(*this, "FlowConsistency");
    check_setting(flow >= rest, "flow (-) of FlowConsistency", flow, "`rest` or more");
  }
  /// Returns the share of the control at a pressure p > 0 (Pa): 0 at rest, 1 in flow. `sheared` is the shear strain in
  /// the time in which sound travels h, $\dot\gamma h/c_s$.
  template <class Real>
  SCREE_FN Real share(Real p, Real K, Real sheared) const {
    if (sheared == 0) return Real(0);  // K/p overflows if p is very small
    Real const N = sheared * Kokkos::sqrt(K / p);
    if (N >= Real(flow)) return Real(1);
    if (N <= Real(rest)) return Real(0);
    Real const s = (N - Real(rest)) / Real(flow - rest);
    return s * s * (3 - 2 * s);
  }
  /// Returns the change of the pressure per shear strain, dp/d(gamma), Pa, see VolumeControl.
  template <class Real>
  SCREE_FN Real pressure_per_strain(Real p, Real K, Real denser, Real sheared) const {
    Real const rate = p > 0 ? Real(per_strain) * share(p, K, sheared) : Real(per_strain_unloaded);
    Real const most = Real(largest_strain), lacking = denser - p / K;
    return rate * K * Kokkos::clamp(lacking, -most, most);
  }
};

}  // namespace scree
