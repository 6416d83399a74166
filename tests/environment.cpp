// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <catch2/catch_test_macros.hpp>

#include <cstdlib>
#include <string>

TEST_CASE("tests that ctest starts have threads that do not spin, and their number") {
  auto const value = [](char const* name) {
    char const* const found = std::getenv(name);
    return std::string(found != nullptr ? found : "");
  };
  if (value("CTEST_INTERACTIVE_DEBUG_MODE").empty()) SKIP("not started by ctest");
  CHECK(value("OMP_PROC_BIND") == "false");
  CHECK(value("OMP_WAIT_POLICY") == "passive");
  CHECK(value("OMP_NUM_THREADS") == SCREE_TEST_THREADS);
}
