// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/policies.hpp>
#include <support/sudden.hpp>

#include <catch2/catch_template_test_macros.hpp>

namespace scree::test::sudden_tests {

TEMPLATE_LIST_TEST_CASE("neighbour lists notice whatever happens of a sudden", "", Backends) {
  using Q = Policy<2, double, TestType>;
  sudden::for_each_case([](char const* name, auto const& motion, auto const& act) {
    sudden::compare<Q, SymplecticEuler>(name, motion, act);
    sudden::compare<Q, Midpoint>(name, motion, act);
  });
}

TEMPLATE_LIST_TEST_CASE("neighbour lists notice a suddenly moving plate where steps are asked for one by one", "",
                        Backends) {
  using P = WithLists<Policy<2, double, TestType>, SuddenStart, SymplecticEuler>;
  auto by_run = sudden::run<P>({0.05, 4}, {});
  auto by_step = sudden::at_rest<P>({0.05, 4});
  while (by_step.time() < sudden::end) by_step.step(sudden::end - by_step.time());
  CHECK(by_step.neighbour_builds() == by_run.neighbour_builds());
  CHECK(by_step.steps() == by_run.steps());
  CHECK(by_step.neighbour_builds() < by_step.steps() / 4);
}

}  // namespace scree::test::sudden_tests
