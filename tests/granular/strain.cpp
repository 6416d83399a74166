// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/flow_consistency.hpp>
#include <scree/granular/strain.hpp>
#include <scree/laws/mu_of_i.hpp>

#include <support/bodies.hpp>

#include <Eigen/LU>
#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::test::strain_tests {
using namespace fields;
namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using Solid = Policy<3, float, Kokkos::DefaultHostExecutionSpace>;
using Some = std::tuple<OnHost, Solid>;

Elastic const elastic{.young = 1e5, .poisson = 0.3, .rest_density = 1500};
double const K = 1e5 / (3 * 0.4), phi_0 = 0.98, at_surface = 0.743, h = 0.19;

/// One point by hand: sigma, the plain velocity gradient, the moment that corrects it, and the sums over its
/// neighbours.
struct Point {
  Vec<4, double> sigma{-200, -300, -250, 40};
  Mat<2, double> L = (Mat<2, double>() << 0.1, 5, 0.2, -0.3).finished();
  Mat<2, double> moment = -Mat<2, double>::Identity();
  double phi = 0.97;
  Vec<2, double> towards = Vec<2, double>::Zero();
  double pressure() const { return -(sigma[0] + sigma[1] + sigma[2]) / 3; }
};
struct Rates {
  Vec<4, double> sigma;
  double gamma_dot;
};
template <class Strain = PlainStrain, class Volume>
Rates rates_of(Point const& point, Volume const& control, double step = 0) {
  using Functor = StrainRates<Elastic, Volume, Strain>;
  Record<OnHost, Fields<Stress>> const i{{point.sigma}};
  Record<OnHost, Fields<VelocityGradient, FirstMoment, NumberDensity, Asymmetry>> const total{
      {point.L}, {point.moment}, {point.phi}, {point.towards}};
  Results<OnHost, writes_of<Functor>> out;
  Functor{elastic, control, phi_0, at_surface, h, step}(i, total, out);
  if constexpr (Volume::active) CHECK(out[number_density] == point.phi);
  return {out[stress_rate], out[shear_rate]};
}
/// The change of dp/dt by volume control; the rest of the rate must be that without it.
double change_of(Point const& point, VolumeConsistency const& control) {
  auto const with = rates_of(point, control), without = rates_of(point, NoVolumeControl{});
  CHECK(with.gamma_dot == without.gamma_dot);
  Vec<4, double> const change = with.sigma - without.sigma;
  double const size = 1e-12 * with.sigma.norm();
  CHECK(std::abs(change[0] - change[1]) <= size);
  CHECK(std::abs(change[0] - change[2]) <= size);
  CHECK(change[3] == 0);
  return -change[0];
}
bool close(double a, double b) { return std::abs(a - b) < 1e-12 * std::abs(b); }

}  // namespace

// Per turn of N steps sqrt(J2) grows by the factor 1 + 8 pi^2/N without the step, and with it by N theta^4/8 with
// theta = 4 pi/N, as under the midpoint scheme (docs/theory/laws.md).
TEST_CASE("over a known step the rate turns a stress by a rotation and keeps its invariants") {
  int const N = 1000, turns = 10;
  double const dt = 1e-3;  // s
  Point start;
  start.L << 0, -2 * std::numbers::pi / (N * dt), 2 * std::numbers::pi / (N * dt), 0;
  auto const growth = [&](double step) {
    Point now = start;
    for (int k = 0; k < turns * N; ++k) now.sigma += dt * rates_of(now, NoVolumeControl{}, step).sigma;
    CHECK(std::abs(now.pressure() / start.pressure() - 1) < 1e-10);
    double const off = (now.sigma - start.sigma).norm() / start.sigma.norm();
    INFO(off << " off after " << turns << " turns");
    CHECK((step == 0 || off < 1e-3));
    auto const shear = [](Point const& at) { return equivalent_shear_stress(deviator_of(unpacked(at.sigma))); };
    return shear(now) / shear(start) - 1;
  };
  double const theta = 4 * std::numbers::pi / N;
  CHECK(growth(0) > 0.5);
  CHECK(std::abs(growth(dt) / (turns * N * std::pow(theta, 4) / 8) - 1) < 0.2);
}

TEST_CASE("without volume control the stress rate is that of the law for the plain velocity gradient") {
  Point point;
  point.moment *= 0.5;  // half of the support
  auto const rates = rates_of(point, NoVolumeControl{});
  auto const law = elastic.stress_rate(unpacked(point.sigma), in_three_dimensions(point.L), NoHistory{});
  CHECK((rates.sigma - packed<2>(law)).norm() == 0);
  // 2 e:e - 2 tr^2/3 = L11^2 2 + L22^2 2 + (L12 + L21)^2 - 2 (L11 + L22)^2/3 of twice the plain gradient.
  CHECK(close(rates.gamma_dot, 2 * std::sqrt(2 * 0.01 + 2 * 0.09 + sq(5.2) - 2 * sq(0.2) / 3)));
  STATIC_CHECK_FALSE(OneOf<NumberDensity, writes_of<StrainRates<Elastic, NoVolumeControl>>>);
}

TEST_CASE("the stress rate can be that of the law for the corrected velocity gradient") {
  Point point;
  point.moment << -0.5, 0.1, 0.1, -0.8;
  auto const rates = rates_of<CorrectedStrain>(point, NoVolumeControl{});
  Mat<2, double> const L = point.L * -point.moment.inverse();
  auto const law = elastic.stress_rate(unpacked(point.sigma), in_three_dimensions(L), NoHistory{});
  CHECK((rates.sigma - packed<2>(law)).norm() < 1e-12 * rates.sigma.norm());
  CHECK(close(rates.gamma_dot, shear_rate_of(L)));
  CHECK((rates.sigma - rates_of(point, NoVolumeControl{}).sigma).norm() > 0.1 * rates.sigma.norm());
}

TEST_CASE(
    "a rotation gives no stress rate to a stress-free particle with the objective gradient, on any side of a surface") {
  Point point;
  point.sigma.setZero();
  point.moment << -0.5, 0.1, 0.1, -0.8;
  Mat<2, double> spin;
  spin << 0, -3, 3, 0;
  point.L = spin * -point.moment;  // what the plain gradient finds
  CHECK(rates_of<ObjectiveStrain>(point, NoVolumeControl{}).sigma.norm() < 1e-12 * elastic.young);
  CHECK(rates_of(point, NoVolumeControl{}).sigma.norm() > 0.1 * elastic.young);
  point.L = 0.2 * point.moment * point.moment;  // a symmetric gradient has no rotation to leave out
  CHECK((rates_of<ObjectiveStrain>(point, NoVolumeControl{}).sigma - rates_of(point, NoVolumeControl{}).sigma).norm() <
        1e-12 * elastic.young);
}

struct Charge : Scalar<"charge", "C"> {};
inline constexpr Charge charge{};
/// A law that reads a field of the point and the shear rate where rates are computed.
struct Charged : Elastic {
  using reads = Fields<Charge, ShearRate>;
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    return point[charge] * Elastic::stress_rate(sigma, L, point) + point[shear_rate] * sigma;
  }
};

TEST_CASE("a law finds its fields where rates are computed, and the shear rate is the present one") {
  using Functor = StrainRates<Charged, NoVolumeControl>;
  STATIC_CHECK(std::is_same_v<reads_of<Functor>, Fields<Stress, Charge>>);
  Point const point;
  Record<OnHost, reads_of<Functor>> const i{{point.sigma}, {3}};
  Record<OnHost, Fields<VelocityGradient, FirstMoment>> const total{{point.L}, {point.moment}};
  Results<OnHost, writes_of<Functor>> out;
  Functor{{elastic}, {}, phi_0, at_surface}(i, total, out);
  auto const alone = rates_of(point, NoVolumeControl{});
  Vec<4, double> const expected = 3 * alone.sigma + alone.gamma_dot * point.sigma;
  CHECK((out[stress_rate] - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE("volume control changes the pressure at a rate of the shear rate and of what it lacks") {
  Point point;
  double const gamma_dot = rates_of(point, NoVolumeControl{}).gamma_dot;
  CHECK(gamma_dot > 5);
  for (double const beta : {1.0, 3.0})
    for (double const phi : {0.95, 1.02}) {
      INFO("beta " << beta << ", phi " << phi);
      point.phi = phi;
      double const lacking = phi - phi_0 - point.pressure() / K;  // -0.033, 0.037
      double const change = change_of(point, {.per_strain = beta});
      CHECK(close(change, beta * gamma_dot * K * lacking));
      CHECK((change > 0) == (phi > 1));  // material that is too dense gains pressure
    }
}

TEST_CASE("volume control is limited, and takes the place of what a surface cuts off") {
  Point point;
  double const gamma_dot = rates_of(point, NoVolumeControl{}).gamma_dot;
  point.phi = 0.2;
  CHECK(close(change_of(point, {}), -0.3 * gamma_dot * K));
  CHECK(close(change_of(point, {.largest_strain = 0.1}), -0.1 * gamma_dot * K));
  point.phi = 2;
  CHECK(close(change_of(point, {}), 0.3 * gamma_dot * K));
  point.phi = 0.7;
  point.towards = {0.3, -0.4};
  double const c = compactness(0.7, 0.5, at_surface);
  CHECK(c > 0.85);
  CHECK(close(change_of(point, {}), gamma_dot * K * (c - phi_0 - point.pressure() / K)));
}

TEST_CASE("volume control adds nothing where nothing is sheared") {
  Point point;
  point.phi = 0.5;
  point.L << 0, -3, 3, 0;  // rigid rotation
  CHECK(change_of(point, {}) == 0);
  point.L.setZero();
  CHECK(change_of(point, {}) == 0);
  // and nothing where pressure and spacing are consistent
  point.L << 0, 5, 0, 0;
  point.phi = phi_0 + point.pressure() / K;
  CHECK(std::abs(change_of(point, {})) < 1e-12 * K);
}

TEST_CASE("a control of flow is told the shear strain while sound passes h") {
  Point point;
  point.phi = 0.9;
  auto const without = rates_of(point, NoVolumeControl{});
  double const N = without.gamma_dot * h / elastic.sound_speed() * std::sqrt(K / point.pressure());
  auto const change = [&](FlowConsistency const& control) {
    return -(rates_of(point, control).sigma - without.sigma)[0];  // of dp/dt
  };
  double const full = change({.rest = 0, .flow = 0.9 * N});
  CHECK(close(full, -without.gamma_dot * K * (phi_0 - point.phi + point.pressure() / K)));
  CHECK(std::abs(change({.rest = 0.5 * N, .flow = 1.5 * N}) - full / 2) < 1e-9 * std::abs(full));
  CHECK(change({.rest = 1.1 * N, .flow = 2 * N}) == 0);
}

TEMPLATE_LIST_TEST_CASE("the shear rate is exact at a truncated support, the stress rate that of the plain gradient",
                        "", Some) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto points = lattice<dim>(0.125, 0.2, 5);
  std::erase_if(points, [](auto const& x) { return x[0] + 0.4 * x[dim - 1] > 1.1; });
  Mat<dim, double> L = 0.3 * Mat<dim, double>::Identity();
  L(0, dim - 1) = 1.7, L(1, 0) = -0.4;
  auto body = body_of<P, Velocity, VelocityGradient, Stress, StressRate, ShearRate, NumberDensity>(
      points, std::pow(0.125, dim));
  set(body, velocity, [&](auto const& x) { return (L * x).eval(); });
  sum_over_itself(body, 0.19, VelocityGradientSum{});
  StrainRates<Elastic, VolumeConsistency> const rates{elastic, {.per_strain = 0}, phi_0, at_surface};
  sum_over_itself_then(body, 0.19, rates, VelocityGradientSum{}, FirstMomentSum{}, NumberDensitySum{});

  double const exact = shear_rate_of(L);
  CHECK(largest_error(body, shear_rate, exact, [&](auto const&) { return exact; }) < ulps<P>(2e3));
  auto const plain = body.to_host(velocity_gradient);
  auto const found = body.to_host(stress_rate);
  double error = 0, lowest = exact;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    Mat<dim, double> const there = plain[i].template cast<double>();
    auto const law = packed<dim>(
        elastic.stress_rate(Mat<3, double>(Mat<3, double>::Zero()), in_three_dimensions(there), NoHistory{}));
    error = std::max(error, (found[i].template cast<double>() - law).norm());
    lowest = std::min(lowest, shear_rate_of(there));
  }
  CHECK(lowest < 0.7 * exact);  // of the plain gradient, at an edge
  CHECK(error < ulps<P>(200) * K * exact);
}

}  // namespace scree::test::strain_tests
