// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/continuity.hpp>

#include <scree/terms/kernel_sums.hpp>
#include <scree/terms/velocity_gradient.hpp>

#include "mechanics.hpp"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::continuity_tests {
using namespace fields;

struct Self {};

TEMPLATE_LIST_TEST_CASE("density changes by minus the trace of the plain velocity gradient", "", Policies) {
  using P = TestType;
  auto body = disordered<P, DensityRate, VelocityGradient>();
  sum_over_itself(body, 0.2, Continuity{}, VelocityGradientSum{});
  auto const rate = body.to_host(density_rate), rho = body.to_host(density);
  auto const L = body.to_host(velocity_gradient);
  double worst = 0, largest_rate = 0;
  for (std::size_t i = 0; i < rate.size(); ++i) {
    worst = std::max(worst, double(std::abs(rate[i] / rho[i] + L[i].trace())));
    largest_rate = std::max(largest_rate, double(std::abs(rate[i] / rho[i])));
  }
  CHECK(worst < ulps<P>(20) * largest_rate);
  CHECK(largest_rate > 1);
}

TEMPLATE_LIST_TEST_CASE("density changes as the number density does when particles move", "", DoublePolicies) {
  using P = TestType;
  auto const points = lattice<P::dim>(0.125, 0.3);
  auto const velocity_at = [](auto const& x) { return (x.reverse().array().sin() - 2 * x.array()).matrix().eval(); };
  auto body = body_of<P, Density, DensityRate, Velocity>(points, std::pow(0.125, P::dim));
  body.fill(density, 1);
  set(body, velocity, velocity_at);
  sum_over_itself(body, 0.2, Continuity{});
  double const step = 1e-5;
  auto const number_density_after = [&](double time) {
    auto moved = points;
    for (auto& x : moved) x += time * velocity_at(x);
    auto at = body_of<P, KernelSum<Self>, KernelGradient<Self>>(moved, std::pow(0.125, P::dim));
    sum_over_itself(at, 0.2, KernelSums<Self>{});
    return at.to_host(kernel_sum<Self>);
  };
  auto const ahead = number_density_after(step), behind = number_density_after(-step);
  auto const rate = body.to_host(density_rate);
  double worst = 0;
  for (std::size_t i = 0; i < rate.size(); ++i)
    worst = std::max(worst, std::abs((ahead[i] - behind[i]) / (2 * step) - rate[i]));
  CHECK(worst < 1e-6);
}

TEST_CASE("uniform compression raises the density at its rate, and volume falls as density rises") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto body = body_of<P, Density, DensityRate, Velocity, Mass>(lattice<2>(0.1), 0.01);
  body.fill(density, 1200);
  body.fill(mass, 6);
  set(body, velocity, [](auto const& x) { return (-0.5 * x).eval(); });
  sum_over_itself(body, 0.15, Continuity{});
  // div u = -1, times the first moment of the lattice, 0.99740.
  auto const inside = [](auto const& x) { return deep_inside<2>(x, 0.26); };
  CHECK(largest_error(
            body, density_rate, 1200, [](auto const&) { return 1200 * 0.99740; }, inside) < 1e-5);
  for_each_particle<P>("volume", body, VolumeOfDensity{});
  CHECK(largest_error(body, volume, 1, [](auto const&) { return 0.005; }) < 1e-17);
}

TEST_CASE("terms take a density that is the same for all or that of each particle") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  Record<P, Fields<Volume, Density>> const i{{0.1}, {1300}};
  CHECK(UniformDensity{1500}.of(i) == 1500);
  CHECK(DensityOfParticle{}.of(i) == 1300);
  Record<Policy<2, float, P::space>, Fields<Volume>> const in_float{{0.1f}};
  STATIC_CHECK(std::is_same_v<decltype(UniformDensity{}.of(in_float)), float>);
}

}  // namespace scree::test::continuity_tests
