// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/words.hpp>

#include <support/points.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::words_tests {

struct alignas(16) Marked {
  double x[2];
  float y;
  int index;
};
struct alignas(8) Small {
  float x;
  int index;
};

template <class P, class T>
struct CopyByWords {
  Span<T> from, to;
  SCREE_FN void operator()(int i) const { to(i) = scree::detail::read_words(&from(i)); }
};

template <class P, class T>
std::vector<T> copied_by_words(std::vector<T> const& values) {
  Array<P, T> const from(typename P::space(), "scree::test::from", values.size()),
      to(typename P::space(), "scree::test::to", values.size());
  copy_into(from, values);
  for_each_index(typename P::space(), "scree::test::words", 0, int(values.size()), CopyByWords<P, T>{from, to});
  return values_of(to);
}

TEMPLATE_LIST_TEST_CASE("a value read in words is the value", "", Policies) {
  std::vector<Marked> marked;
  std::vector<Small> small;
  for (int k = 0; k < 50; ++k) {
    marked.push_back({{0.1 * k, -0.3 * k}, 0.7f * float(k), k});
    small.push_back({-0.7f * float(k), -k});
  }
  auto const marked_again = copied_by_words<TestType>(marked);
  auto const small_again = copied_by_words<TestType>(small);
  for (std::size_t k = 0; k < 50; ++k) {
    CHECK(marked_again[k].x[0] == marked[k].x[0]);
    CHECK(marked_again[k].x[1] == marked[k].x[1]);
    CHECK(marked_again[k].y == marked[k].y);
    CHECK(marked_again[k].index == marked[k].index);
    CHECK(small_again[k].x == small[k].x);
    CHECK(small_again[k].index == small[k].index);
  }
}

}  // namespace scree::test::words_tests
