// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/stress_divergence.hpp>

#include <support/lattice_sums.hpp>

#include "mechanics.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test {
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

}  // namespace scree::test
