// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sample_terms.hpp"

#include <support/bodies.hpp>

#include <scree/pairs/for_each_particle.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test {

struct Warm {
  double by;
  using reads = Fields<Position, Temperature>;
  using writes = Fields<Temperature, Charge>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[temperature] = i[temperature] + by * i[position][0];
    out[charge] = 2 * i[temperature];
  }
};
struct Hottest {
  using reads = Fields<Temperature>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    return i[temperature];
  }
};

TEMPLATE_LIST_TEST_CASE("a point function sees the old values and writes all owned particles, no ghosts", "",
                        Policies) {
  using P = TestType;
  auto body = body_of<P, Temperature, Charge>(random_points<P::dim>(100, 0, 1, 1), 1);
  body.resize(70, 30);
  body.fill(temperature, 5);
  body.fill(charge, -1);
  for_each_particle<P>("scree::test::warm", body, Warm{4});
  CHECK(largest_error(body, temperature, 1, [](auto const& x) { return 5 + 4 * x[0]; }) < ulps<P>(16));
  CHECK(largest_error(body, charge, 1, [](auto const&) { return 10; }) == 0);
  auto const all = to_host(body[charge]);
  for (std::size_t ghost = 70; ghost < 100; ++ghost) CHECK(all[ghost] == -1);
}

TEMPLATE_LIST_TEST_CASE("the largest value is that of owned particles", "", Policies) {
  using P = TestType;
  auto body = body_of<P, Temperature>(random_points<P::dim>(100, 0, 1, 1), 1);
  set(body, temperature, [](auto const& x) { return x[0]; });
  double expected = 0;
  auto const x = body.to_host(position);
  for (int i = 0; i < 60; ++i) expected = std::max(expected, double(x[static_cast<std::size_t>(i)][0]));
  body.resize(60, 40);
  CHECK(largest<P>("scree::test::hottest", body, Hottest{}) == expected);
}

TEMPLATE_LIST_TEST_CASE("the largest value of no particles is zero", "", Policies) {
  auto const body = body_of<TestType, Temperature>({}, 1);
  CHECK(largest<TestType>("scree::test::hottest", body, Hottest{}) == 0);
}

// A time step must notice it: largest() feeds its limits.
TEMPLATE_LIST_TEST_CASE("a value that is not a number is not passed over", "", Policies) {
  using P = TestType;
  for (std::size_t const place : {0, 50, 99}) {
    auto body = body_of<P, Temperature>(random_points<P::dim>(100, 0, 1, 1), 1);
    std::vector<typename P::real> values(100, 1);
    values[place] = std::numeric_limits<typename P::real>::quiet_NaN();
    body.from_host(temperature, values);
    CHECK_FALSE(std::isfinite(largest<P>("scree::test::hottest", body, Hottest{})));
  }
}

}  // namespace scree::test
