// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/plates.hpp>

#include "walls.hpp"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

// Forces on sand next to plates are in tests/verification/thin_plate.cpp.
namespace scree::test::plates_tests {
using namespace fields;
namespace {

/// The values of a wall that a bed sees which moves under its own weight; all of the wall is a plate, or none of it.
template <class Q, class Walls>
auto seen([[maybe_unused]] bool plate) {
  auto solver = walled_bed<Q, Walls>(Rotation{.rate = 3});
  using Real = typename Q::real;
  set_geostatic(solver);
  solver.set(velocity, [](auto const& x) { return (x * Real(0.3)).eval(); });
  if constexpr (std::is_same_v<Walls, PlateWalls>)
    solver.template set<Wall>(on_plate, [&](auto const&) { return Real(plate); });
  return seen_of_wall(solver);
}
template <class Q, class A, class B>
bool same(A const& a, B const& b) {
  bool all = a.size() == b.size() && !a.empty();
  for (std::size_t k = 0; all && k < a.size(); ++k)
    all = (a[k].u - b[k].u).norm() < ulps<Q>(10) && (a[k].sigma - b[k].sigma).norm() < ulps<Q>(10) * 1e4;
  return all;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a plate is a mirror, and the rest of a wall with plates extrapolates", "", Policies) {
  using Q = TestType;
  auto const mirror = seen<Q, MirrorWalls>(false);
  auto const mean = seen<Q, AdamiWalls>(false);
  CHECK(same<Q>(seen<Q, PlateWalls>(true), mirror));
  CHECK(same<Q>(seen<Q, PlateWalls>(false), mean));
  CHECK_FALSE(same<Q>(mirror, mean));
}

}  // namespace scree::test::plates_tests
