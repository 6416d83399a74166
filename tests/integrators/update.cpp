// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/update.hpp>

#include <scree/integrators/midpoint.hpp>
#include <scree/pairs/for_each_particle.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::update_tests {
using namespace fields;

struct OwnRate : Vector<"own rate", "m/s"> {};
inline constexpr OwnRate own_rate{};

namespace {

using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using V = Vec<2, double>;

auto moving() {
  auto body = body_of<P, Velocity, Acceleration, OwnRate>({V(1, 2)}, 1);
  body.fill(velocity, V(3, 0));
  body.fill(acceleration, V(4, 8));
  body.fill(own_rate, V(16, 0));
  return body;
}
template <class Evolved>
V position_after(Evolved evolved) {
  auto const body = moving();
  for_each_particle<P>("update", body, staggered_update<P>(evolved, 0.5));
  return body.to_host(position)[0];
}

}  // namespace

TEST_CASE("an update takes fields in the order of the list") {
  CHECK(position_after(Fields<Velocity, Position>{}) == V(1 + 0.5 * 5, 2 + 0.5 * 4));
  CHECK(position_after(Fields<Position, Velocity>{}) == V(1 + 0.5 * 3, 2));
  CHECK(position_after(Fields<Position>{}) == V(1 + 0.5 * 3, 2));
}

TEST_CASE("a list may give a field another rate") {
  using Moves = Evolves<Position, OwnRate>;
  STATIC_CHECK(Field<Moves>);
  CHECK(position_after(Fields<Velocity, Moves>{}) == V(1 + 0.5 * 16, 2));
  STATIC_CHECK(std::is_same_v<evolved_fields<Fields<Velocity, Moves>>, Fields<Velocity, Position>>);
  STATIC_CHECK(std::is_same_v<rates_of_evolved<Fields<Velocity, Moves>>, Fields<Acceleration, OwnRate>>);
  STATIC_CHECK(std::is_same_v<Midpoint::fields<Fields<Moves>>, Fields<Position, OwnRate, Previous<Position>>>);
}

}  // namespace scree::test::update_tests
