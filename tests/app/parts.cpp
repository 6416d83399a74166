// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#define SCREE_PARTS
#include "parts.hpp"

#include <catch2/catch_test_macros.hpp>

namespace scree::test::parts_tests {
namespace {
struct ThisFile {};
}  // namespace

TEST_CASE("of the files of one program, those compiled for parts allow them, and those for whole cases do not") {
  CHECK(cases::allows_two<ThisFile>());
  CHECK_FALSE(cases::allowed_in_whole_cases());
}

}  // namespace scree::test::parts_tests
