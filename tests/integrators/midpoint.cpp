// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/midpoint.hpp>

#include <scree/pairs/for_each_particle.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::midpoint_tests {
using namespace fields;

/// C' = -C.
struct Decay {
  using reads = Fields<Concentration>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[concentration_rate] = -i[concentration];
  }
};
/// C' = 3 - 8 t.
struct LinearInTime {
  double time;
  using reads = Fields<>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[concentration_rate] = 3 - 8 * time;
  }
};
/// A rotation of one radian per second about the origin, in the plane of the first two axes.
struct Rotation {
  using reads = Fields<Position>;
  using writes = Fields<Velocity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto u = i[position];
    u.setZero();
    u[0] = -i[position][1];
    u[1] = i[position][0];
    out[velocity] = u;
  }
};

namespace {

template <class P, class Evolved, class Body, class Rate>
void advance(Body& body, Evolved evolved, int steps, double end, Rate const& rate_at) {
  double const dt = end / steps;
  for (int step = 0; step < steps; ++step) {
    for_each_particle<P>("scree::test::rate", body, rate_at(step * dt));
    for_each_particle<P>("predict", body, Midpoint::predictor<P>(evolved, dt));
    for_each_particle<P>("scree::test::rate", body, rate_at((step + 0.5) * dt));
    for_each_particle<P>("correct", body, Midpoint::corrector<P>(evolved, dt));
  }
}

template <class P>
double error_of_decay(int steps) {
  auto body = body_of<P, Concentration, ConcentrationRate, Previous<Concentration>, Remainder<Concentration>>(
      random_points<P::dim>(10, 0.5, 1, 1), 1);
  body.fill(concentration, 1);
  advance<P>(body, Fields<Concentration>{}, steps, 1.0, [](double) { return Decay{}; });
  return largest_error(body, concentration, 1, [](auto const&) { return std::exp(-1.0); });
}

template <class P>
double error_of_rotation(int steps) {
  auto const points = random_points<P::dim>(10, 0.5, 1, 1);
  auto body = body_of<P, Velocity, Previous<Position>>(points, 1);
  advance<P>(body, Fields<Position>{}, steps, 1.0, [](double) { return Rotation{}; });
  auto const x = body.to_host(position);
  double error = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    Vec<P::dim, double> exact = points[k];
    exact[0] = std::cos(1.0) * points[k][0] - std::sin(1.0) * points[k][1];
    exact[1] = std::sin(1.0) * points[k][0] + std::cos(1.0) * points[k][1];
    error = std::max(error, (x[k].template cast<double>() - exact).norm());
  }
  return error;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the midpoint scheme is of second order", "", DoublePolicies) {
  using P = TestType;
  double const decay = std::log2(error_of_decay<P>(40) / error_of_decay<P>(80));
  double const rotation = std::log2(error_of_rotation<P>(40) / error_of_rotation<P>(80));
  INFO("orders " << decay << " and " << rotation);
  // The leading error is that of exp(-1): (1 - dt + dt^2/2)^(1/dt) e = 1 + dt^2/6.
  CHECK(std::abs(decay - 2) < 0.05);
  CHECK(std::abs(rotation - 2) < 0.05);
  CHECK(std::abs(error_of_decay<P>(80) - std::exp(-1.0) / 6 / sq(80.0)) < 0.1 * error_of_decay<P>(80));
}

TEMPLATE_LIST_TEST_CASE("the midpoint scheme is exact for rates linear in time", "", Policies) {
  using P = TestType;
  auto body = body_of<P, Concentration, ConcentrationRate, Previous<Concentration>, Remainder<Concentration>>(
      random_points<P::dim>(5, 0, 1, 1), 1);
  body.fill(concentration, 2);
  advance<P>(body, Fields<Concentration>{}, 4, 1.0, [](double time) { return LinearInTime{time}; });
  // 2 + 3 - 4; all steps in binary fractions.
  CHECK(largest_error(body, concentration, 1, [](auto const&) { return 1; }) == 0);
}

TEMPLATE_LIST_TEST_CASE("prediction goes half a step and keeps the value of the step", "", Policies) {
  using P = TestType;
  auto body = body_of<P, Concentration, ConcentrationRate, Previous<Concentration>, Remainder<Concentration>>(
      random_points<P::dim>(5, 0, 1, 1), 1);
  body.fill(concentration, 2);
  body.fill(concentration_rate, 8);
  for_each_particle<P>("predict", body, Midpoint::predictor<P>(Fields<Concentration>{}, 0.25));
  CHECK(largest_error(body, concentration, 1, [](auto const&) { return 3; }) == 0);
  CHECK(largest_error(body, Previous<Concentration>{}, 1, [](auto const&) { return 2; }) == 0);
  body.fill(concentration_rate, 4);
  for_each_particle<P>("correct", body, Midpoint::corrector<P>(Fields<Concentration>{}, 0.25));
  CHECK(largest_error(body, concentration, 1, [](auto const&) { return 3; }) == 0);
}

TEST_CASE("the midpoint scheme needs the rates and previous values of what evolves") {
  STATIC_CHECK(
      std::is_same_v<
          Midpoint::fields<Fields<Concentration, Position>>,
          Fields<Concentration, Position, ConcentrationRate, Velocity, Previous<Concentration>, Previous<Position>>>);
}

}  // namespace scree::test::midpoint_tests
