// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/loop.hpp>
#include <scree/fields/array.hpp>

#include <support/backends.hpp>
#include <support/policies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree::test::loop_tests {
namespace {

/// A value with two numbers, whose order of addition shows in the second.
struct Both {
  long count = 0;
  double sum = 0;
  SCREE_FN Both& operator+=(Both const& other) {
    count += other.count, sum += other.sum;
    return *this;
  }
  friend bool operator==(Both const&, Both const&) = default;
};
struct SumThirds {
  using value_type = Both;
  Span<Both> sums;
  SCREE_FN Both operator()(int i) const { return {i, i / 3.0}; }
  SCREE_FN void store(int range, Both const& sum) const { sums(range) = sum; }
};

}  // namespace
}  // namespace scree::test::loop_tests

template <>
struct Kokkos::reduction_identity<scree::test::loop_tests::Both> {
  KOKKOS_FUNCTION static scree::test::loop_tests::Both sum() { return {}; }
};

namespace scree::test::loop_tests {

TEMPLATE_LIST_TEST_CASE("ranges are summed with each index once, and repeat bit for bit", "", Backends) {
  using P = Policy<2, double, TestType>;
  TestType const space;
  std::vector<int> const bounds = {0, 1, 1, 40, 4000, 104000, 104000};
  auto const on_device = array_of<P>(space, bounds);
  Array<P, Both> sums(space, "sums", bounds.size() - 1);
  auto const sum = [&] {
    copy_into(sums, std::vector<Both>(bounds.size() - 1, Both{-1, -1}));
    sum_ranges(space, "sum", Span<int const>(on_device), SumThirds{sums});
    return values_of(sums);
  };
  auto const first = sum();
  for (std::size_t range = 0; range + 1 < bounds.size(); ++range) {
    long const from = bounds[range], to = bounds[range + 1], count = (to - from) * (from + to - 1) / 2;
    CHECK(first[range].count == count);
    CHECK(std::abs(first[range].sum - double(count) / 3) <= 1e-12 * double(count));
  }
  for (int k = 0; k < 3; ++k) CHECK(std::ranges::equal(sum(), first));
}

}  // namespace scree::test::loop_tests
