// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "sum_rows.hpp"

#include <scree/granular/stress_filter.hpp>
#include <scree/granular/volume_control.hpp>
#include <scree/system/system.hpp>
#include <scree/terms/artificial_viscosity.hpp>
#include <scree/terms/continuity.hpp>
#include <scree/terms/laplacian.hpp>
#include <scree/terms/stress_divergence.hpp>
#include <scree/terms/velocity_gradient.hpp>
#include <scree/terms/xsph.hpp>

namespace scree::bench {

/// Each standard term alone.
template <class P>
int add_term_rows() {
  UniformDensity const rho{1500};
  auto const add = [](char const* term, auto const& value) {
    add_sum_rows<P>(fmt::format("term/{}", term), 1.5, value);
  };
  add("velocity_gradient", VelocityGradientSum{});
  add("first_moment", FirstMomentSum{});
  add("stress_divergence", StressDivergence<>{rho});
  add("artificial_viscosity", ArtificialViscosity<>{rho, 0.5});
  add("gradient", PlainGradient<Concentration>{});
  add("laplacian", DoubleSumLaplacian<Concentration, Diffusivity>{});
  add("continuity", Continuity{});
  add("kernel_sums", KernelSums<Material>{});
  add("number_density", NumberDensitySum{});
  add("shepard_stress", ShepardSums<Stress>{});
  add("linear_filter", linear_filter::Sums{});
  add("xsph", MeanVelocityDifference<>{rho});
  add("segregation_disorder", pair_weights::DisorderSums{});
  add("segregation_fourth_moment", pair_weights::FourthMomentSum{});
  add("segregation_transport", PairTransport{SegregationFlux::symmetric(), GravityDirection{}});
  return 0;
}

}  // namespace scree::bench
