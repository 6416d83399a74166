// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/argument.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>

#include <string>

namespace scree::test::argument_tests {
using scree::argument;

TEST_CASE("arguments of a program are numbers, or have a value where they are missing") {
  char const* const argv[] = {"program", "2.5e-3", "-7", "20"};
  CHECK(argument<double>(4, argv, 1, 1) == 2.5e-3);
  CHECK(argument<double>(4, argv, 2, 1) == -7);
  CHECK(argument<int>(4, argv, 3, 1) == 20);
  CHECK(argument<int>(3, argv, 3, 10) == 10);
  CHECK(argument<double>(1, argv, 1, 0.5) == 0.5);
}

TEST_CASE("an argument that is no number is named with its text") {
  for (std::string const text : {"abc", "", "4mm", "1,5", "nan", "inf", "1e999", "2 3"}) {
    char const* const argv[] = {"program", text.c_str()};
    CHECK_THROWS_WITH(argument<double>(2, argv, 1, 1), "argument 1 must be a number, not '" + text + "'");
  }
  for (std::string const text : {"2.5", "3e9", "x"}) {
    char const* const argv[] = {"program", "1", text.c_str()};
    CHECK_THROWS_WITH(argument<int>(3, argv, 2, 1), "argument 2 must be a whole number, not '" + text + "'");
  }
}

}  // namespace scree::test::argument_tests
