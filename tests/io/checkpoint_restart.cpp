// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "checkpoint_file.hpp"

#include <scree/snapshots/snapshot_of.hpp>

#include <support/moving_particles.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

// The whole restart, through a file. Not part of builds for CUDA, where the host compiler cannot compile Kokkos;
// tests/snapshots/snapshot.cpp does the same there without the file.
namespace scree::test::checkpoint_restart_tests {

using namespace checkpoint_test;

TEMPLATE_LIST_TEST_CASE("a run that goes on from a checkpoint ends with the same bits", "", Policies) {
  using P = TestType;
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  for (bool const periodic : {false, true}) {
    INFO("periodic " << periodic);
    auto straight = moving_system<P, VerletList>(periodic);
    advance(straight, 20);
    write_checkpoint(file, snapshot_of(straight));
    advance(straight, 17);
    auto resumed = moving_system<P, VerletList>(periodic);
    restore_into(resumed, read_checkpoint(file));
    advance(resumed, 17);
    CHECK(snapshot_of(resumed) == snapshot_of(straight));
  }
}

TEST_CASE("a checkpoint of another precision or dimension is refused by its name") {
  using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  auto system = moving_system<OnHost, VerletList>(true);
  auto const complaint = [&] { return complaint_of([&] { restore_into(system, read_checkpoint(file)); }); };
  using Single = Policy<2, float, Kokkos::DefaultHostExecutionSpace>;
  write_checkpoint(file, snapshot_of(moving_system<Single, VerletList>(true)));
  CHECK(complaint() ==
        file.string() + ": does not fit this run: 'precision' is float64 in this run and float32 in the snapshot");
  using Solid = Policy<3, double, Kokkos::DefaultHostExecutionSpace>;
  write_checkpoint(file, snapshot_of(moving_system<Solid, VerletList>(true)));
  CHECK(complaint() == file.string() + ": does not fit this run: 'dimension' is 2 in this run and 3 in the snapshot");
}

}  // namespace scree::test::checkpoint_restart_tests
