// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/whole_case.hpp>
#include <scree/run/progress.hpp>

#include <support/printed.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>

namespace scree::test::progress_tests {
using namespace scree;

TEST_CASE("progress is one changing line on a terminal and lines now and then elsewhere") {
  double now = 100;
  auto const clock = [&] { return now; };
  auto const run = [&](std::FILE* stream, bool terminal, bool quiet) {
    now = 100;
    Progress progress(
        {.end = 120, .name = "t/T", .quiet = quiet, .stream = stream, .terminal = terminal, .seconds = clock});
    for (int step = 1; step <= 24; ++step) {
      now += 1;
      progress.update(5.0 * step, 100L * step);
    }
    progress.finish(120, 2400);
  };
  CHECK(printed([&](std::FILE* stream) { run(stream, false, false); }) ==
        "t/T 50.00 of 120 (42 %), 1000 steps, 100 steps/s, 0:14 left\n"
        "t/T 100.00 of 120 (83 %), 2000 steps, 100 steps/s, 0:04 left\n"
        "t/T 120.00 of 120 (100 %), 2400 steps, 100 steps/s, took 0:24\n");
  CHECK(printed([&](std::FILE* stream) { run(stream, true, true); }).empty());

  auto const line = printed([&](std::FILE* stream) { run(stream, true, false); });
  CHECK(std::ranges::count(line, '\r') == 25);
  CHECK(std::ranges::count(line, '\n') == 1);
  CHECK(line.ends_with("\rt/T 120.00 of 120 (100 %), 2400 steps, 100 steps/s, took 0:24\x1b[K\n"));

  auto const cut_off = printed([&](std::FILE* stream) {
    Progress progress({.end = 0, .stream = stream, .terminal = true, .seconds = clock});
    now += 1;
    progress.update(0, 1);  // a division by zero is possible here
  });
  CHECK(cut_off.ends_with("\n"));
  CHECK(clock_text(59.6) == "1:00");
  CHECK(clock_text(3723) == "1:02:03");
  CHECK(clock_text(-1) == "0:00");
}

TEST_CASE("progress that cannot be printed does not stop a program") {
  std::FILE* const full = std::fopen("/dev/full", "w");
  REQUIRE(full != nullptr);
  std::setvbuf(full, nullptr, _IONBF, 0);
  CHECK_NOTHROW(Progress({.stream = full, .terminal = false}).finish(1, 1));
  std::fclose(full);
}

TEST_CASE("progress follows a solver in its own unit of time, and never stops it") {
  struct {
    double time() const { return 6; }
    long steps() const { return 40; }
  } const solver;
  double now = 0;
  auto const text = printed([&](std::FILE* stream) {
    Progress progress(
        {.end = 4, .name = "t/T", .unit = 3, .stream = stream, .terminal = false, .seconds = [&] { return now; }});
    CHECK_FALSE(progress.due());
    now = 20;
    CHECK(progress.due());
    CHECK_FALSE(progress.after_step(solver));
    CHECK_FALSE(progress.due());
    progress.finish(solver);
  });
  CHECK(text ==
        "t/T 2.00 of 4 (50 %), 40 steps, 2 steps/s, 0:20 left\n"
        "t/T 2.00 of 4 (50 %), 40 steps, 2 steps/s, took 0:20\n");
}

TEST_CASE("the rate and the time left of a continued run count what this run did") {
  struct {
    double at = 6;
    long done = 40;
    double time() const { return at; }
    long steps() const { return done; }
  } solver;
  double now = 0;
  auto const text = printed([&](std::FILE* stream) {
    Progress progress({.end = 12, .stream = stream, .terminal = false, .seconds = [&] { return now; }});
    progress.begin(solver);
    now = 20;
    solver = {.at = 8, .done = 80};
    progress.after_step(solver);
    progress.begin(solver);  // of a second run, with the same clock
    progress.finish(solver);
  });
  CHECK(text ==
        "t/s 8.00 of 12 (67 %), 80 steps, 2 steps/s, 0:40 left\n"
        "t/s 8.00 of 12 (67 %), 80 steps, 2 steps/s, took 0:20\n");
}

namespace {
/// A solver that loses particles, and counts how often it is asked.
struct Losing {
  long gone = 0;
  mutable int asked = 0;
  double time() const { return 6; }
  long steps() const { return 40; }
  scree::WholeCase whole_case() const { return {}; }
  long lost() const { return ++asked, gone; }
};
}  // namespace

TEST_CASE("progress says how many particles are lost, and asks only when it prints") {
  double now = 0;
  auto const run = [&](auto solver, std::FILE* stream, bool terminal, bool quiet) {
    now = 0;
    Progress progress(
        {.end = 12, .quiet = quiet, .stream = stream, .terminal = terminal, .seconds = [&] { return now; }});
    for (long const gone : {0, 1, 3}) {
      solver.gone = gone;
      for (int step = 0; step < 20; ++step) now += 0.6, progress.after_step(solver);
    }
    if (!terminal) CHECK(solver.asked == (quiet ? 0 : 3));
    progress.finish(solver);
  };
  CHECK(printed([&](std::FILE* stream) { run(Losing(), stream, false, false); }) ==
        "t/s 6.00 of 12 (50 %), 40 steps, 3.92 steps/s, 0:10 left\n"
        "t/s 6.00 of 12 (50 %), 40 steps, 1.96 steps/s, 0:20 left, 1 lost\n"
        "t/s 6.00 of 12 (50 %), 40 steps, 1.31 steps/s, 0:31 left, 3 lost\n"
        "t/s 6.00 of 12 (50 %), 40 steps, 1.11 steps/s, took 0:36\n"
        "3 particles are lost: beyond the walls, see docs/checks.md\n");
  auto const line = printed([&](std::FILE* stream) { run(Losing(), stream, true, false); });
  CHECK(line.ends_with(", took 0:36\x1b[K\n3 particles are lost: beyond the walls, see docs/checks.md\n"));
  CHECK(printed([&](std::FILE* stream) { run(Losing(), stream, false, true); }).empty());
}

}  // namespace scree::test::progress_tests
