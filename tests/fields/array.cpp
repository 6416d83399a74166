// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/array.hpp>

#include <support/points.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::array_tests {

// A value with whole words and a rest, one of whole words, one smaller than a word.
template <class P>
using Real7 = Vec<7, typename P::real>;
template <class P>
using Real4 = Vec<4, typename P::real>;
template <class P>
using Square = Mat<P::dim, typename P::real>;

template <class P, class T>
struct Doubled {
  ArraySpan<P, T> values, twice;
  SCREE_FN void operator()(int i) const {
    T const value = value_of(values(i));
    twice(i) = T(value + value);
  }
};

template <class T>
T numbered(int n) {
  T value;
  for (int k = 0; k < value.size(); ++k) value.data()[k] = typename T::Scalar(100 * n + k);
  return value;
}

template <class P, class T>
void check_array() {
  std::vector<T> values;
  for (int n = 0; n < 40; ++n) values.push_back(numbered<T>(n));
  typename P::space const space;
  Array<P, T> const there(space, "scree::test::there", values.size()),
      twice(space, "scree::test::twice", values.size());
  copy_into(there, values);
  CHECK(values_of(there) == values);
  for_each_index(space, "scree::test::twice", 0, 40, Doubled<P, T>{there, twice});
  auto const found = values_of(twice);
  for (std::size_t n = 0; n < values.size(); ++n) CHECK(found[n] == values[n] + values[n]);
}

TEMPLATE_LIST_TEST_CASE("an array holds values, however they lie in it", "", Policies) {
  using P = TestType;
  check_array<P, Vec<P::dim, typename P::real>>();
  check_array<P, Real4<P>>();
  check_array<P, Real7<P>>();
  check_array<P, Square<P>>();
}

TEMPLATE_LIST_TEST_CASE("values lie as they are on a host, and in words on a GPU where these cost little", "",
                        Policies) {
  using P = TestType;
  using real = typename P::real;
  auto const bytes = [](auto const& array) { return sizeof(*array.data()); };
  bool const in_words = !runs_on_host<P>, floats = sizeof(real) == 4;
  CHECK(bytes(Array<P, real>()) == sizeof(real));
  CHECK(bytes(Array<P, int>()) == sizeof(int));
  CHECK(bytes(Array<P, Vec<2, real>>()) == 2 * sizeof(real));
  CHECK(bytes(Array<P, Vec<3, real>>()) == (in_words && floats ? 4 : 3) * sizeof(real));
  CHECK(bytes(Array<P, Vec<6, real>>()) == (in_words && floats ? 8 : 6) * sizeof(real));
}

}  // namespace scree::test::array_tests
