// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/particles.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace scree::test::particles_tests {
using namespace fields;
namespace {
template <class P>
using Grains = Particles<P, Fields<Position, Mass, Identity>>;

std::vector<int> numbers(int count) {
  std::vector<int> result(static_cast<std::size_t>(count));
  std::iota(result.begin(), result.end(), 0);
  return result;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("particles are owned ones and ghosts", "", Policies) {
  Grains<TestType> grains(5);
  CHECK(grains.size() == 5);
  CHECK(grains.ghosts() == 0);
  grains.resize(4, 3);
  CHECK(grains.size() == 4);
  CHECK(grains.ghosts() == 3);
  CHECK(grains.extent() == 7);
  CHECK(grains[mass].size() == 7);
  CHECK(grains.to_host(mass).size() == 4);
}

TEMPLATE_LIST_TEST_CASE("new particles have zero everywhere", "", Policies) {
  Grains<TestType> const grains(6);
  for (auto const m : grains.to_host(mass)) CHECK(m == 0);
  for (auto const& x : grains.to_host(position)) CHECK(x.norm() == 0);
}

TEMPLATE_LIST_TEST_CASE("values of owned particles survive a change of size", "", Policies) {
  Grains<TestType> grains(100);
  grains.from_host(identity, numbers(100));
  for (int const size : {100, 150, 1000, 60}) {
    grains.resize(size, size / 2);
    auto const kept = grains.to_host(identity);
    int const common = std::min(size, 60);
    CHECK(std::equal(kept.begin(), kept.begin() + common, numbers(common).begin()));
  }
}

TEMPLATE_LIST_TEST_CASE("all fields of a particle go to its new place, and later growth keeps it", "", Policies) {
  using P = TestType;
  Grains<P> grains(100);
  grains.resize(100, 20);
  grains.from_host(identity, numbers(100));
  grains.from_host(position, cast<typename P::real>(random_points<P::dim>(100, -1, 1, 1)));
  auto points = grains.to_host(position);
  auto names = numbers(100);
  std::reverse(names.begin(), names.end());
  std::reverse(points.begin(), points.end());
  auto backwards = numbers(100);
  std::reverse(backwards.begin(), backwards.end());
  grains.reorder(array_of<P>(backwards));
  for (int const size : {100, 1000}) {
    grains.resize(size);
    auto const found = grains.to_host(identity);
    CHECK(std::equal(names.begin(), names.end(), found.begin()));
    auto const there = grains.to_host(position);
    CHECK(std::equal(points.begin(), points.end(), there.begin()));
  }
}

TEMPLATE_LIST_TEST_CASE("of many particles those of a rising list are kept, with zeros behind them", "", Policies) {
  using P = TestType;
  int const all = 5'000'000;
  Particles<P, Fields<Identity>> grains(all);
  grains.from_host(identity, numbers(all));
  std::vector<int> wanted;
  for (int k = 0; k < all; ++k)
    if (k % 3 != 1) wanted.push_back(k);
  grains.resize(all, 10);
  CHECK_THROWS_AS(grains.keep(array_of<P>(std::vector<int>{3, 3, 4})), std::invalid_argument);
  grains.keep(array_of<P>(wanted));
  CHECK(grains.ghosts() == 0);
  CHECK(grains.to_host(identity) == wanted);
  grains.resize(all);
  wanted.resize(std::size_t(all), 0);
  CHECK(grains.to_host(identity) == wanted);
}

TEMPLATE_LIST_TEST_CASE("values go to the device and back", "", Policies) {
  using P = TestType;
  Grains<P> grains(50);
  auto const points = cast<typename P::real>(random_points<P::dim>(50, -1, 1, 1));
  grains.from_host(position, points);
  CHECK(grains.to_host(position) == points);
  grains.resize(50, 10);
  grains.fill(mass, 3);  // ghosts too
  for (auto const m : values_of(grains[mass])) CHECK(m == 3);
}

TEMPLATE_LIST_TEST_CASE("a wrong number of values or of particles is refused", "", Policies) {
  Grains<TestType> grains(5);
  CHECK_THROWS_AS(grains.from_host(identity, numbers(6)), std::invalid_argument);
  CHECK_THROWS_AS(grains.from_host(identity, numbers(4)), std::invalid_argument);
  CHECK_THROWS_AS(grains.resize(-1), std::invalid_argument);
  CHECK_THROWS_AS(grains.resize(1, -1), std::invalid_argument);
  CHECK_THROWS_AS(grains.resize(2147483647, 1), std::invalid_argument);
  CHECK_THROWS_AS(grains.resize(5, 2147483647), std::invalid_argument);
  CHECK(grains.size() == 5);
}

TEMPLATE_LIST_TEST_CASE("columns are found by their field where the types of fields are not known", "", Policies) {
  using P = TestType;
  Particles<P, Fields<Position, Mass, Identity, Previous<Mass>>> grains(4);
  grains.from_host(mass, {1, 2, 3, 4});
  grains.from_host(Previous<Mass>{}, {5, 6, 7, 8});
  AnyParticles<P>& any = grains;
  CHECK(any.has(mass));
  CHECK_FALSE(any.has(velocity));
  CHECK_FALSE(any.has(Previous<Position>{}));
  CHECK(any.number_of(mass) == 1);
  CHECK(any.number_of(Previous<Mass>{}) == 3);  // of the same name
  CHECK(any.to_host(mass) == grains.to_host(mass));
  CHECK(any.to_host(Previous<Mass>{}) == grains.to_host(Previous<Mass>{}));
  CHECK(static_cast<void const*>(any.column(identity).data()) == grains.column(identity).data());
  CHECK(any[position].size() == 4);
  CHECK(any.numbers_of(Fields<Identity, Position>{}) == std::vector<std::size_t>{2, 0});
  CHECK_THROWS_WITH(any.number_of(velocity), "scree: these particles do not carry the field 'velocity'");
  CHECK_THROWS_AS(any.column(velocity), std::logic_error);
  CHECK_THROWS_AS(any.numbers_of(Fields<Mass, Velocity>{}), std::logic_error);
}

TEMPLATE_LIST_TEST_CASE("there may be no particles", "", Policies) {
  Grains<TestType> grains;
  CHECK(grains.extent() == 0);
  CHECK(grains.to_host(position).empty());
  grains.from_host(identity, {});
  grains.fill(mass, 1);
  grains.resize(2);
  CHECK(grains.to_host(identity).size() == 2);
}

}  // namespace scree::test::particles_tests
