// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/passes/limit.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::limit_tests {
using namespace fields;
namespace {

template <class P>
auto moving_body(double speed) {
  using vector = Vec<P::dim, typename P::real>;
  auto body = body_of<P, Velocity, Concentration>(random_points<P::dim>(50, 0, 1, 1), 1);
  std::vector<vector> u(50, vector::Zero());
  u[33][0] = typename P::real(-speed);
  body.from_host(velocity, u);
  body.fill(concentration, typename P::real(0.25));
  return body;
}
using Evolved = Fields<Position, Velocity>;
auto limits() {
  return std::tuple(limit("speed", Magnitude<Velocity>{}, [](double u) { return 1 / u; }), limit("constant", 0.75),
                    limit("mixture", Magnitude<Concentration>{}, [](double C) { return 8 * C; }).over(4));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("limits follow from the largest values, in their order", "", Policies) {
  auto const found = limits_of(WholeBody(moving_body<TestType>(2)), Evolved{}, limits(), 0);
  REQUIRE(found.size() == 3);
  CHECK(found[0].name == "speed");
  CHECK(found[0].step == 0.5);
  CHECK(found[0].change == 0.5);
  CHECK(found[1].name == "constant");
  CHECK(found[1].step == 0.75);
  CHECK(found[1].change == TimeStepLimit::never);
  // For one of four steps; the time scale of the state is unchanged.
  CHECK(found[2].name == "mixture");
  CHECK(found[2].step == 0.5);
  CHECK(found[2].change == 2);
}

TEST_CASE("limits over several steps multiply") {
  CHECK(limit("constant", 6).over(2).over(3).step == 1);
  CHECK(limit("speed", Magnitude<Velocity>{}, [](double u) { return u; }).over(2).over(3).steps == 6);
}

TEST_CASE("a physics may have no limits") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  CHECK(limits_of(WholeBody(moving_body<P>(2)), Evolved{}, std::tuple<>(), 0).empty());
}

TEMPLATE_LIST_TEST_CASE("what is not finite stops where limits are looked at", "", Policies) {
  using P = TestType;
  auto body = moving_body<P>(std::numeric_limits<double>::quiet_NaN());
  CHECK_THROWS_WITH(limits_of(WholeBody(body), Evolved{}, limits(), 7),
                    Catch::Matchers::ContainsSubstring("particle 33 is not finite after step 7 at (") &&
                        Catch::Matchers::ContainsSubstring(": velocity = ("));
  // Fields that do not evolve may have any value, but give no limit.
  CHECK(limits_of(WholeBody(body), Fields<Position>{}, limits(), 7)[0].step == 0);
}

}  // namespace scree::test::limit_tests
