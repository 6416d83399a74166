// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sample_terms.hpp"

#include <support/policies.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::term_tests {
namespace {

struct NamesNothing {
  template <class I, class J, class IJ, class S>
  void operator()(I const&, J const&, IJ const&, S&) const {}
};
struct IsNoFunction {
  using reads = Fields<>;
  using adds = Fields<>;
};
struct SetsOne {
  using reads = Fields<>;
  using writes = Fields<Charge>;
  template <class I, class O>
  void operator()(I const&, O& out) const {
    out[charge] = 1;
  }
};
using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

}  // namespace

TEST_CASE("a pair term names what it reads and adds, and is a function of a pair") {
  STATIC_CHECK(PairTerm<Repulsion, P>);
  STATIC_CHECK(PairTerm<Heat, P>);
  STATIC_CHECK_FALSE(PairTerm<NamesNothing, P>);
  STATIC_CHECK_FALSE(PairTerm<IsNoFunction, P>);
  STATIC_CHECK_FALSE(PairTerm<SetsOne, P>);
}

TEST_CASE("a term meets the particle itself only if it says so") {
  STATIC_CHECK(includes_self<Screening>);
  STATIC_CHECK_FALSE(includes_self<Repulsion>);
}

TEST_CASE("a point function names what it reads and writes") {
  STATIC_CHECK(PointFunction<SetsOne, P>);
  STATIC_CHECK_FALSE(PointFunction<Repulsion, P>);
}

}  // namespace scree::test::term_tests
