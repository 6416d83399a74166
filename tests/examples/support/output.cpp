// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "folder.hpp"

#include <support/csv.hpp>
#include <support/json.hpp>

#include <catch2/catch_test_macros.hpp>

#include <limits>

using namespace support;
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
  CsvWriter csv(folder / "a.csv", {"t", "mean_C"});
  csv.row({1, 0.5});
  CHECK(content_of(folder / "a.csv") == "t,mean_C\n1,0.5\n");
  csv.row({1.0 / 3, 1e-300});
  CHECK(content_of(folder / "a.csv") == "t,mean_C\n1,0.5\n0.3333333333333333,1e-300\n");
  CHECK_THROWS_AS(csv.row({1, 2, 3}), std::logic_error);
}

TEST_CASE("a CSV file goes on with the rows of another") {
  Folder const folder;
  write_file(folder / "a.csv", "t,x\n0,1\n1,2\n2,3\n");
  CsvWriter csv(folder / "a.csv", {"t", "x"}, {{0, 1}, {1, 2}});
  CHECK(content_of(folder / "a.csv") == "t,x\n0,1\n1,2\n");
  csv.row({1.5, 7});
  CHECK(content_of(folder / "a.csv") == "t,x\n0,1\n1,2\n1.5,7\n");
  CHECK(files_in(folder.path) == 1);
  CHECK_THROWS_AS(CsvWriter(folder / "a.csv", {"t", "x"}, {{0, 1, 2}}), std::logic_error);
  CHECK(content_of(folder / "a.csv") == "t,x\n0,1\n1,2\n1.5,7\n");
}

TEST_CASE("a CSV file that cannot be written is named with the reason") {
  Folder const folder;
  auto const nowhere = folder / "none" / "a.csv";
  CHECK(message_of([&] { CsvWriter(nowhere, {"t"}); }) ==
        nowhere.string() + ": cannot write it: No such file or directory");
  fs::create_directory(folder / "a.csv");
  CHECK(message_of([&] { CsvWriter(folder / "a.csv", {"t"}); }) ==
        (folder / "a.csv").string() + ": cannot write it: Is a directory");
}

TEST_CASE("JSON keeps digits, escapes texts and nests") {
  auto const text = to_json({{"steps", 12},
                             {"mean_C", 0.1 + 0.2},
                             {"scheme", "a \"b\" \\c"},
                             {"clipped", false},
                             {"missing", std::numeric_limits<double>::quiet_NaN()},
                             {"compared", Json::Array{Json::Object{{"t", 20.0}, {"mae", 1e-12}}, 3}}});
  CHECK(text == R"({
    "clipped" : false,
    "compared" : [
        {
            "mae" : 9.9999999999999998e-13,
            "t" : 20.0
        },
        3
    ],
    "mean_C" : 0.30000000000000004,
    "missing" : "NaN",
    "scheme" : "a \"b\" \\c",
    "steps" : 12
}
)");
}
