// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "by_hand/motion_cuda.hpp"
#include "sum_rows.hpp"

#include <scree/system/system.hpp>
#include <scree/terms/artificial_viscosity.hpp>
#include <scree/terms/laplacian.hpp>
#include <scree/terms/stress_divergence.hpp>
#include <scree/terms/velocity_gradient.hpp>

#include <limits>

// The motion pass by the library and by hand, with the same values, and a check that their sums agree.
namespace scree::bench {

struct MotionOptions {
  static constexpr double density = 1500, speed = 0.5;
  static constexpr double skin = 0.1;  // the skin of the library, for the same candidates
};

template <class P>
using MotionSum = SelfSum<P, VelocityGradientSum, StressDivergence<>, ArtificialViscosity<>,
                          DoubleSumLaplacian<Concentration, Diffusivity>>;

template <class P>
MotionSum<P> motion_sum(Cloud<P::dim> const& cloud) {
  UniformDensity const rho{MotionOptions::density};
  return MotionSum<P>(cloud, {{}, {rho}, {rho, MotionOptions::speed}, {}});
}

template <class P>
using MotionByHand = by_hand::Motion<P::dim, typename P::real>;

/// With the particles of `sum`, and a list that reaches a skin beyond the support.
template <class P>
MotionByHand<P> motion_by_hand(Cloud<P::dim> const& cloud, MotionSum<P> const& sum, double skin) {
  using namespace fields;
  using Real = typename P::real;
  constexpr int dim = P::dim;
  double const h = cloud.smoothing_length, slope_at_zero = WendlandC2::dw_over_q(0.0);
  by_hand::Constants<Real> const constants{
      .squared_radius = Real(sq(cloud.support)),
      .half_inverse_h = Real(0.5 / h),
      .slope_factor = Real(slope_at_zero * WendlandC2::sigma<dim>() / math::power<dim + 2>(h)),
      .inverse_rho = Real(1 / MotionOptions::density),
      .speed_times_h = Real(MotionOptions::speed * h),
      .softening = Real(sq(h) / 100)};

  auto const x = sum.body.to_host(position), u = sum.body.to_host(velocity);
  auto const s = sum.body.to_host(stress);
  auto const V = sum.body.to_host(volume), C = sum.body.to_host(concentration), D = sum.body.to_host(diffusivity);
  std::vector<by_hand::Particle<dim, Real>> particles(x.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    auto& p = particles[i];
    for (int a = 0; a < dim; ++a) p.x[a] = x[i][a], p.u[a] = u[i][a];
    for (int k = 0; k < p.stresses; ++k) p.s[k] = s[i][dim == 2 && k == 2 ? 3 : k];
    p.V = V[i], p.C = C[i], p.D = D[i];
  }
  double const length = cloud.spacing * std::round(std::pow(double(x.size()), 1.0 / dim));
  return MotionByHand<P>(constants, particles, Real(length), Real((1 + skin) * cloud.support));
}

/// The largest difference between both sums, relative to the largest value of each: rounding of some hundred summands.
template <class P>
double disagreement(MotionSum<P> const& sum, MotionByHand<P> const& by_hand) {
  using namespace fields;
  constexpr int dim = P::dim;
  auto const sums = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), by_hand.sums);
  auto const L = sum.body.to_host(velocity_gradient);
  auto const a = sum.body.to_host(acceleration);
  auto const lap = sum.body.to_host(laplacian<Concentration, Diffusivity>);
  double difference[3] = {}, largest[3] = {};
  auto const compare = [&](int what, double one, double other) {
    difference[what] = std::max(difference[what], std::isfinite(one - other) ? std::abs(one - other) : 1e300);
    largest[what] = std::max(largest[what], std::abs(one));
  };
  for (std::size_t i = 0; i < L.size(); ++i) {
    for (int r = 0; r < dim; ++r) {
      for (int c = 0; c < dim; ++c) compare(0, double(L[i](r, c)), double(sums(i, r * dim + c)));
      compare(1, double(a[i][r]), double(sums(i, dim * dim + r)));
    }
    compare(2, double(lap[i]), double(sums(i, dim * dim + dim)));
  }
  return std::max({difference[0] / largest[0], difference[1] / largest[1], difference[2] / largest[2]});
}

template <class P>
double tolerated_disagreement() {
  return 500 * double(std::numeric_limits<typename P::real>::epsilon());
}

}  // namespace scree::bench
