// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#define SCREE_RANKS
#include "ranks.hpp"

#include <catch2/catch_test_macros.hpp>

namespace scree::test::ranks_tests {
namespace {
struct ThisFile {};
}  // namespace

TEST_CASE("of the files of one program, those compiled for ranks allow them, and those for whole cases do not") {
  CHECK(cases::allows_two<ThisFile>());
  CHECK_FALSE(cases::allowed_in_whole_cases());
}

}  // namespace scree::test::ranks_tests
