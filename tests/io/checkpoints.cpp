// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/checkpoints.hpp>

#include <support/child.hpp>
#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::checkpoints_tests {
using scree::Checkpoints;
using scree::read_checkpoint;
using Lines = std::vector<std::string>;

namespace {

struct StandIn {
  double now = 0;
  double time() const { return now; }
  scree::Snapshot snapshot() const {
    scree::Snapshot result;
    result.time = now;
    return result;
  }
};

}  // namespace

TEST_CASE("checkpoints are written now and then") {
  Folder const folder;
  double clock = 100;
  Checkpoints checkpoints(
      {.file = folder / "checkpoint.h5", .interval = 60, .notes = {{"case", "x = 1\n"}}, .seconds = [&] {
         return clock;
       }});
  StandIn solver;
  auto const step_to = [&](double time) {
    clock = 100 + time;
    solver.now = time;
    CHECK_FALSE(checkpoints.after_step(solver));
  };
  step_to(59);
  CHECK_FALSE(std::filesystem::exists(folder / "checkpoint.h5"));
  for (double const time : {61, 100, 120, 122, 180}) step_to(time);
  CHECK(read_checkpoint(folder / "checkpoint.h5").time == 122);
  CHECK(read_checkpoint(folder / "checkpoint.previous.h5").time == 61);
  CHECK(read_checkpoint(folder / "checkpoint.h5").notes.at("case") == "x = 1\n");
  CHECK(checkpoints.exit_code() == 0);
}

TEST_CASE("a checkpoint keeps numbers of the program") {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  for (std::vector<double> const& numbers : {std::vector<double>{}, {1.0 / 3, -0.0, 1e300}}) {
    Checkpoints checkpoints({.file = file, .notes = {}});
    checkpoints.keep("recorder", [&] { return numbers; });
    checkpoints.save({});
    CHECK(scree::numbers_in(read_checkpoint(file), "recorder") == numbers);
    CHECK(scree::numbers_in(read_checkpoint(file), "other").empty());
  }
}

TEST_CASE("an interrupted run leaves a checkpoint") {
  Folder const folder;
  CHECK(end_of([&] {
          Checkpoints checkpoints({.file = folder / "checkpoint.h5", .interval = 1e9, .notes = {}});
          for (StandIn solver;; solver.now += 1) {
            if (solver.now == 7) std::raise(SIGTERM);
            if (checkpoints.after_step(solver)) return checkpoints.exit_code();
          }
        }) == 128 + SIGTERM);
  CHECK(read_checkpoint(folder / "checkpoint.h5").time == 7);
}

TEST_CASE("a checkpoint that is read reports how the case has changed") {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  Checkpoints({.file = file, .notes = {{"case", "x = 1\n"}}}).save({});
  Lines reported;
  Checkpoints({.file = file, .notes = {{"case", "x = 2\n"}}}).read(file, [&](auto const& line) {
    reported.push_back(line);
  });
  CHECK(reported == Lines{file.string() + ": case: 'x = 1' of the checkpoint is missing",
                          file.string() + ": case: 'x = 2' is new"});
}

}  // namespace scree::test::checkpoints_tests
