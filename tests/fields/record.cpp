// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/record.hpp>
#include <scree/fields/standard.hpp>

#include <support/policies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <type_traits>
#include <utility>

namespace scree::test::record_tests {
using namespace fields;
namespace {
template <class T, class X>
concept Subtracts = requires(T& sum, X x) {
  sum -= x;
};
template <class T>
concept IsNumber = std::convertible_to<T, double>;
}  // namespace

TEMPLATE_LIST_TEST_CASE("a record gives values by field, to be read only", "", Policies) {
  using P = TestType;
  Record<P, Fields<Mass, Velocity>> const i{{2}, {Vec<P::dim, typename P::real>::Ones()}};
  CHECK(i[mass] == 2);
  CHECK(i[velocity].sum() == P::dim);
  Record<P, Fields<Mass>> j{{1}};
  STATIC_CHECK(std::is_const_v<std::remove_reference_t<decltype(j[mass])>>);
}

TEMPLATE_LIST_TEST_CASE("sums start from zero and are added to", "", Policies) {
  using P = TestType;
  using vector = Vec<P::dim, typename P::real>;
  Sums<P, Fields<Mass, Velocity>> sum;
  CHECK(sum.totals()[mass] == 0);
  CHECK(sum.totals()[velocity] == vector(vector::Zero()));
  sum[mass] += 2;
  sum[mass] += 3;
  sum[velocity] += 2 * vector::Ones();
  CHECK(sum.totals()[mass] == 5);
  CHECK(sum.totals()[velocity] == vector(vector::Constant(2)));
}

TEST_CASE("a sum offers nothing but +=") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  using Sum = std::remove_reference_t<decltype(std::declval<Sums<P, Fields<Mass>>&>()[mass])>;
  STATIC_CHECK_FALSE(std::is_assignable_v<Sum&, double>);
  STATIC_CHECK_FALSE(std::is_assignable_v<Sum&, Sum&>);  // sum[density] = sum[mass]
  STATIC_CHECK_FALSE(Subtracts<Sum, double>);
  STATIC_CHECK_FALSE(IsNumber<Sum>);
}

TEST_CASE("results are written by field") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  Results<P, Fields<Mass, Density>> out;
  out[density] = 7;
  out[mass] = out[density];
  CHECK(out[mass] == 7);
}

}  // namespace scree::test::record_tests
