// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/residual_viscosity.hpp>

#include "mechanics.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <random>

namespace scree::test::residual_viscosity_tests {
using namespace fields;
namespace {

double const spacing = 1.0 / 16;  // m

/// Stores the strain rate as Granular does.
struct StoreStrainRate {
  using reads = Fields<>;
  using writes = Fields<StrainRate>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    auto const L = corrected_gradient(total[velocity_gradient], total[first_moment]);
    out[strain_rate] = trusted_strain_rate(L, total[first_moment]);
  }
};
template <class Body>
void add_viscosity(Body& body, double h) {
  sum_over_itself_then(body, h, StoreStrainRate{}, VelocityGradientSum{}, FirstMomentSum{});
  sum_over_itself(body, h, ResidualArtificialViscosity<DensityOfParticle>{{}, 0.7});
}
/// The accelerations of particles whose neighbours have neighbours on all sides.
template <class Body>
auto accelerations_inside(Body const& body) {
  auto const x = body.to_host(position), a = body.to_host(acceleration);
  std::vector<value_t<typename Body::policy, Acceleration>> inside;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (deep_inside(x[i], 6.5 * spacing)) inside.push_back(a[i]);
  return inside;
}
/// The accelerations inside by the residual viscosity, and by the plain one.
template <class Body>
auto both_viscosities(Body& body) {
  add_viscosity(body, 1.5 * spacing);
  auto const residual = accelerations_inside(body);
  sum_over_itself(body, 1.5 * spacing, ArtificialViscosity<DensityOfParticle>{{}, 0.7});
  return std::pair(residual, accelerations_inside(body));
}
/// A unit block with the disorder of lattice().
template <class P>
auto block(double jittered) {
  auto body = body_of<P, Density, Velocity, StrainRate, Acceleration>(lattice<P::dim>(spacing, jittered),
                                                                      std::pow(spacing, P::dim));
  set(body, density, [](auto const&) { return 1000.0; });
  return body;
}
double unexplained(double approach, double by_i, double by_j) {
  return detail::unexplained<double>(approach, by_i, by_j);
}

}  // namespace

TEST_CASE("what two predictions leave of an approach is between nothing and all of it") {
  CHECK(unexplained(-1, -1, -1) == 0);
  CHECK(unexplained(-1, -2, -3) == 0);
  CHECK(unexplained(-1, 0, -1) == -1);
  CHECK(unexplained(-1, 1, -1) == -1);
  CHECK(unexplained(-1, 1, 1) == -1);
  CHECK(unexplained(-1, -0.5, -0.5) == -0.5);
  CHECK(std::abs(unexplained(-1, -1, -0.1) + 1 - 2 * 0.1 / 1.1) < 1e-15);  // the mean of both would leave 0.45
  CHECK(unexplained(0, -1, -1) == 0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  long wrong = 0;
  for (int k = 0; k < 1'000'000; ++k) {
    double const approach = std::min(0.0, uniform(random)), a = uniform(random), b = uniform(random);
    double const rest = unexplained(approach, a, b);
    wrong += !(rest <= 0 && rest >= approach && rest == unexplained(approach, b, a));
  }
  CHECK(wrong == 0);
}

TEMPLATE_LIST_TEST_CASE("the residual viscosity keeps momentum and takes energy from disordered particles", "",
                        Policies) {
  auto body = disordered<TestType, StrainRate>();
  for (unsigned seed : {10u, 11u, 12u}) {
    set_random(body, velocity, seed, random_entries<TestType::dim>(1));
    add_viscosity(body, 0.2);
    auto const balance = balance_of(body);
    CHECK(balance.force < ulps<TestType>(10) * balance.forces);
    CHECK(balance.power < -0.1 * balance.forces);
  }
}

TEMPLATE_LIST_TEST_CASE("a linear velocity field feels no residual viscosity among disordered particles", "",
                        DoublePolicies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto body = block<P>(0.1);
  Mat<dim, double> L = Mat<dim, double>::Constant(0.7);
  L(0, dim - 1) = 5, L(0, 0) = -2;  // shear, spin and compression
  set(body, velocity, [&](auto const& x) { return (L * x).eval(); });
  auto const [residual, plain] = both_viscosities(body);
  REQUIRE(plain.size() >= 8);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    CHECK(plain[k].norm() > 1e-3);
    CHECK(residual[k].norm() < 1e-13);
  }
}

TEMPLATE_LIST_TEST_CASE("rows of alternating velocity feel all of the residual viscosity", "", DoublePolicies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto body = block<P>(0);
  set(body, velocity, [](auto const& x) {
    return (Vec<dim, double>::Unit(0) * (std::lround(x[dim - 1] / spacing - 0.5) % 2 == 0 ? 1.0 : -1.0)).eval();
  });
  auto const [residual, plain] = both_viscosities(body);
  REQUIRE(plain.size() >= 8);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    CHECK(plain[k].norm() > 0.1);
    CHECK((residual[k] - plain[k]).norm() < 1e-13 * plain[k].norm());
  }
}

TEMPLATE_LIST_TEST_CASE("two single particles that approach feel all of the residual viscosity", "", DoublePolicies) {
  using P = TestType;
  auto const unit = Vec<P::dim, double>::Unit(0);
  auto pair =
      body_of<P, Density, Velocity, StrainRate, Acceleration>({0 * unit, spacing * unit}, std::pow(spacing, P::dim));
  set(pair, density, [](auto const&) { return 1000.0; });
  set(pair, velocity, [&](auto const& x) { return (unit * (x[0] < 0.05 ? 1 : 0)).eval(); });
  add_viscosity(pair, 1.5 * spacing);
  auto const residual = pair.to_host(acceleration);
  sum_over_itself(pair, 1.5 * spacing, ArtificialViscosity<DensityOfParticle>{{}, 0.7});
  CHECK(residual[0].norm() > 0);
  CHECK(residual[0] == pair.to_host(acceleration)[0]);
}

TEST_CASE("the strain rate is trusted where neighbours fill at least the support at a plane surface") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto body = block<P>(0);
  set(body, velocity, [](auto const& x) { return Vec<2, double>(2 * x[1], 0); });
  sum_over_itself_then(body, 1.5 * spacing, StoreStrainRate{}, VelocityGradientSum{}, FirstMomentSum{});
  auto const x = body.to_host(position);
  auto const D = body.to_host(strain_rate);
  for (std::size_t i = 0; i < x.size(); ++i) {
    bool const corner = (x[i].array() - 0.5).abs().minCoeff() > 0.4;
    CAPTURE(x[i][0], x[i][1]);
    if (!corner) CHECK(std::abs(D[i][2] - std::sqrt(2.0)) < 1e-13);  // the off-diagonal entry, 1, times sqrt(2)
  }
}

}  // namespace scree::test::residual_viscosity_tests
