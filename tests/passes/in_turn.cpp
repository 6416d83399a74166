// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../pairs/sample_terms.hpp"

#include <support/bodies.hpp>

#include <scree/pairs/for_each_particle.hpp>
#include <scree/passes/in_turn.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::in_turn_tests {
using namespace fields;

/// T = 10 x.
struct SetTemperature {
  using reads = Fields<Position>;
  using writes = Fields<Temperature>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[temperature] = 10 * i[position][0];
  }
};
/// Q = 1 + T, T = 2 T, with a temperature that must not change during the function.
struct ChargeByTemperature {
  using reads = Fields<Temperature>;
  using writes = Fields<Temperature, Charge>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[temperature] = 2 * i[temperature];
    out[charge] = 1 + i[temperature];
  }
};
/// Q = Q + y.
struct AddHeight {
  using reads = Fields<Position, Charge>;
  using writes = Fields<Charge>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[charge] = i[charge] + i[position][1];
  }
};

TEMPLATE_LIST_TEST_CASE("functions in turn do in one sweep what they do in several", "", Policies) {
  using P = TestType;
  auto body = body_of<P, Temperature, Charge>(random_points<P::dim>(50, 0, 1, 1), 1);
  body.fill(temperature, -1);
  body.fill(charge, -1);
  auto const all = in_turn<P>(SetTemperature{}, ChargeByTemperature{}, AddHeight{});
  // Fields that an earlier function writes are not loaded.
  STATIC_CHECK(std::is_same_v<reads_of<std::remove_const_t<decltype(all)>>, Fields<Position>>);
  for_each_particle<P>("scree::test::in_turn", body, all);
  CHECK(largest_error(body, temperature, 20, [](auto const& x) { return 20 * x[0]; }) < ulps<P>(4));
  CHECK(largest_error(body, charge, 12, [](auto const& x) { return 1 + 10 * x[0] + x[1]; }) < ulps<P>(4));
}

TEMPLATE_LIST_TEST_CASE("two bodies in one sweep each have their own function", "", Policies) {
  using P = TestType;
  auto one = body_of<P, Temperature>(random_points<P::dim>(70, 0, 1, 1), 1);
  auto other = body_of<P, Charge>(random_points<P::dim>(30, 0, 1, 2), 1), none = body_of<P, Charge>({}, 1);
  other.fill(charge, 4);
  for_each_particle_of_two<P>("scree::test::two", one, SetTemperature{}, other, AddHeight{});
  CHECK(largest_error(one, temperature, 10, [](auto const& x) { return 10 * x[0]; }) < ulps<P>(4));
  CHECK(largest_error(other, charge, 5, [](auto const& x) { return 4 + x[1]; }) < ulps<P>(4));
  one.fill(temperature, 0);
  for_each_particle_of_two<P>("scree::test::two", one, SetTemperature{}, none, AddHeight{});
  CHECK(largest_error(one, temperature, 10, [](auto const& x) { return 10 * x[0]; }) < ulps<P>(4));
}

}  // namespace scree::test::in_turn_tests
