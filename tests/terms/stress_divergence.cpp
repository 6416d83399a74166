// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/stress_divergence.hpp>

#include <support/lattice_sums.hpp>

#include "mechanics.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::stress_divergence_tests {
using namespace fields;
namespace {

constexpr double rho = 1500;

template <class P, class Function>
auto stressed(double spacing, Function const& sigma) {
  auto body = body_of<P, Stress, Acceleration>(lattice<P::dim>(spacing), std::pow(spacing, P::dim));
  set(body, stress, sigma);
  sum_over_itself(body, 1.5 * spacing, StressDivergence<>{{rho}});
  return body;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("forces of stresses add up to nothing on disordered particles", "", Policies) {
  auto body = disordered<TestType>();
  sum_over_itself(body, 0.2, StressDivergence<DensityOfParticle>{});
  auto const balance = balance_of(body);
  CHECK(balance.force < ulps<TestType>(10) * balance.forces);
  CHECK(balance.forces > 100);
}

TEMPLATE_LIST_TEST_CASE(
    "between unlike densities forces add up to nothing, too, and between like ones they are the same", "", Policies) {
  auto body = disordered<TestType>();
  sum_over_itself(body, 0.2, InterfaceStressDivergence<DensityOfParticle>{});
  auto const balance = balance_of(body);
  CHECK(balance.force < ulps<TestType>(10) * balance.forces);
  CHECK(balance.forces > 100);
  sum_over_itself(body, 0.2, InterfaceStressDivergence<UniformDensity>{{rho}});
  auto const found = body.to_host(acceleration);
  sum_over_itself(body, 0.2, StressDivergence<>{{rho}});
  auto const expected = body.to_host(acceleration);
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    difference = std::max(difference, double((found[i] - expected[i]).norm()));
    size = std::max(size, double(expected[i].norm()));
  }
  CHECK(difference < ulps<TestType>(100) * size);
}

TEMPLATE_LIST_TEST_CASE("a hydrostatic stress is in equilibrium across an interface of densities", "", DoublePolicies) {
  using P = TestType;
  constexpr int dim = P::dim, z = dim - 1;
  double const spacing = 0.05, light = 1000, heavy = 2000;
  auto const density_at = [&](auto const& x) { return x[z] < 0.5 ? heavy : light; };
  auto const off = [&](auto const& divergence) {
    auto body = body_of<P, Stress, Density, Acceleration>(lattice<dim>(spacing), std::pow(spacing, dim));
    set(body, density, density_at);
    set(body, stress, [&](auto const& x) {
      Vec<symmetric3_size<dim>, double> sigma = Vec<symmetric3_size<dim>, double>::Zero();
      sigma[z] = -9.81 * (x[z] < 0.5 ? light * 0.5 + heavy * (0.5 - x[z]) : light * (1 - x[z]));
      return sigma;
    });
    sum_over_itself(body, 1.5 * spacing, divergence);
    double worst = 0;
    auto const x = body.to_host(position);
    auto const a = body.to_host(acceleration);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (deep_inside<dim>(x[i], 0.16)) worst = std::max(worst, std::abs(a[i][z] / 9.81 - 1));
    return worst;
  };
  double const here = off(InterfaceStressDivergence<DensityOfParticle>{});
  double const of_paper = off(StressDivergence<DensityOfParticle>{});
  INFO("off by " << here << " g; with (3.9) of the paper by " << of_paper << " g");
  CHECK(here < 0.5);
  CHECK(of_paper > 1);
}

TEMPLATE_LIST_TEST_CASE("stress that grows downwards bears the weight", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim, z = dim - 1;
  // sigma_zz = -rho g (1 - z) pushes up with g; on a lattice, times the first moment of the kernel gradient.
  auto const body = stressed<P>(0.1, [](auto const& x) {
    Vec<symmetric3_size<dim>, double> sigma = Vec<symmetric3_size<dim>, double>::Zero();
    sigma[z] = -rho * 9.81 * (1 - x[z]);
    return sigma;
  });
  Vec<dim, double> up = Vec<dim, double>::Zero();
  up[z] = -LatticeSums<dim>(1.5).moment * 9.81;
  auto const inside = [](auto const& x) { return deep_inside<dim>(x, 0.26); };
  CHECK(largest_error(
            body, acceleration, 9.81, [&](auto const&) { return up; }, inside) < ulps<P>(3e3));
}

TEMPLATE_LIST_TEST_CASE("the stress divergence is of second order where the support is full", "", DoublePolicies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto const error = [](double spacing) {
    auto const body = stressed<P>(spacing, [](auto const& x) {
      Vec<symmetric3_size<dim>, double> sigma = Vec<symmetric3_size<dim>, double>::Zero();
      sigma[0] = rho * std::sin(2 * x[0]);
      sigma[dim == 2 ? 3 : 4] = rho * std::cos(x[0] - 2 * x[dim - 1]);
      return sigma;
    });
    double const moment = -LatticeSums<dim>(1.5).moment;
    auto const exact = [&](auto const& x) {
      double const s = std::sin(x[0] - 2 * x[dim - 1]);
      Vec<dim, double> a = Vec<dim, double>::Zero();
      a[0] = moment * (2 * std::cos(2 * x[0]) + 2 * s);
      a[dim - 1] = -moment * s;
      return a;
    };
    return largest_error(body, acceleration, 1, exact, [](auto const& x) { return deep_inside<dim>(x, 0.34); });
  };
  double const order = std::log2(error(0.1) / error(0.05));
  INFO("order " << order);
  CHECK(order > 1.8);
}

}  // namespace scree::test::stress_divergence_tests
