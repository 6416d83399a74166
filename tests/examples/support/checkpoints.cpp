// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/checkpoints.hpp>

#include "folder.hpp"

#include <sys/wait.h>

#include <catch2/catch_test_macros.hpp>

#include <cstdlib>

using support::Checkpoints;
using support::Interrupt;
using Lines = std::vector<std::string>;

namespace {

struct StandIn {
  double time = 0;
  scree::Snapshot snapshot() const {
    scree::Snapshot result;
    result.time = time;
    return result;
  }
};

/// The end of a child process that runs `action`: its exit code, or minus the number of the signal.
template <class Action>
int end_of(Action action) {
  ::pid_t const child = ::fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);  // not those of the test framework
    for (int const signal : {SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}) std::signal(signal, SIG_DFL);
    std::_Exit(action());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("Ctrl-C and what a scheduler or a terminal sends raise a flag, the second Ctrl-C ends the program") {
  for (int const signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}) {
    CHECK(end_of([&] {
            Interrupt const interrupt;
            if (interrupt.requested() || interrupt.exit_code() != 0) return 1;
            std::raise(signal);
            return interrupt.requested() ? interrupt.exit_code() : 2;
          }) == 128 + signal);
    for (int const second : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1})
      CHECK(end_of([&] {
              Interrupt const interrupt;
              std::raise(signal);
              std::raise(second);
              return interrupt.requested() ? interrupt.exit_code() : 3;
            }) == (signal == SIGINT && second == SIGINT ? -SIGINT : 128 + second));
    CHECK(end_of([&] {
            { Interrupt const interrupt; }
            std::raise(signal);
            return 4;
          }) == -signal);
    CHECK(end_of([&] {
            std::signal(signal, SIG_IGN);
            Interrupt const interrupt;
            std::raise(signal);
            return interrupt.requested() ? 5 : 0;
          }) == 0);
  }
}

TEST_CASE("there is one interrupt at a time") {
  {
    Interrupt const one;
    CHECK_THROWS_AS(Interrupt(), std::logic_error);
  }
  Interrupt const another;
  CHECK_FALSE(another.requested());
}

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
    solver.time = time;
    CHECK_FALSE(checkpoints.after_step(solver));
  };
  step_to(59);
  CHECK_FALSE(std::filesystem::exists(folder / "checkpoint.h5"));
  for (double const time : {61, 100, 120, 122, 180}) step_to(time);
  CHECK(support::read_checkpoint(folder / "checkpoint.h5").time == 122);
  CHECK(support::read_checkpoint(folder / "checkpoint.previous.h5").time == 61);
  CHECK(support::read_checkpoint(folder / "checkpoint.h5").notes.at("case") == "x = 1\n");
  CHECK(checkpoints.exit_code() == 0);
}

TEST_CASE("a checkpoint keeps numbers of the program") {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  for (std::vector<double> const& numbers : {std::vector<double>{}, {1.0 / 3, -0.0, 1e300}}) {
    Checkpoints checkpoints({.file = file, .notes = {}});
    checkpoints.keep("recorder", [&] { return numbers; });
    checkpoints.save({});
    CHECK(support::numbers_in(support::read_checkpoint(file), "recorder") == numbers);
    CHECK(support::numbers_in(support::read_checkpoint(file), "other").empty());
  }
}

TEST_CASE("an interrupted run leaves a checkpoint") {
  Folder const folder;
  CHECK(end_of([&] {
          Checkpoints checkpoints({.file = folder / "checkpoint.h5", .interval = 1e9, .notes = {}});
          for (StandIn solver;; solver.time += 1) {
            if (solver.time == 7) std::raise(SIGTERM);
            if (checkpoints.after_step(solver)) return checkpoints.exit_code();
          }
        }) == 128 + SIGTERM);
  CHECK(support::read_checkpoint(folder / "checkpoint.h5").time == 7);
}

TEST_CASE("changes of the case since a checkpoint are told") {
  Folder const folder;
  std::string const before = "# sizes\n[a]\nspacing = 0.04 \n\n[b]\nend = 3\n",
                    now = "[a]\nspacing = 0.05\nend = 3\n[b]\nend = 3\n";
  CHECK(support::changes({{"case", before}}, {{"case", before + "# more\n"}}).empty());
  CHECK(support::changes({{"case", before}, {"x", "1"}}, {{"case", now}}) ==
        Lines{"case: '[a] spacing = 0.04 ' of the checkpoint is missing", "case: '[a] spacing = 0.05' is new",
              "case: '[a] end = 3' is new", "x: '1' of the checkpoint is missing"});
  auto const file = folder / "checkpoint.h5";
  Checkpoints({.file = file, .notes = {{"case", before}}}).save({});
  Lines told;
  Checkpoints({.file = file, .notes = {{"case", now}}}).read(file, [&](auto const& line) { told.push_back(line); });
  CHECK(told.size() == 3);
  CHECK(told[0] == file.string() + ": case: '[a] spacing = 0.04 ' of the checkpoint is missing");
}
