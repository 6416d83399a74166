// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "hdf5_file.hpp"
#include "series_step.hpp"

#include <sys/resource.h>
#include <unistd.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <fstream>
#include <stdexcept>

namespace scree::test::vtkhdf_tests {
// These tests check the rules of VTK's page "VTKHDF File Format" (version 2.0), each read back with the plain HDF5
// interface. tests/io/read_with_vtk.py does the same with VTK's own reader where VTK >= 9.3 is installed.

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
namespace hdf5 = scree::hdf5;

namespace {

using Counts = std::vector<std::int64_t>;
using Shape = std::vector<hsize_t>;

// Soft limit on the size of files this process may write, for as long as it lives.
struct FileSizeLimit {
  ::rlimit before{};
  explicit FileSizeLimit(std::uintmax_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before);
    ::rlimit const now{.rlim_cur = bytes, .rlim_max = before.rlim_max};
    // No REQUIRE: the front end of nvcc 13 does not come to an end on one in a constructor.
    if (::setrlimit(RLIMIT_FSIZE, &now) != 0) throw std::runtime_error("setrlimit failed");
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before); }
};

}  // namespace

TEST_CASE("tables of a VTKHDF series hold no times of the clock, so that equal series have equal bytes") {
  Folder const folder;
  VtkHdfSeries series(folder / "a.vtkhdf", {});
  Step{0, 3}.append_to(series);
  File const file(series.path());
  for (auto const* name : {"VTKHDF/Points", "VTKHDF/PointData/C", "VTKHDF/Steps/Values"}) {
    INFO(name);
    H5G_stat_t found{};
    REQUIRE(H5Gget_objinfo(file.id, name, true, &found) >= 0);
    CHECK(found.mtime == 0);
  }
}

TEST_CASE("a VTKHDF series keeps the rules of the format while the number of particles changes") {
  Folder const folder;
  std::vector<Step> const steps = {{0, 3}, {1, 3}, {2, 5}, {3, 2}, {4, 2}};
  VtkHdfSeries series(folder / "a.vtkhdf", {.provenance = {{"version", "1.2.3"}, {"case", "Größe"}, {"empty", ""}}});
  for (auto const& step : steps) {
    step.append_to(series);
    CHECK(File(series.path()).numbers("VTKHDF/Steps", "NSteps") == Counts{static_cast<std::int64_t>(series.steps())});
  }
  File const file(series.path());

  SECTION("head") {
    CHECK(file.numbers("VTKHDF", "Version") == Counts{2, 0});
    CHECK(file.text("VTKHDF", "Type") == "PolyData");
    hdf5::Handle const type{H5Aget_type(file.attribute("VTKHDF", "Type")), H5Tclose};
    CHECK(H5Tget_cset(type) == H5T_CSET_ASCII);
    CHECK(file.numbers("VTKHDF/Steps", "NSteps") == Counts{5});
    CHECK(file.text("scree", "version") == "1.2.3");
    CHECK(file.text("scree", "case") == "Größe");
  }
  SECTION("particles are one after another, step after step") {
    CHECK(file.shape("VTKHDF/Points") == Shape{15, 3});
    CHECK(file.read<double>("VTKHDF/Points") == joined(steps, &Step::xyz));
    CHECK(file.shape("VTKHDF/PointData/C") == Shape{15});
    CHECK(file.read<double>("VTKHDF/PointData/C") == joined(steps, &Step::c));
    CHECK(file.shape("VTKHDF/PointData/normal") == Shape{15, 3});
    CHECK(file.read<double>("VTKHDF/PointData/normal") == joined(steps, &Step::normal));
    CHECK(file.read<float>("VTKHDF/PointData/speed") == joined(steps, &Step::speed));
    CHECK(file.read<std::int32_t>("VTKHDF/PointData/surface set") == joined(steps, &Step::set));
    CHECK(file.stored_as("VTKHDF/Points", H5T_IEEE_F64LE));
    CHECK(file.stored_as("VTKHDF/PointData/speed", H5T_IEEE_F32LE));
    CHECK(file.stored_as("VTKHDF/PointData/surface set", H5T_STD_I32LE));
  }
  SECTION("one part for each run of equal n: 3, 5, 2") {
    CHECK(file.counts("NumberOfPoints") == Counts{3, 5, 2});
    CHECK(file.counts("Vertices/NumberOfCells") == Counts{3, 5, 2});
    CHECK(file.counts("Vertices/NumberOfConnectivityIds") == Counts{3, 5, 2});
    CHECK(file.counts("Vertices/Connectivity") == Counts{0, 1, 2, 0, 1, 2, 3, 4, 0, 1});
    CHECK(file.counts("Vertices/Offsets") == Counts{0, 1, 2, 3, 0, 1, 2, 3, 4, 5, 0, 1, 2});
    for (std::string const group : {"Lines", "Polygons", "Strips"}) {
      CHECK(file.counts(group + "/NumberOfCells") == Counts{0, 0, 0});
      CHECK(file.counts(group + "/NumberOfConnectivityIds") == Counts{0, 0, 0});
      CHECK(file.counts(group + "/Connectivity").empty());
      CHECK(file.counts(group + "/Offsets") == Counts{0, 0, 0});
    }
  }
  SECTION("steps") {
    CHECK(file.read<double>("VTKHDF/Steps/Values") == std::vector<double>{0, 0.5, 1, 1.5, 2});
    CHECK(file.counts("Steps/PartOffsets") == Counts{0, 0, 1, 2, 2});
    CHECK(file.counts("Steps/NumberOfParts") == Counts{1, 1, 1, 1, 1});
    CHECK(file.counts("Steps/PointOffsets") == Counts{0, 3, 6, 11, 13});
    Counts const cells = {0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0};
    for (std::string const name : {"Steps/CellOffsets", "Steps/ConnectivityIdOffsets"}) {
      CHECK(file.shape("VTKHDF/" + name) == Shape{5, 4});
      CHECK(file.counts(name) == cells);
    }
    for (std::string const name : {"C", "normal", "speed", "surface set"}) {
      CHECK(file.counts("Steps/PointDataOffsets/" + name) == Counts{0, 3, 6, 11, 13});
    }
  }
}

TEST_CASE("a VTKHDF series can be narrow, compressed, empty for a while, and long") {
  Folder const folder;
  VtkHdfSeries series(folder / "b.vtkhdf", {.single_precision = true, .deflate = 6});
  std::vector<Step> const steps = {{0, 0}, {1, 1000}, {2, 0}, {3, 70000}};
  for (auto const& step : steps) step.append_to(series);
  File const file(series.path());
  CHECK(file.stored_as("VTKHDF/Points", H5T_IEEE_F32LE));
  CHECK(file.stored_as("VTKHDF/PointData/C", H5T_IEEE_F32LE));
  CHECK(file.read<double>("VTKHDF/Points") == joined(steps, &Step::xyz));  // small integers and 0.5: exact as floats
  CHECK(file.read<double>("VTKHDF/PointData/C") == joined(steps, &Step::c));
  CHECK(file.counts("NumberOfPoints") == Counts{0, 1000, 0, 70000});
  CHECK(fs::file_size(series.path()) < 71000 * (12 + 4 + 12 + 4 + 4));  // without the vertices, uncompressed
}

TEST_CASE("reserved disk space is given back") {
  Folder const folder;
  VtkHdfSeries series(folder / "c.vtkhdf");
  for (int s = 0; s < 4; ++s) Step(s, 10).append_to(series);
  CHECK(fs::file_size(series.path()) < 200'000);  // less than one reservation
}

TEST_CASE("wrong arguments leave the series as it was") {
  Folder const folder;
  VtkHdfSeries series(folder / "d.vtkhdf");
  Step const good(0, 3);
  good.append_to(series);
  auto const refuses = [&](double time, std::vector<double> const& xyz, std::vector<PointField> const& fields,
                           std::string const& why) {
    CHECK_THROWS_MATCHES(series.append(time, xyz, fields), std::invalid_argument,
                         MessageMatches(ContainsSubstring(why)));
  };
  std::vector<double> const four(4), nine(9), one(1);
  refuses(std::nan(""), nine, good.fields(), "its time is nan");
  refuses(0, nine, good.fields(), "its time 0 is not after the last step's 0");
  refuses(1, four, good.fields(), "4 coordinates are not three for each particle");
  refuses(1, nine, {{.name = "C", .values = one}}, "field 'C' has 1 values instead of 3");
  refuses(1, nine, {{.name = "a/b", .values = one}}, "'a/b' is no name for a field");
  refuses(1, nine, {{.name = "a.b", .values = one}}, "'a.b' is no name for a field");
  refuses(1, nine, {{.name = "", .values = one}}, "'' is no name for a field");
  refuses(1, nine, {{.name = "C", .components = 0, .values = one}}, "field 'C' has 0 components");
  refuses(1, nine, {{.name = "C", .values = good.c}, {.name = "C", .values = good.c}}, "two fields are called 'C'");
  refuses(1, nine, {{.name = "C", .values = good.c}}, "its fields are not those of the first step");
  CHECK(series.steps() == 1);
  Step(1, 3).append_to(series);
  CHECK(File(series.path()).counts("Steps/PointOffsets") == Counts{0, 3});
}

TEST_CASE("a file that cannot be written is named with the cause") {
  Folder const folder;
  auto const fails = [](auto action, std::string const& message) {
    CHECK_THROWS_MATCHES(action(), std::runtime_error, MessageMatches(Catch::Matchers::Equals(message)));
  };
  auto const path = folder / "e.vtkhdf";

  SECTION("directory missing") {
    auto const there = folder.path / "missing" / "e.vtkhdf";
    fails([&] { VtkHdfSeries{there}; }, there.string() + ": cannot create it: No such file or directory");
  }
  SECTION("a file in place of the directory") {
    std::ofstream(folder / "plain") << "x";
    auto const there = folder.path / "plain" / "e.vtkhdf";
    fails([&] { VtkHdfSeries{there}; }, there.string() + ": cannot create it: Not a directory");
  }
  SECTION("a directory of that name") {
    fails([&] { VtkHdfSeries(folder.path, {.overwrite = true}); },
          folder.path.string() + ": cannot create it: it is not a regular file");
  }
  SECTION("file exists") {
    std::ofstream(path) << "precious";
    fails([&] { VtkHdfSeries{path}; },
          path.string() + ": cannot create it: it exists; remove it, or give the option overwrite");
    CHECK(fs::file_size(path) == 8);
    VtkHdfSeries series(path, {.overwrite = true});
    Step(0, 1).append_to(series);
    CHECK(File(path).numbers("VTKHDF/Steps", "NSteps") == Counts{1});
  }
  SECTION("a device of that name") {
    fails([&] { VtkHdfSeries("/dev/full", {.overwrite = true}); },
          "/dev/full: cannot create it: it is not a regular file");
  }
  SECTION("no room for the first byte") {
    FileSizeLimit const limit(1000);
    fails([&] { VtkHdfSeries{path}; }, path.string() + ": cannot create it: File too large");
    CHECK_FALSE(fs::exists(path));
    std::ofstream(path) << "precious";
    fails([&] { VtkHdfSeries(path, {.overwrite = true}); }, path.string() + ": cannot create it: File too large");
    CHECK(fs::file_size(path) == 8);
  }
  SECTION("no permission") {
    if (::geteuid() == 0) SKIP("root may write everywhere");
    fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
    fails([&] { VtkHdfSeries{path}; }, path.string() + ": cannot create it: Permission denied");
    fs::permissions(folder.path, fs::perms::owner_all);
  }
  SECTION("removed while the run goes on") {
    VtkHdfSeries series(path);
    fs::remove(path);
    fails([&] { Step(0, 1).append_to(series); },
          path.string() + ": cannot append step 0 (time 0): No such file or directory");
  }
  SECTION("damaged while the run goes on") {
    VtkHdfSeries series(path);
    std::ofstream(path) << "something else";
    CHECK_THROWS_MATCHES(
        Step(0, 1).append_to(series), std::runtime_error,
        MessageMatches(Catch::Matchers::StartsWith(path.string() + ": cannot append step 0 (time 0): ")));
  }
}

TEST_CASE("a step that does not fit on the disk leaves the steps before it readable") {
  Folder const folder;
  VtkHdfSeries series(folder / "f.vtkhdf");
  Step(0, 100).append_to(series);
  auto const size = fs::file_size(series.path());
  {
    FileSizeLimit const limit(size + 1000);
    CHECK_THROWS_MATCHES(Step(1, 20000).append_to(series), std::runtime_error,
                         MessageMatches(Catch::Matchers::Equals(series.path().string() +
                                                                ": cannot append step 1 (time 0.5): File too large")));
  }
  CHECK(fs::file_size(series.path()) == size);
  CHECK(File(series.path()).read<double>("VTKHDF/Points") == Step(0, 100).xyz);
  Step(1, 20000).append_to(series);  // there is room again
  CHECK(File(series.path()).read<double>("VTKHDF/PointData/C") == joined<double>({{0, 100}, {1, 20000}}, &Step::c));
}

TEST_CASE("provenance may be long") {
  Folder const folder;
  std::string const text(200'000, 'x');
  VtkHdfSeries series(folder / "long.vtkhdf", {.provenance = {{"case", text}, {"version", "1"}}});
  Step(0, 2).append_to(series);
  File const file(series.path());
  CHECK(file.text("scree", "version") == "1");
  hdf5::Handle const dataset = file.table("scree/case");
  CHECK(H5Dget_storage_size(dataset) == text.size());
}

// Hidden: run by name, then `python3 tests/io/read_with_vtk.py steps.vtkhdf` where VTK >= 9.3 is installed.
TEST_CASE("write steps.vtkhdf for read_with_vtk.py", "[.vtk]") {
  VtkHdfSeries series("steps.vtkhdf", {.overwrite = true, .deflate = 4});
  int const n[] = {3, 3, 5, 2, 2, 4000, 4000, 1};
  for (int s = 0; s < 8; ++s) Step(s, n[s]).append_to(series);
}

}  // namespace scree::test::vtkhdf_tests
