// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shape.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/io/vtkhdf.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::checkpoints_tests {
namespace {

using namespace shape;
using Catch::Matchers::ContainsSubstring;

/// A solver that only has a time.
struct Clock {
  double now = 0;
  double time() const { return now; }
  Snapshot snapshot() const {
    Snapshot kept;
    kept.time = now;
    return kept;
  }
  void restore(Snapshot const& snapshot) { now = snapshot.time; }
};

Table const history{.file = "history.csv", .columns = {{"time", "min"}, {"sum"}}, .unit = 60};

/// Frames with a number, as BodySeries has the fields of a solver.
class Frames {
 public:
  Frames(std::filesystem::path path, int, int, VtkHdfOptions options) : series_(std::move(path), std::move(options)) {}
  static Frames continued(std::filesystem::path const& from, double time, std::filesystem::path path,
                          VtkHdfOptions options) {
    return {from, time, std::move(path), std::move(options)};
  }
  void append(double time) { series_.append({.time = time, .xyz = std::vector<double>{0, 0, 0}}); }

 private:
  Frames(std::filesystem::path const& from, double time, std::filesystem::path path, VtkHdfOptions options)
      : series_(VtkHdfSeries::continued(from, time, std::move(path), std::move(options))) {}

  VtkHdfSeries series_;
};

/// Runs of a program that adds up the minutes and writes a row and a frame for each of them.
struct Minutes {
  Folder folder;
  std::vector<double> sums = {0};

  Run<Options> run(std::string const& output) const {
    std::filesystem::create_directories(folder / output);
    return {.output = folder / output, .case_text = "[bed]\n"};
  }
  std::string simulate(std::string const& output, int minutes, std::filesystem::path const& from = {}) {
    Clock clock;
    sums = {0};
    Checkpoints checkpoints(run(output), 1e9, from);
    checkpoints.keep(
        "sums", [&] { return sums; }, [&](auto const& kept) { sums = kept; });
    checkpoints.restore(clock, 60.0 * minutes, {history});
    auto rows = checkpoints.open(history);
    auto frames = checkpoints.frames<Frames>();
    for (int minute = int(clock.now / 60) + 1; minute <= minutes; ++minute) {
      clock.now = 60.0 * minute;
      sums.push_back(sums.back() + minute);
      rows.row({double(minute), sums.back()});
      frames.append(clock.now);
    }
    checkpoints.save(clock.snapshot());
    return content_of(folder / output / "history.csv");
  }
};

}  // namespace

TEST_CASE("a run that starts from a checkpoint continues the tables and the numbers of the program") {
  Minutes all;
  auto const whole = all.simulate("whole", 5);
  auto const sums = all.sums;
  CHECK(sums == std::vector<double>{0, 1, 3, 6, 10, 15});
  CHECK(all.simulate("half", 3) != whole);
  auto const kept = all.folder / "half" / "checkpoint.h5";
  CHECK(all.simulate("rest", 5, kept) == whole);
  CHECK(all.sums == sums);
  // In the same directory, from the copy that was there before.
  CHECK(all.simulate("half", 5, kept) == whole);
}

TEST_CASE("a checkpoint from which a run cannot continue is refused before results are replaced") {
  Minutes all;
  all.simulate("half", 3);
  auto const output = all.folder / "half", kept = output / "checkpoint.h5";
  CHECK_THROWS_WITH(all.simulate("rest", 2, kept),
                    kept.string() + ": it is from 180 s, and the run ends at 120 s: make the run longer");
  CHECK_NOTHROW(all.simulate("rest", 3, kept));

  Clock clock;
  Checkpoints other(all.run("other"), 1e9, kept);
  other.keep(
      "balance", [] { return std::vector<double>(); }, [](auto const&) {});
  CHECK_THROWS_WITH(other.restore(clock, 300), ContainsSubstring("it holds no 'balance'"));

  Checkpoints third(all.run("third"), 1e9, kept);
  Table const wider{.file = "history.csv", .columns = {{"time", "min"}}};
  CHECK_THROWS_WITH(third.restore(clock, 300, {wider}), ContainsSubstring("its columns are time [min],sum"));
  CHECK_THROWS_WITH(third.restore(clock, 300, {}, "missing.vtkhdf"), ContainsSubstring("missing.vtkhdf"));
  std::filesystem::remove(output / "history.csv");
  CHECK_THROWS_WITH(third.restore(clock, 300, {history}), ContainsSubstring("cannot read it to continue the table"));
}

TEST_CASE("numbers that restore() would have left out are refused") {
  Minutes all;
  all.simulate("half", 3);
  Clock clock;
  Checkpoints checkpoints(all.run("rest"), 1e9, all.folder / "half" / "checkpoint.h5");
  checkpoints.restore(clock, 300, {history});
  auto const late = [&] {
    checkpoints.keep(
        "sums", [] { return std::vector<double>(); }, [](auto const&) {});
  };
  CHECK_THROWS_WITH(late(), ContainsSubstring("comes after restore()"));
}

TEST_CASE("a run that starts at the beginning takes nothing from a checkpoint") {
  Minutes all;
  Clock clock{.now = 7};
  Checkpoints checkpoints(all.run("out"), 1e9);
  CHECK_FALSE(checkpoints.restarts());
  checkpoints.restore(clock, 1, {history});
  CHECK(clock.now == 7);
}

}  // namespace scree::test::checkpoints_tests
