// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sample_terms.hpp"

#include <support/bodies.hpp>

#include <scree/pairs/for_each_particle.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::for_each_particle_tests {
using namespace fields;

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
  auto const all = values_of(body[charge]);
  for (std::size_t ghost = 70; ghost < 100; ++ghost) CHECK(all[ghost] == -1);
}

}  // namespace scree::test::for_each_particle_tests
