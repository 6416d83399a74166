// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/symmetric3.hpp"
#include "../laws/law.hpp"
#include "closure.hpp"

#include <cmath>
#include <string>

namespace scree {

/// V = $B \hat\rho \dot\gamma d^2 [(R - 1) + E (1 - C)(R - 1)^2]/(C_p d + p/(\rho_s g))$ and $D = A \dot\gamma d^2$
/// with d = d_S C + d_L (1 - C), R = d_L/d_S and the pressure p of the stress, for the symmetric flux (Trewhela et al.
/// 2021, eq. 4.9). Grains segregate more slowly under a load. The closure was fitted to experiments with single large
/// and small beads in an oscillating shear cell with R of 1.17 to 4.17; in discrete element simulations, Zhao et al.
/// (2025) find that it holds for inertial numbers of 0.01 to 0.1. A solver warns if R is above 4.17 or if inertial
/// numbers are outside this range.
///
/// The experiment used beads in a liquid, with $B \hat\rho = 0.3744$. Their relative buoyancy $\hat\rho = 0.5255$ gives
/// B = 0.7125 for dry grains. docs/theory/segregation.md lists which of these numbers are not confirmed.
struct TrewhelaClosure {
  double A = 0.108;
  double B = 0.7125;
  double C = 0.2712;  ///< C_p
  double E = 2.0957;
  double d_small = 0;
  double d_large = 0;
  double grain_density = 2500;  ///< rho_s, kg/m^3
  double buoyancy = 1;          ///< (rho_s - rho_f)/rho_s with the density of the fluid between the grains, rho_f
  double gravity = 9.81;        ///< g, m/s^2; a scheme replaces it with the gravity of its mechanics

  using reads = Fields<Concentration, ShearRate, Stress>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  static constexpr auto parameters() {
    return std::array{
        parameter("A", &TrewhelaClosure::A, "1", "D = A shear rate d^2", allowed::at_least(0)),
        parameter("B", &TrewhelaClosure::B, "1", "factor of V for dry grains", allowed::at_least(0)),
        parameter("C", &TrewhelaClosure::C, "1", "C d is added to the depth p/(rho_s g)", allowed::above(0)),
        parameter("E", &TrewhelaClosure::E, "1", "how much faster single small grains are than single large ones",
                  allowed::at_least(0)),
        parameter("d_small", &TrewhelaClosure::d_small, "m", "diameter of the small grains", allowed::above(0)),
        parameter("d_large", &TrewhelaClosure::d_large, "m", "diameter of the large grains",
                  allowed::at_least(0, "`d_small` or more")),
        parameter("grain_density", &TrewhelaClosure::grain_density, "kg/m^3", "density of the solid, rho_s",
                  allowed::above(0)),
        parameter("buoyancy", &TrewhelaClosure::buoyancy, "1",
                  "(rho_s - rho_f)/rho_s with the density rho_f of the fluid between the grains; 1: dry",
                  allowed::from_to(0, 1))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_parameters(*this, "TrewhelaClosure");
    check_setting(d_large >= d_small, "d_large (m) of TrewhelaClosure", d_large, "`d_small` or more");
  }
  /// Returns a copy of the closure for another gravity.
  TrewhelaClosure under(Gravity const& of_mechanics) const {
    auto changed = *this;
    changed.gravity = std::abs(of_mechanics.magnitude);
    return changed;
  }
  /// Returns a warning if the size ratio is above those of the experiments; otherwise an empty text.
  std::string warning() const { return warning_of_size_ratio("TrewhelaClosure", d_large / d_small, 4.17); }
  /// Whether the inertial number $\dot\gamma d/\sqrt{p/\rho_s}$ of a particle is between 0.01 and 0.1.
  template <class I>
  SCREE_FN bool holds_at(I const& i) const {
    double const moved = double(i[fields::shear_rate]) * mean_diameter(i);
    double const square = moved * moved * grain_density, p = pressure(i);
    return square >= 1e-4 * p && square <= 1e-2 * p;
  }
  /// Returns a warning if more than half of the segregation takes place at other inertial numbers and grains have moved
  /// by more than a large diameter; otherwise an empty text.
  [[gnu::cold]] std::string warning_beyond(double share, double way) const {
    if (!(share > 0.5 && way > d_large)) return "";
    return detail::formatted(
        "scree: warning: %.0f %% of the segregation takes place at inertial numbers below 0.01 or above 0.1, where "
        "TrewhelaClosure does not hold; its speeds there are an extrapolation (docs/theory/segregation.md, closures)",
        100 * share);
  }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    double const rate = double(i[shear_rate]), d = mean_diameter(i), excess = d_large / d_small - 1;
    double const of_sizes = excess * (1 + E * (1 - double(i[concentration])) * excess);
    double const unit_weight = grain_density * gravity, load = C * unit_weight * d + pressure(i);
    out[segregation_velocity] = Real(unit_weight > 0 ? B * buoyancy * rate * d * d * of_sizes * unit_weight / load : 0);
    out[diffusivity] = Real(A * rate * d * d);
  }

 private:
  template <class I>
  SCREE_FN double mean_diameter(I const& i) const {
    double const small = double(i[fields::concentration]);
    return d_small * small + d_large * (1 - small);
  }
  /// Returns the pressure, Pa; 0 under tension.
  template <class I>
  SCREE_FN static double pressure(I const& i) {
    return Kokkos::max(0.0, double(pressure_of(unpacked(i[fields::stress]))));
  }
};

}  // namespace scree
