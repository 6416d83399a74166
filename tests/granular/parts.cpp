// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/parts.hpp>

#include <scree/granular/segregating.hpp>
#include <scree/kernels/wendland_c4.hpp>
#include <scree/segregation/constant_closure.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::parts_tests {
namespace {

using Catch::Matchers::ContainsSubstring;

struct Clay : GranularModels {
  using filter = NoFilter;
  using wals = int;  // misspelt
};
struct Case : Formulation<2> {
  using physics = Combined<Granular<Clay>, ConservativeSegregation<ConstantClosure>>;
  using kernel = WendlandC4;
  using integratr = int;  // misspelt
};

}  // namespace

TEST_CASE("the parts of a formulation are listed with their defaults") {
  auto const text = parts_of<Case>();
  CHECK_THAT(text, ContainsSubstring("  kernel: scree::WendlandC4\n"));
  CHECK_THAT(text, ContainsSubstring("  integrator: scree::Midpoint\n"));
  CHECK_THAT(text, ContainsSubstring("  motion: scree::AtRest\n"));
  CHECK_THAT(text, ContainsSubstring("  filter: scree::NoFilter\n"));
  CHECK_THAT(text, ContainsSubstring("  walls: scree::ConservingWalls\n"));
  CHECK_THAT(text, ContainsSubstring("ConservativeSegregation"));
}

}  // namespace scree::test::parts_tests
