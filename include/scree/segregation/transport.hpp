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

// Shared by all transport schemes of the concentration.
namespace scree {

/// The pass that computes the shear rate, if a closure needs it and no other pass computes it.
template <class Closure>
auto shear_rate_passes() {
  if constexpr (OneOf<ShearRate, reads_of<Closure>>)
    return std::tuple(pair_pass_then<Material>("scree::shear_rate", CorrectedShearRate{},
                                               over<Material>(VelocityGradientSum{}, FirstMomentSum{})));
  else
    return std::tuple<>();
}

/// The distance of a concentration from [0, 1].
struct ConcentrationOutside {
  using reads = Fields<Concentration>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    auto const C = i[fields::concentration];
    return Kokkos::max(decltype(C + C)(0), Kokkos::max(-C, C - 1));
  }
};
/// The bound of a scheme whose concentrations may lie outside of 0 to 1 by `most`.
inline auto concentration_bound(double most) {
  return bound("distance of the concentration from [0, 1]", ConcentrationOutside{}, most,
               "it is the share of the small grains, 0 to 1");
}

/// Explicit limits of transport: dt <= diffusion $h^2/\max D$ and dt <= segregation h/(A max V); they also hold where
/// the motion is prescribed.
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
  /// The limits of the step for grains that segregate at `amplitude` times a measured speed (m/s).
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
