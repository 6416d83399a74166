// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/csv_series.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::csv_series_tests {
using namespace scree;
namespace fs = std::filesystem;

namespace {

template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (std::runtime_error const& error) {
    return error.what();
  }
  return "";
}

std::size_t files_in(fs::path const& directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("write_file replaces a file in one step and leaves nothing else") {
  Folder const folder;
  write_file(folder / "a.txt", "first");
  CHECK(content_of(folder / "a.txt") == "first");
  write_file(folder / "a.txt", "second");
  CHECK(content_of(folder / "a.txt") == "second");
  CHECK(files_in(folder.path) == 1);

  auto const nowhere = folder / "none" / "a.txt";
  CHECK(message_of([&] { write_file(nowhere, "x"); }) ==
        nowhere.string() + ": cannot write it: No such file or directory");
  fs::create_directory(folder / "b");
  CHECK(message_of([&] { write_file(folder / "b", "x"); }) ==
        (folder / "b").string() + ": cannot write it: Is a directory");
  CHECK(files_in(folder.path) == 2);
}

TEST_CASE("a CSV file has a head, all digits, and is complete after each row") {
  Folder const folder;
  CsvSeries csv(folder / "a.csv", {"t", "mean_C"});
  csv.row({1, 0.5});
  CHECK(content_of(folder / "a.csv") == "t,mean_C\n1,0.5\n");
  csv.row({1.0 / 3, 1e-300});
  CHECK(content_of(folder / "a.csv") == "t,mean_C\n1,0.5\n0.3333333333333333,1e-300\n");
  CHECK_THROWS_AS(csv.row({1, 2, 3}), std::logic_error);
}

TEST_CASE("a CSV file goes on with the rows of another") {
  Folder const folder;
  write_file(folder / "a.csv", "t,x\n0,1\n1,2\n2,3\n");
  CsvSeries csv(folder / "a.csv", {"t", "x"}, {{0, 1}, {1, 2}});
  CHECK(content_of(folder / "a.csv") == "t,x\n0,1\n1,2\n");
  csv.row({1.5, 7});
  CHECK(content_of(folder / "a.csv") == "t,x\n0,1\n1,2\n1.5,7\n");
  CHECK(files_in(folder.path) == 1);
  CHECK_THROWS_AS(CsvSeries(folder / "a.csv", {"t", "x"}, {{0, 1, 2}}), std::logic_error);
  CHECK(content_of(folder / "a.csv") == "t,x\n0,1\n1,2\n1.5,7\n");
}

TEST_CASE("a CSV file that cannot be written is named with the reason") {
  Folder const folder;
  auto const nowhere = folder / "none" / "a.csv";
  CHECK(message_of([&] { CsvSeries(nowhere, {"t"}); }) ==
        nowhere.string() + ": cannot write it: No such file or directory");
  fs::create_directory(folder / "a.csv");
  CHECK(message_of([&] { CsvSeries(folder / "a.csv", {"t"}); }) ==
        (folder / "a.csv").string() + ": cannot write it: Is a directory");
}

TEST_CASE("the header of a CSV file has the unit of each number that has one") {
  Folder const folder;
  CsvSeries const csv(folder / "a.csv", {{"time", "s"}, {"mean C"}, {std::string("force"), std::string("N/m")}, "n"});
  CHECK(content_of(csv.path()) == "time [s],mean C,force [N/m],n\n");
  CsvSeries const one(folder / "b.csv", {{"time", "s"}});
  CHECK(content_of(one.path()) == "time [s]\n");
}

TEST_CASE("a column that would break the header of a CSV file is refused before the file exists") {
  Folder const folder;
  for (CsvColumn const& bad : {CsvColumn{""}, {"", "s"}, {"a,b"}, {"a", "m,s"}, {"a\n"}, {"\"a\""}})
    CHECK_THROWS_AS(CsvSeries(folder / "a.csv", {{"time", "s"}, bad}), std::invalid_argument);
  CHECK(files_in(folder.path) == 0);
}

TEST_CASE("a table is continued from the rows up to a time, with the same digits") {
  Folder const folder;
  std::vector<CsvColumn> const columns = {{"time", "s"}, "x"};
  auto const file =
      folder.write("a.csv", "time [s],x\n0,nan\n0.1,1e-300\n0.30000000000000004,-0.3333333333333333\n1,2\n");
  auto csv = CsvSeries::continued(file, 0.3, folder / "b.csv", columns);
  csv.row({0.4, 7});
  auto const kept = "time [s],x\n0,nan\n0.1,1e-300\n0.30000000000000004,-0.3333333333333333\n";
  CHECK(content_of(folder / "b.csv") == kept + std::string("0.4,7\n"));
  CsvSeries::continued(file, 0.3, file, columns);
  CHECK(content_of(file) == kept);
}

TEST_CASE("a table of an earlier version goes on with new columns behind its own") {
  Folder const folder;
  std::vector<CsvColumn> const columns = {{"time", "s"}, "x", "y", {"z", "m"}};
  auto const file = folder.write("a.csv", "time [s],x\n0,3\n0.1,4\n0.2,5\n0.3");
  auto csv = CsvSeries::continued(file, 0.1, folder / "b.csv", columns);
  csv.row({0.2, 1, 2, 3});
  CHECK(content_of(folder / "b.csv") == "time [s],x,y,z [m]\n0,3,nan,nan\n0.1,4,nan,nan\n0.2,1,2,3\n");
  CHECK_NOTHROW(CsvSeries::check(file, columns));
  for (char const* head : {"x", "time [s],y", "time [s],x,y,z [m],w", "time [s],x,", "time"})
    CHECK_THROWS_AS(CsvSeries::check(folder.write("c.csv", std::string(head) + "\n0,3\n"), columns),
                    std::runtime_error);
}

TEST_CASE("a row that a crash has cut off is dropped when a table is continued") {
  Folder const folder;
  std::vector<CsvColumn> const columns = {{"time", "s"}, "x"};
  for (auto const* cut : {"1", "1,", "1,2", "1,2\n2", "\n1"}) {
    auto const file = folder.write("a.csv", std::string("time [s],x\n0,1\n") + cut);
    CsvSeries::continued(file, 10, folder / "b.csv", columns);
    CHECK(content_of(folder / "b.csv").substr(0, 15) == "time [s],x\n0,1\n");
    CHECK(content_of(folder / "b.csv").size() == (std::string(cut) == "1,2\n2" ? 19 : 15));
  }
}

TEST_CASE("a table with other columns is not continued") {
  Folder const folder;
  auto const file = folder.write("a.csv", "time [s],x [m]\n0,1\n");
  CHECK(message_of([&] {
          CsvSeries::continued(file, 1, file, {{"time", "s"}, "x"});
        }) == file.string() + ": its columns are time [s],x [m], not time [s],x");
  CHECK(message_of([&] { CsvSeries::continued(folder / "no.csv", 1, file, {"x"}); }) ==
        (folder / "no.csv").string() + ": cannot read it to continue the table");
  CHECK(content_of(file) == "time [s],x [m]\n0,1\n");
}

}  // namespace scree::test::csv_series_tests
