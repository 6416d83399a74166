// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/volume_control.hpp>
#include <scree/terms/velocity_gradient.hpp>

#include <terms/mechanics.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::test::volume_control_tests {
using namespace fields;
namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using Solid = Policy<3, float, Kokkos::DefaultHostExecutionSpace>;
using Some = std::tuple<OnHost, Solid>;

template <class P>
auto with_phi() {
  auto body = disordered<P, NumberDensity, Asymmetry, VelocityGradient>();
  sum_over_itself(body, 0.19, NumberDensitySum{}, VelocityGradientSum{});
  return body;
}

}  // namespace

TEST_CASE("a particle that is alone is not compact") {
  using std::numbers::pi;
  double const dr = 0.1;
  auto body = body_of<OnHost, NumberDensity, Asymmetry>({{0.5, 0.5}, {5, 5}, {5.1, 5}}, sq(dr));
  sum_over_itself(body, 1.5 * dr, NumberDensitySum{});
  auto const phi = body.to_host(number_density);
  auto const towards = body.to_host(asymmetry);
  CHECK(towards[0].norm() == 0);
  double const own = 7 / (4 * pi * sq(1.5));  // V W(0) = sigma (dr/h)^2 = 0.2476
  CHECK(std::abs(compactness(phi[0], 0.0, 7 / (3 * pi)) - own) < 1e-15);
  CHECK(compactness(phi[1], towards[1].norm(), 7 / (3 * pi)) < 0.8);  // a pair
  CHECK(towards[1][0] > 0);
  CHECK(towards[2][0] < 0);
}

TEMPLATE_LIST_TEST_CASE("number density and asymmetry are sums over all particles, the particle itself too", "", Some) {
  using P = TestType;
  using X = Vec<P::dim, double>;
  auto const body = with_phi<P>();
  KernelFunction<WendlandC2, P::dim, double> const W(0.19);
  auto const x = body.to_host(position), towards = body.to_host(asymmetry);
  auto const V = body.to_host(volume), phi = body.to_host(number_density);
  double error = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double sum = 0;
    X gradient = X::Zero();
    for (std::size_t j = 0; j < x.size(); ++j) {
      X const d = (x[j] - x[i]).template cast<double>();
      double const r = d.norm();
      if (r >= W.radius()) continue;
      sum += double(V[j]) * W.value(r);
      gradient -= double(V[j]) * W.h() * W.slope_over_distance(r) * d;  // towards j
    }
    error = std::max({error, std::abs(double(phi[i]) - sum), (towards[i].template cast<double>() - gradient).norm()});
  }
  CHECK(error < ulps<P>(50));
}

TEST_CASE("the number density falls at the rate of the trace of the plain velocity gradient") {
  auto const now = with_phi<OnHost>();
  auto const u = now.to_host(velocity);
  double const step = 1e-5;  // s, over which the fastest particle moves by 5e-5 h: differences are exact to 1e-8
  auto const moved = [&](double time) {
    auto body = with_phi<OnHost>();
    auto x = body.to_host(position);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += time * u[i];
    body.from_host(position, x);
    sum_over_itself(body, 0.19, NumberDensitySum{}, VelocityGradientSum{});
    return body.to_host(number_density);
  };
  auto const before = moved(-step), after = moved(step);
  auto const L = now.to_host(velocity_gradient);
  double error = 0, largest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    double const rate = (after[i] - before[i]) / (2 * step);
    error = std::max(error, std::abs(rate + L[i].trace()));
    largest = std::max(largest, std::abs(rate));
  }
  INFO("error " << error << ", largest rate " << largest);
  CHECK(largest > 1);
  CHECK(error < 1e-7 * largest);
}

}  // namespace scree::test::volume_control_tests
