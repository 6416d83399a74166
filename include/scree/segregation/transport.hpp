// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../passes/limit.hpp"
#include "../passes/pass.hpp"
#include "../passes/resolution.hpp"
#include "../passes/validity.hpp"
#include "../terms/gravity.hpp"
#include "../terms/velocity_gradient.hpp"
#include "closure.hpp"
#include "flux.hpp"

// Parts that all transport schemes of the concentration share.
namespace scree {

/// Returns the pass that computes the shear rate if a closure reads it, for models in which no other pass computes it.
template <class Closure>
auto shear_rate_passes() {
  if constexpr (OneOf<ShearRate, reads_of<Closure>>)
    return std::tuple(pair_pass_then<Material>("scree::shear_rate", CorrectedShearRate{},
                                               over<Material>(VelocityGradientSum{}, FirstMomentSum{})));
  else
    return std::tuple<>();
}

/// The distance of the concentration of a particle from the interval [0, 1].
struct ConcentrationOutside {
  using reads = Fields<Concentration>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    auto const C = i[fields::concentration];
    return Kokkos::max(decltype(C + C)(0), Kokkos::max(-C, C - 1));
  }
};
/// Returns the bound of a scheme whose concentrations may be outside [0, 1] by up to `most`.
inline auto concentration_bound(double most) {
  return bound("distance of the concentration from [0, 1]", ConcentrationOutside{}, most,
               "it is the share of the small grains, 0 to 1");
}

/// Limits of the explicit time step of the transport: dt <= diffusion $h^2/\max D$ and dt <= segregation h/(A max V).
/// They also apply if the motion is prescribed.
struct TransportStep {
  double diffusion = 0.1;
  double segregation = 0.1;

  static constexpr auto parameters() {
    return std::array{
        parameter("diffusion", &TransportStep::diffusion, "1", "step over h^2/D", allowed::above(0, 1)),
        parameter("segregation", &TransportStep::segregation, "1", "step over h/(A V)", allowed::above(0, 1))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "TransportStep"); }
  /// Returns the limits of the time step for grains that segregate at `amplitude` times `speed` (m/s), a function of a
  /// particle.
  template <class Speed>
  auto limits(Resolution const& resolution, Speed const& speed, double amplitude = 1) const {
    double const h = resolution.smoothing_length;
    return std::tuple(
        limit("diffusion", Magnitude<Diffusivity>{}, [=, c = diffusion](double D) { return c * h * h / D; }),
        limit("segregation", speed, [=, c = segregation](double V) { return c * h / (amplitude * V); }));
  }
  auto limits(Resolution const& resolution, SegregationFlux const& flux) const {
    return limits(resolution, Magnitude<SegregationVelocity>{}, flux.amplitude);
  }
};

}  // namespace scree
