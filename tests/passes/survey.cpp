// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/passes/survey.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <limits>

namespace scree::test::survey_tests {
using namespace fields;

struct Temperature : Scalar<"temperature", "K"> {};
inline constexpr Temperature temperature{};
struct Heat {
  double capacity;
  using reads = Fields<Temperature>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    return capacity * i[temperature];
  }
};

/// Heat with a bound.
struct BoundedHeat : Heat {
  double most;
};

namespace {

using Nothing = Fields<>;

/// Temperatures rise with the first coordinate.
template <class P>
auto warm_body() {
  auto body = body_of<P, Temperature, Velocity>(random_points<P::dim>(100, 0, 1, 1), 1);
  set(body, temperature, [](auto const& x) { return x[0]; });
  body.fill(velocity, Vec<P::dim, typename P::real>::Constant(typename P::real(-3)));
  return body;
}
template <class P>
void set_one(Particles<P, typename decltype(warm_body<P>())::fields>& body, std::size_t place, typename P::real value) {
  auto values = body.to_host(temperature);
  values[place] = value;
  body.from_host(temperature, values);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the largest values of several functions are those of owned particles", "", Policies) {
  using P = TestType;
  auto body = warm_body<P>();
  auto const x = body.to_host(position);
  double hottest = 0;
  for (std::size_t i = 0; i < 60; ++i) hottest = std::max(hottest, double(x[i][0]));
  body.resize(60, 40);
  auto const found = survey(body, Nothing{}, Heat{1}, Magnitude<Velocity>{}, Heat{4}, Magnitude<Temperature>{});
  CHECK(found.largest[0].value == hottest);
  CHECK(std::abs(found.largest[1].value - 3 * std::sqrt(double(P::dim))) < ulps<P>(16));
  CHECK(found.largest[2].value == 4 * hottest);
  CHECK(found.largest[3].value == hottest);
  CHECK(found.first_not_finite == survey(body, Nothing{}).first_not_finite);
}

TEMPLATE_LIST_TEST_CASE("the largest value of no particles is zero", "", Policies) {
  auto const body = body_of<TestType, Temperature>({}, 1);
  CHECK(survey(body, Fields<Temperature>{}, Heat{1}).largest[0].value == 0);
}

TEMPLATE_LIST_TEST_CASE("particles beyond a bound are counted, and the worst one is found", "", Policies) {
  using P = TestType;
  auto body = warm_body<P>();
  set_one<P>(body, 8, 3);
  auto const t = body.to_host(temperature);
  auto const hot = double(std::count_if(t.begin(), t.end(), [](auto value) { return value > 0.5; }));
  auto const found = survey(body, Nothing{}, BoundedHeat{{1}, 0.5}, Magnitude<Velocity>{}, BoundedHeat{{2}, 5.5},
                            BoundedHeat{{1}, 3}, BoundedHeat{{0}, 0});
  CHECK(found.largest[0].beyond == hot);
  CHECK(found.largest[0].particle == 8);
  CHECK(found.largest[1].beyond == 0);
  CHECK(found.largest[2].beyond == 1);
  CHECK(found.largest[2].value == 6);
  CHECK(found.largest[3].beyond == 0);
  CHECK(found.largest[4].particle == 0);  // the first of all
  set_one<P>(body, 71, std::numeric_limits<typename P::real>::quiet_NaN());
  auto const not_a_number = survey(body, Nothing{}, BoundedHeat{{1}, 1e30});
  CHECK(not_a_number.largest[0].beyond == 1);
  CHECK(not_a_number.largest[0].particle == 71);
}

// A time step must notice a NaN: survey() feeds its limits.
TEMPLATE_LIST_TEST_CASE("a value that is not a number is not passed over", "", Policies) {
  using P = TestType;
  for (std::size_t const place : {0, 50, 99}) {
    auto body = warm_body<P>();
    set_one<P>(body, place, std::numeric_limits<typename P::real>::quiet_NaN());
    auto const found = survey(body, Fields<Velocity, Temperature>{}, Heat{1}, Magnitude<Velocity>{});
    CHECK(found.largest[0].value == std::numeric_limits<double>::infinity());
    CHECK(found.largest[1].value < 10);
    CHECK(found.first_not_finite == static_cast<int>(place));
    CHECK(survey(body, Fields<Velocity>{}, Heat{1}).first_not_finite > 100);
  }
}

TEMPLATE_LIST_TEST_CASE("the first of several particles that are not finite is found", "", Policies) {
  using P = TestType;
  auto body = warm_body<P>();
  for (std::size_t const place : {71, 12, 40})
    set_one<P>(body, place, std::numeric_limits<typename P::real>::infinity());
  CHECK(survey(body, Fields<Temperature>{}).first_not_finite == 12);
}

}  // namespace scree::test::survey_tests
