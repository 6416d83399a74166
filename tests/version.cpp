// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/version.hpp>

#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>

#include <string>

TEST_CASE("the version in the headers is the one of the CMake project") {
  auto const [major, minor, patch] = scree::library_version;
  CHECK(fmt::format("{}.{}.{}", major, minor, patch) == std::string(SCREE_CMAKE_VERSION));
  CHECK(SCREE_VERSION == 10000 * major + 100 * minor + patch);
}
