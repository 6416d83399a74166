// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <drum/scaling.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <random>

namespace scree::test::drum_scaling_tests {
using Catch::Approx;

namespace {

std::vector<double> times_until(double end, int count) {
  std::vector<double> times;
  for (int k = 0; k <= count; ++k) times.push_back(end * k / count);
  return times;
}
std::vector<double> risen(std::vector<double> const& times, double last, double time) {
  std::vector<double> values;
  for (double t : times) values.push_back(last * (1 - std::exp(-t / time)));
  return values;
}

}  // namespace

TEST_CASE("the rise of the drum's segregation is found from its values, long before its end too") {
  for (double const time : {0.02, 0.7, 5.0, 20.0}) {
    auto const times = times_until(10, 200);
    auto const rise = drum::rise_of(times, risen(times, 0.6, time));
    CHECK(rise.last == Approx(0.6).epsilon(1e-4));
    CHECK(rise.time == Approx(time).epsilon(1e-4));
    CHECK(rise.error < 1e-4);
  }
}

TEST_CASE("the rise of the drum's segregation is that of the mean where values are noisy") {
  auto const times = times_until(10, 2000);
  auto values = risen(times, 0.6, 2);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.03);
  for (double& value : values) value += noise(random);
  auto const rise = drum::rise_of(times, values);
  CHECK(rise.last == Approx(0.6).epsilon(0.01));
  CHECK(rise.time == Approx(2).epsilon(0.03));
  CHECK(rise.error == Approx(0.05).epsilon(0.05));
}

TEST_CASE("values that are missing are left out of the rise of the drum's segregation") {
  double const missing = drum::detail::missing();
  auto const times = times_until(10, 200);
  auto values = risen(times, 0.6, 2);
  values[0] = values[17] = values[200] = missing;
  CHECK(drum::rise_of(times, values).time == Approx(2).epsilon(1e-4));
  CHECK(std::isnan(drum::rise_of({0, 1, 2}, {missing, 0.1, 0.2}).last));
  CHECK(std::isnan(drum::rise_of({0, 1, 2, 3}, {0, 0, 0, 0}).time));  // nothing segregates
  CHECK(std::isnan(drum::rise_of({}, {}).last));
}

TEST_CASE("the drum's Lambda and Pe are ratios of times in its layer") {
  drum::Options o;
  o.geometry = {.radius = 0.05, .fill_depth = 0.4, .rotation_speed = 10};
  o.material.d_small = 1e-3, o.material.d_large = 2e-3;
  double const bed_depth = 0.041, delta = 0.009;
  auto const s = drum::scaling(o, bed_depth, delta);
  double const L = std::sqrt(0.05 * 0.05 - 0.009 * 0.009);
  CHECK(s.half_surface == Approx(L));
  CHECK(s.epsilon == Approx(delta / L));
  CHECK(s.froude == Approx(std::pow(10 * std::numbers::pi / 30, 2) * 0.05 / 9.81));

  // Grains cross the length in L/u, the depth by segregation in delta/V and by diffusion in delta^2/D, all at any u.
  for (auto const closure : {drum::Closure::shear_rate, drum::Closure::schlick}) {
    o.segregation.closure = closure;
    bool const by_ratio = closure == drum::Closure::schlick;
    double const u = 0.37, rate = u / delta, d = 1.5e-3;
    double const V = by_ratio ? 0.26 * rate * 1e-3 * std::log(2) : 0.11 * rate * d;
    double const D = (by_ratio ? 0.042 : 0.0307) * rate * d * d;
    auto const found = drum::scaling(o, bed_depth, delta);
    CHECK(found.lambda == Approx((L / u) / (delta / V)));
    CHECK(found.peclet == Approx((delta * delta / D) / (L / u)));
    CHECK(found.lambda * found.peclet == Approx(V * delta / D));
  }
}

TEST_CASE("closures that are not in proportion to the shear rate have no Lambda and Pe of the drum") {
  drum::Options o;
  for (auto const closure : {drum::Closure::trewhela, drum::Closure::constant, drum::Closure::none}) {
    o.segregation.closure = closure;
    CHECK(std::isnan(drum::scaling(o, 0.03, 0.007).lambda));
    CHECK(std::isnan(drum::scaling(o, 0.03, 0.007).peclet));
    CHECK(drum::scaling(o, 0.03, 0.007).epsilon > 0.1);
  }
  o.segregation.closure = drum::Closure::shear_rate;
  CHECK(drum::scaling(o, 0.03, 0.007).peclet > 0);
  o.segregation.flux = drum::Flux::asymmetric;
  CHECK(std::isnan(drum::scaling(o, 0.03, 0.007).lambda));
}

}  // namespace scree::test::drum_scaling_tests
