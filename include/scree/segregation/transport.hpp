// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../solver/limit.hpp"
#include "../solver/pass.hpp"
#include "../solver/resolution.hpp"
#include "../terms/velocity_gradient.hpp"
#include "closure.hpp"
#include "flux.hpp"

// What every transport scheme of the concentration needs.
namespace scree {

/// Component of a vector along gravity, which acts against the last coordinate.
template <class X>
SCREE_FN auto along_gravity(X const& x) {
  return -x[X::RowsAtCompileTime - 1];
}

/// The pass that finds the shear rate, where a closure asks for it and nothing else finds it.
template <class Closure>
auto shear_rate_passes() {
  if constexpr (OneOf<ShearRate, reads_of<Closure>>)
    return std::tuple(pair_pass_then<Material>("scree::shear_rate", CorrectedShearRate{},
                                               over<Material>(VelocityGradientSum{}, FirstMomentSum{})));
  else
    return std::tuple<>();
}

/// Explicit limits of transport: dt <= diffusion h^2/max D and dt <= segregation h/(A max V); they hold also where the
/// motion is prescribed.
struct TransportStep {
  double diffusion = 0.1;    ///< -
  double segregation = 0.1;  ///< -

  auto limits(Resolution const& resolution, SegregationFlux const& flux) const {
    double const h = resolution.smoothing_length;
    return std::tuple(
        limit("diffusion", Magnitude<Diffusivity>{}, [=, c = diffusion](double D) { return c * h * h / D; }),
        limit("segregation", Magnitude<SegregationVelocity>{},
              [=, c = segregation](double V) { return c * h / (flux.amplitude * V); }));
  }
};

}  // namespace scree
