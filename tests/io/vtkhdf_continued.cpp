// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "hdf5_file.hpp"
#include "series_step.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

namespace scree::test::vtkhdf_continued_tests {
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

std::vector<Step> steps_of(std::vector<int> const& sizes) {
  std::vector<Step> steps;
  for (int n : sizes) steps.emplace_back(static_cast<int>(steps.size()), n);
  return steps;
}
void append(VtkHdfSeries& series, std::vector<Step> const& steps, std::size_t from) {
  for (auto s = from; s < steps.size(); ++s) steps[s].append_to(series);
}

/// Whether two files hold the same steps, offsets included.
void check_same(fs::path const& found, fs::path const& expected) {
  File const a(found), b(expected);
  CHECK(a.numbers("VTKHDF/Steps", "NSteps") == b.numbers("VTKHDF/Steps", "NSteps"));
  for (auto const* name : {"Points", "PointData/C", "PointData/normal", "Steps/Values"})
    CHECK(a.read<double>(std::string("VTKHDF/") + name) == b.read<double>(std::string("VTKHDF/") + name));
  for (auto const* name : {"Steps/PartOffsets", "Steps/NumberOfParts", "Steps/PointOffsets", "Steps/CellOffsets",
                           "Steps/PointDataOffsets/C", "NumberOfPoints", "Vertices/Connectivity", "Vertices/Offsets"})
    CHECK(a.counts(name) == b.counts(name));
}

/// All numbers of all steps of a series of `n` particles.
void check_whole(fs::path const& path, int n) {
  File const file(path);
  auto const count = file.numbers("VTKHDF/Steps", "NSteps").at(0);
  auto const xyz = file.read<double>("VTKHDF/Points"), c = file.read<double>("VTKHDF/PointData/C");
  REQUIRE(c.size() == std::size_t(count * n));
  REQUIRE(file.read<double>("VTKHDF/Steps/Values").size() == std::size_t(count));
  bool right = true;
  for (std::int64_t s = 0; s < count; ++s) {
    Step const step(static_cast<int>(s), n);
    right = right && std::equal(step.xyz.begin(), step.xyz.end(), xyz.begin() + 3 * s * n) &&
            std::equal(step.c.begin(), step.c.end(), c.begin() + s * n);
  }
  CHECK(right);
}

}  // namespace

TEST_CASE("a continued series is that of a run without a break") {
  Folder const folder;
  auto const steps = steps_of({3, 3, 5, 5, 2, 2, 2});
  {
    VtkHdfSeries series(folder / "whole.vtkhdf");
    append(series, steps, 0);
  }
  for (std::size_t kept = 0; kept <= steps.size(); ++kept) {
    INFO(kept << " steps are kept");
    fs::copy_file(folder / "whole.vtkhdf", folder / "first.vtkhdf", fs::copy_options::overwrite_existing);
    // A checkpoint coincides with the last kept step, apart from rounding, or is later.
    double const last = kept == 0 ? -1 : steps[kept - 1].time;
    for (double const time : {last * (1 - 1e-15), last, last + 0.2})
      for (auto const* name : {"first.vtkhdf", "second.vtkhdf"}) {
        auto series = VtkHdfSeries::continued(folder / "first.vtkhdf", time, folder / name);
        CHECK(series.steps() == kept);
        CHECK(File(series.path()).numbers("VTKHDF/Steps", "NSteps") == std::vector{std::int64_t(kept)});
        CHECK(File(series.path()).shape("VTKHDF/Steps/Values") == std::vector{hsize_t(kept)});
        append(series, steps, kept);
        check_same(folder / name, folder / "whole.vtkhdf");
      }
  }
}

TEST_CASE("a series is continued with its own fields, from a file that is one") {
  Folder const folder;
  auto const path = folder / "a.vtkhdf";
  auto const steps = steps_of({3, 3});
  {
    VtkHdfSeries series(path);
    append(series, steps, 0);
  }
  auto series = VtkHdfSeries::continued(path, 1, path);
  std::vector<double> const one(3);
  CHECK_THROWS_MATCHES(series.append(2, std::vector<double>(9), {{.name = "C", .values = one}}), std::invalid_argument,
                       MessageMatches(ContainsSubstring("its fields are not those of the first step")));
  CHECK_THROWS_MATCHES(
      VtkHdfSeries::continued(folder / "none", 1, path), std::runtime_error,
      MessageMatches(Catch::Matchers::Equals(path.string() + ": cannot continue " + (folder / "none").string() +
                                             ": No such file or directory")));
  std::ofstream(folder / "text") << "no series";
  CHECK_THROWS(VtkHdfSeries::continued(folder / "text", 1, path));
  CHECK_THROWS(VtkHdfSeries::check(folder / "text"));
  CHECK_THROWS(VtkHdfSeries::check(folder / "none"));
  CHECK_NOTHROW(VtkHdfSeries::check(path));
  CHECK(File(path).numbers("VTKHDF/Steps", "NSteps") == std::vector<std::int64_t>{2});
}

TEST_CASE("a series leaves no second file, and replaces one of a killed program") {
  Folder const folder;
  std::ofstream(folder / "a.vtkhdf.part") << "of a killed program";
  {
    VtkHdfSeries series(folder / "a.vtkhdf");
    Step(0, 3).append_to(series);
    CHECK(fs::exists(folder / "a.vtkhdf.part"));
    Step(1, 3).append_to(series);
  }
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
  check_whole(folder / "a.vtkhdf", 3);
}

TEST_CASE("a series is whole after a kill at any moment") {
  constexpr int n = 300, kills = 60;
  Folder const folder;
  auto const path = folder / "a.vtkhdf";
  std::int64_t steps = 0;
  for (int k = 0; k < kills; ++k) {
    int begun[2];
    REQUIRE(::pipe(begun) == 0);
    ::pid_t const child = ::fork();
    if (child == 0) {
      try {
        VtkHdfSeries series(path, {.overwrite = true});
        Step(0, n).append_to(series);
        if (::write(begun[1], "x", 1) != 1) std::_Exit(2);
        for (int s = 1;; ++s) Step(s, n).append_to(series);
      } catch (std::exception const&) {
        std::_Exit(1);
      }
    }
    ::close(begun[1]);
    char byte;
    REQUIRE(::read(begun[0], &byte, 1) == 1);  // the first step is there, however busy the machine is
    ::close(begun[0]);
    std::this_thread::sleep_for(std::chrono::microseconds(1237 * k));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFSIGNALED(status));
    check_whole(path, n);
    steps += File(path).numbers("VTKHDF/Steps", "NSteps").at(0);
  }
  CHECK(steps > kills);  // they were at work
}

}  // namespace scree::test::vtkhdf_continued_tests
