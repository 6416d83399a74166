// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/kernels/wendland_c2.hpp>
#include <scree/rigid/contact_terms.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace scree::test::contact_terms_tests {
using namespace fields;
namespace {

using P = Basis<3, double, WendlandC2, Kokkos::DefaultHostExecutionSpace>;
using X = Vec<3, double>;
using Particle = Record<P, detail::ContactLaw::reads>;
constexpr double dr = 0.02;

/// A particle of a body, with the outward normal of its surface times its flatness.
Particle particle(int owner, X const& outward, X const& velocity) {
  return {{owner}, {outward}, {velocity}, {Mat<3, double>::Zero()}};
}
auto touch_of(Particle const& i, Particle const& j, X const& x) {
  kernel_of<P> const kernel(1.5 * dr);
  return detail::ContactLaw{.spacing = dr, .stiffness = 1e5, .mean = 0.6, .swing = 0.4}(i, j,
                                                                                        Pair<P>(x, norm(x), kernel));
}

}  // namespace

TEST_CASE("pairs beyond the reach of contact would add nothing, and pairs within it do") {
  // The farthest pair: two faces, shifted by almost one spacing, with almost the largest gap that counts as near.
  X const up(0, 0, 1), fast(1, 2, -3);
  auto const farthest = touch_of(particle(0, up, fast), particle(1, -up, X::Zero()), dr * X(0.99, 0, -1.49));
  CHECK(farthest.nearness > 0);
  CHECK(farthest.nearness < 0.02);
  CHECK(touch_of(particle(0, up, fast), particle(1, -up, X::Zero()), dr * X(0.5, 0, -0.9)).force > 0);

  // Between the farthest distance of a pair that counts and the reach all pairs are evaluated, and add nothing.
  double const farthest_distance = std::hypot(1, detail::ContactLaw::near_below);
  REQUIRE(farthest_distance < detail::ContactLaw::reach);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> flat(0.85, 1), within(farthest_distance, detail::ContactLaw::reach);
  auto const direction = [&] { return X(normal(random), normal(random), normal(random)).normalized().eval(); };
  int facing_each_other = 0;
  double largest = 0;
  for (int k = 0; k < 20000; ++k) {
    X const along = direction();
    auto const touch = touch_of(particle(0, flat(random) * direction(), direction()),
                                particle(1, flat(random) * direction(), direction()), dr * within(random) * along);
    largest = std::max({largest, touch.nearness, touch.overlap, std::abs(touch.force)});
    facing_each_other += norm(touch.normal) > 0;
  }
  CHECK(largest == 0);
  CHECK(facing_each_other > 5000);
}

}  // namespace scree::test::contact_terms_tests
