// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/pairs/for_each_particle.hpp>
#include <scree/segregation/constant_closure.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::constant_closure_tests {
using namespace fields;

TEMPLATE_LIST_TEST_CASE("a constant closure gives every particle its V and D", "", Policies) {
  using P = TestType;
  STATIC_CHECK(SegregationClosure<ConstantClosure, P>);
  auto body = body_of<P, SegregationVelocity, Diffusivity>(lattice<P::dim>(0.25), 1);
  for_each_particle<P>("closure", body, ConstantClosure{.velocity = 0.75, .diffusivity = 0.125});
  CHECK(largest_error(body, segregation_velocity, 1, [](auto const&) { return 0.75; }) == 0);
  CHECK(largest_error(body, diffusivity, 1, [](auto const&) { return 0.125; }) == 0);
}

}  // namespace scree::test::constant_closure_tests
