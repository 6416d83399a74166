// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "checkpoint_file.hpp"

#include <support/granular_box.hpp>

#include <catch2/catch_test_macros.hpp>

// A granular run through a file; without the file: tests/granular/granular.cpp. The name excludes this file from builds
// for CUDA.
namespace scree::test::checkpoint_restart_granular_tests {

TEST_CASE("a granular run that goes on from a checkpoint ends with the same bits") {
  using granular_box::stepped;
  Folder const folder;
  auto const file = folder / "granular.h5";
  auto whole = granular_box::turning(), resumed = granular_box::turning();
  write_checkpoint(file, stepped(whole, 47).snapshot());  // off the phase of filter and segregation
  resumed.restore(read_checkpoint(file));
  CHECK(resumed.steps() == 47);
  CHECK(stepped(resumed, 80).snapshot() == stepped(whole, 80).snapshot());
  auto again = granular_box::turning();
  again.restore(read_checkpoint(file));
  CHECK(again.snapshot() != whole.snapshot());
}

}  // namespace scree::test::checkpoint_restart_granular_tests
