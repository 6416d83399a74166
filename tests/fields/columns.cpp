// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/columns.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::columns_tests {
using namespace fields;

template <class P>
struct Twice {
  Columns<P, Fields<Mass, Position>> from;
  Columns<P, Fields<Density>> to;
  SCREE_FN void operator()(int i) const {
    auto const record = from.load(i);
    if (i % 2 == 0) {
      Results<P, Fields<Density>> out;
      out[density] = 2 * record[mass];
      to.store(i, out);
    } else {
      Sums<P, Fields<Density>> sums;
      sums[density] += record[mass] + record[position][0];
      sums[density] += record[mass] - record[position][0];
      to.store(i, sums.totals());
    }
  }
};

TEMPLATE_LIST_TEST_CASE("a kernel loads records and stores results and sums of selected fields", "", Policies) {
  using P = TestType;
  auto body = body_of<P, Mass, Density>(random_points<P::dim>(101, 1, 2, 1), 1);
  set(body, mass, [](auto const& x) { return x[1]; });
  for_each_index(typename P::space(), "scree::test::twice", 0, body.size(),
                 Twice<P>{body.select(Fields<Mass, Position>{}), body.select(Fields<Density>{})});
  CHECK(largest_error(body, density, 4, [](auto const& x) { return 2 * x[1]; }) < ulps<P>(4));
}

}  // namespace scree::test::columns_tests
