// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/whole_body.hpp>

#include <scree/core/basis.hpp>
#include <scree/fields/standard.hpp>
#include <scree/kernels/wendland_c2.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cstdint>
#include <vector>

namespace scree::test::whole_body_tests {
using namespace fields;
namespace {

using P = Basis<2, double, WendlandC2, Kokkos::DefaultHostExecutionSpace>;
using Body = Particles<P, Fields<Position, Volume, Identity>>;

Body three() {
  Body body(3);
  body.from_host(position, std::vector<Vec<2, double>>{{1, 0}, {2, 0}, {3, 0}});
  body.from_host(volume, std::vector<double>{4, 5, 6});
  body.from_host(identity, std::vector<int>{7, 8, 9});
  return body;
}

/// Two ranks that have the same particles; lists come backwards.
struct Twice {
  struct Order {
    template <class T>
    std::vector<T> of(std::vector<T> const& values) const {
      return {values.rbegin(), values.rend()};
    }
  };
  template <class Any>
  long count(Any const& body) const {
    return 2 * body.size();
  }
  double largest(double here) const { return here + 1; }
  long sum(long here) const { return 2 * here; }
  std::vector<std::int64_t> sum(std::vector<std::int64_t> here) const {
    for (auto& each : here) each *= 2;
    return here;
  }
  template <class Any, class... Numbers>
  Order order_of(Any const&, Numbers const&...) const {
    return {};
  }
};

}  // namespace

TEST_CASE("a body whose particles are all here has their values in their order") {
  Body const body = three();
  WholeBody const whole(body, 0.5);
  CHECK(whole.time() == 0.5);
  CHECK(WholeBody(body, 1).time() == 1);  // a time, also as a whole number
  CHECK(whole.size() == 3);
  CHECK(whole.largest(2) == 2);
  CHECK(whole.sum(3L) == 3);
  CHECK(whole.all_of(std::vector{1, 2}) == std::vector{1, 2});
  CHECK(whole.values(identity) == std::vector{7, 8, 9});
  CHECK(whole.untyped().here().to_host(volume) == std::vector<double>{4, 5, 6});
}

TEST_CASE("a body of several ranks has what they agree on, and one order for all fields") {
  Body const body = three();
  Twice const ranks;
  WholeBody const whole(body, ranks, 0.5);
  CHECK(whole.size() == 6);
  CHECK(whole.largest(2) == 3);
  CHECK(whole.sum(3L) == 6);
  CHECK(whole.sum(std::vector<std::int64_t>{1, 2}) == std::vector<std::int64_t>{2, 4});
  auto const [volumes, numbers] = whole.values(volume, identity);
  CHECK(volumes == std::vector<double>{6, 5, 4});
  CHECK(numbers == std::vector{9, 8, 7});
  CHECK(whole.untyped().size() == 6);
}

}  // namespace scree::test::whole_body_tests
