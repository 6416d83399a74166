// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/gradient.hpp>

#include <support/bodies.hpp>
#include <support/lattice_sums.hpp>

#include <scree/segregation/flux.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::gradient_tests {
using namespace fields;

struct FluxField : Scalar<"segregation flux", "m/s"> {};
inline constexpr FluxField flux_field{};

namespace {

using C = Concentration;

template <class P, class Function>
auto body_with(double spacing, double jittered, Function const& f) {
  auto body = body_of<P, C, FluxField, Gradient<C>, Gradient<FluxField>>(lattice<P::dim>(spacing, jittered),
                                                                         std::pow(spacing, P::dim));
  set(body, concentration, f);
  return body;
}

template <int Dim>
Vec<Dim, double> slope() {
  Vec<Dim, double> result = Vec<Dim, double>::Constant(0.7);
  result[0] = -1.2;
  return result;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the plain gradient of a constant is zero to the last bit, also at an edge", "", Policies) {
  auto body = body_with<TestType>(0.1, 0.2, [](auto const&) { return 0.3; });
  sum_over_itself(body, 0.15, PlainGradient<C>{});
  auto const zero = [](auto const& x) { return (0 * x).eval(); };
  CHECK(largest_error(body, gradient<C>, 1, zero) == 0);
}

TEMPLATE_LIST_TEST_CASE("the plain gradient of a linear field is its slope times the first moment of the lattice", "",
                        Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  double const spacing = 0.1, h = 1.5 * spacing;
  auto body = body_with<P>(spacing, 0, [](auto const& x) { return 0.2 + slope<dim>().dot(x); });
  sum_over_itself(body, h, PlainGradient<C>{});
  // sum V (b . (x_j - x_i)) gradW = -b sum V x dW/dx on a lattice: 0.99740 b in 2D.
  double const moment = -LatticeSums<dim>(1.5).moment;
  auto const exact = [&](auto const&) { return (moment * slope<dim>()).eval(); };
  auto const inside = [&](auto const& x) { return deep_inside<dim>(x, 2 * h - 0.04); };
  CHECK(largest_error(body, gradient<C>, 1, exact, inside) < ulps<P>(400));
}

TEMPLATE_LIST_TEST_CASE("the plain gradient is of second order where the support is full", "", DoublePolicies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto const f = [](auto const& x) { return std::sin(2 * x[0] - x[1]) + 0.3 * std::cos(x[dim - 1]); };
  auto const error = [&](double spacing) {
    double const h = 1.5 * spacing;
    auto body = body_with<P>(spacing, 0, f);
    sum_over_itself(body, h, PlainGradient<C>{});
    // Relative to the first moment, which depends on h/spacing only.
    double const moment = -LatticeSums<dim>(1.5).moment;
    auto const exact = [&](auto const& x) {
      Vec<dim, double> result = Vec<dim, double>::Zero();
      result[0] = 2 * moment * std::cos(2 * x[0] - x[1]);
      result[1] = -moment * std::cos(2 * x[0] - x[1]);
      result[dim - 1] -= 0.3 * moment * std::sin(x[dim - 1]);
      return result;
    };
    return largest_error(body, gradient<C>, 1, exact, [](auto const& x) { return deep_inside<P::dim>(x, 0.33); });
  };
  double const order = std::log2(error(1.0 / 10) / error(1.0 / 20));
  INFO("order " << order);
  CHECK(order > 1.8);
}

namespace {
// RMSE of the derivative along z of F(C), C = 4 z (1 - z), where the support is full.
template <class P>
std::pair<double, double> errors_of_both_forms(double spacing, double jittered) {
  SegregationFlux const F{.amplitude = 1.33, .asymmetry = 0.89};
  constexpr int z = P::dim - 1;
  double const h = 1.5 * spacing;
  auto body = body_with<P>(spacing, jittered, [](auto const& x) { return 4 * x[z] * (1 - x[z]); });
  set(body, flux_field, [&](auto const& x) { return F.value(4 * x[z] * (1 - x[z])); });
  sum_over_itself(body, h, PlainGradient<C>{}, PlainGradient<FluxField>{});
  auto const x = body.to_host(position);
  auto const grad_C = body.to_host(gradient<C>);
  auto const grad_F = body.to_host(gradient<FluxField>);
  double indirect = 0, direct = 0, count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!deep_inside<P::dim>(x[i].template cast<double>(), 2 * h)) continue;
    double const at = x[i][z], concentration_here = 4 * at * (1 - at),
                 exact = F.slope(concentration_here) * (4 - 8 * at);
    indirect += sq(F.slope(concentration_here) * grad_C[i][z] - exact);
    direct += sq(grad_F[i][z] - exact);
    ++count;
  }
  return {std::sqrt(indirect / count), std::sqrt(direct / count)};
}
}  // namespace

// Appendix A of Zhu et al. (2024), V = 1, A = 1.33, kappa = 0.89.
TEMPLATE_LIST_TEST_CASE("the indirect form F'(C) grad C beats the direct form grad F(C)", "", DoublePolicies) {
  using P = TestType;
  for (double const spacing : {0.1, 0.05, 0.025}) {
    if (P::dim == 3 && spacing < 0.05) continue;
    for (double const jittered : {0.0, 0.1}) {
      if (spacing > 0.05 && P::dim == 3 && jittered > 0) continue;  // 6^3 particles are left: chance decides
      auto const [indirect, direct] = errors_of_both_forms<P>(spacing, jittered);
      WARN(P::dim << "D, dr = " << spacing << ", jitter " << jittered << " dr: RMSE indirect " << indirect
                  << ", direct " << direct);
      CHECK(indirect < direct);
    }
  }
}

}  // namespace scree::test::gradient_tests
