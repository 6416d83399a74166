// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/artificial_stress.hpp>

#include <scree/terms/stress_divergence.hpp>

#include "mechanics.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::artificial_stress_tests {
using namespace fields;
namespace {

constexpr double rho = 1000;

/// Growth rate of the displacements of a lattice under uniform tension, sum d . a/(sum d^2) (1/s^2), with small
/// displacements of every other row along the first axis; above zero they grow.
template <class P>
double growth(double epsilon) {
  constexpr int dim = P::dim;
  double const spacing = 0.1, d = 1e-3 * spacing;
  auto points = lattice<dim>(spacing);
  auto const sign = [&](auto const& x) { return std::lround(x[0] / spacing - 0.5) % 2 == 0 ? 1 : -1; };
  for (auto& x : points) x[0] += d * sign(x);
  auto body = body_of<P, Stress, ArtificialStress, Acceleration>(points, std::pow(spacing, dim));
  set(body, stress, [](auto const&) {
    Vec<symmetric3_size<dim>, double> sigma = Vec<symmetric3_size<dim>, double>::Zero();
    sigma.head(3).setConstant(1e4);
    return sigma;
  });
  for_each_particle<P>("R", body, ArtificialStressOf<>{{rho}, epsilon});
  sum_over_itself(body, 1.3 * spacing, StressDivergence<>{{rho}}, ArtificialStressDivergence<>{{rho}, spacing});
  auto const x = body.to_host(position), a = body.to_host(acceleration);
  double power = 0, count = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (deep_inside<dim>(x[i], 0.27)) power += sign(x[i]) * a[i][0], ++count;
  return power / count / d;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("artificial stress keeps momentum on disordered particles", "", Policies) {
  auto body = disordered<TestType, ArtificialStress>();
  for_each_particle<TestType>("R", body, ArtificialStressOf<DensityOfParticle>{});
  sum_over_itself(body, 0.2, ArtificialStressDivergence<DensityOfParticle>{{}, 0.125});
  auto const balance = balance_of(body);
  CHECK(balance.force < ulps<TestType>(10) * balance.forces);
  CHECK(balance.forces > 10);
}

TEMPLATE_LIST_TEST_CASE("artificial stress answers to tension only, along its axes", "", DoublePolicies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto body = body_of<P, Stress, ArtificialStress>({Vec<dim, double>::Zero()}, 1);
  auto const R_of = [&](Mat<3, double> const& sigma) {
    body.fill(stress, packed<dim>(sigma));
    for_each_particle<P>("R", body, ArtificialStressOf<>{{2}, 0.4});
    return unpacked(body.to_host(artificial_stress)[0]);
  };
  Mat<3, double> sigma = -5 * Mat<3, double>::Identity();
  CHECK(R_of(sigma).norm() == 0);
  sigma(0, 0) = 3;
  Mat<3, double> exact = Mat<3, double>::Zero();
  exact(0, 0) = -0.4 * 3 / 4;
  CHECK((R_of(sigma) - exact).norm() < 1e-15);
  // Pure shear: tension along the diagonal.
  sigma.setZero();
  sigma(0, 1) = sigma(1, 0) = 1;
  exact.setZero();
  exact.template topLeftCorner<2, 2>().setConstant(-0.4 / 4 / 2);
  CHECK((R_of(sigma) - exact).norm() < 1e-15);
}

TEMPLATE_LIST_TEST_CASE("artificial stress slows the tensile instability", "", DoublePolicies) {
  double const without = growth<TestType>(0), with = growth<TestType>(0.3), more = growth<TestType>(0.6);
  WARN(TestType::dim << "D, growth of a zigzag under tension: " << without << ", epsilon 0.3 " << with << ", 0.6 "
                     << more << " 1/s^2");
  CHECK(without > 0);
  CHECK(with < without);
  CHECK(more < with);
}

}  // namespace scree::test::artificial_stress_tests
