// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/tuple.hpp>

#include <catch2/catch_test_macros.hpp>

#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace scree::test::tuple_tests {

using detail::Tuple;

TEST_CASE("a tuple keeps values of several types in order") {
  Tuple const all(1, std::string("two"), 3.0);
  STATIC_CHECK(std::is_same_v<decltype(all), Tuple<int, std::string, double> const>);
  CHECK(detail::value_at<0>(all) == 1);
  CHECK(detail::value_at<1>(all) == "two");
  CHECK(detail::value_at<2>(all) == 3.0);
  STATIC_CHECK(std::is_same_v<detail::type_at<1, decltype(all)>, std::string>);
  STATIC_CHECK(detail::tuple_size<decltype(all)> == 3);
  STATIC_CHECK(std::tuple_size_v<Tuple<>> == 0);
  auto const as_text = [](auto const&... each) { return (std::string() + ... + std::to_string(sizeof(each))); };
  CHECK(detail::with_values(as_text, all) == detail::with_values(as_text, std::tuple(1, std::string("two"), 3.0)));
  Tuple changed(1, 2);
  detail::value_at<1>(changed) = 5;
  CHECK(detail::with_values([](int a, int b) { return 10 * a + b; }, changed) == 15);
}

TEST_CASE("a tuple without values given has zeros") {
  struct Holder {
    Tuple<int, double, int*> values;
  };
  auto const holder = std::make_unique_for_overwrite<Holder>();
  auto const& none = holder->values;
  CHECK(detail::with_values([](int a, double b, int* c) { return a == 0 && b == 0 && c == nullptr; }, none));
  struct Given {
    explicit Given(int n) : number(n) {}
    int number;
  };
  STATIC_CHECK_FALSE(std::is_default_constructible_v<Tuple<Given>>);
  CHECK(detail::value_at<0>(Tuple(Given(3))).number == 3);
}

TEST_CASE("tuples of both kinds are put in a row") {
  auto const all = detail::in_a_row(std::tuple(1), Tuple<>(), Tuple(2, 3L), std::tuple<>(), std::tuple('4', 5.0));
  STATIC_CHECK(std::is_same_v<decltype(all), Tuple<int, int, long, char, double> const>);
  CHECK(detail::as_std_tuple(all) == std::tuple(1, 2, 3L, '4', 5.0));
  STATIC_CHECK(std::is_same_v<detail::row_type<std::tuple<int>, Tuple<>, Tuple<long>>, Tuple<int, long>>);
  STATIC_CHECK(std::is_same_v<decltype(detail::in_a_row()), Tuple<>>);
  STATIC_CHECK(std::is_same_v<detail::row_type<>, Tuple<>>);
  CHECK(detail::as_std_tuple(detail::in_a_row(std::tuple(7))) == std::tuple(7));
}

TEST_CASE("values of one type at several places keep their places") {
  auto const all = detail::in_a_row(Tuple(1, 1), Tuple(2), Tuple(1));
  CHECK(detail::as_std_tuple(all) == std::tuple(1, 1, 2, 1));
}

TEST_CASE("a list of values that cannot be copied is made in place") {
  detail::TupleValues<std::index_sequence_for<int, char>, std::unique_ptr<int>, std::unique_ptr<char>> owned{
      {std::make_unique<int>(4)}, {nullptr}};
  CHECK(*detail::value_at<0>(owned) == 4);
  CHECK(detail::value_at<1>(owned) == nullptr);
}

TEST_CASE("only tuples are taken for tuples") {
  STATIC_CHECK(detail::AnyTuple<std::tuple<int> const&>);
  STATIC_CHECK(detail::AnyTuple<Tuple<>>);
  STATIC_CHECK_FALSE(detail::AnyTuple<std::pair<int, int>>);
  STATIC_CHECK_FALSE(detail::AnyTuple<int>);
}

}  // namespace scree::test::tuple_tests
