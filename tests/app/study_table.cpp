// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../../src/app/study_table.hpp"

#include <support/folder.hpp>

#include <scree/app/json.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::study_table_tests {
namespace {

using namespace scree::app;
using app::detail::numbers_of_json;
using app::detail::StudyTable;

StudyTable table_in(Folder const& folder) {
  StudyTable table(folder / "study.csv", 12, {"geometry.speed [rpm]", "case.name"});
  for (std::size_t k = 0; k < 12; ++k) table.set_values(k, {std::to_string(k), "\"a, b\""});
  return table;
}

}  // namespace

TEST_CASE("the numbers of a summary are found with their names") {
  auto const numbers = numbers_of_json(to_json({{"steps", 12},
                                                {"mean_C", 0.1 + 0.2},
                                                {"text", "12"},
                                                {"on", true},
                                                {"missing", std::nan("")},
                                                {"flow", Json::Object{{"mean", -1.5e-9}, {"none", Json::Object{}}}},
                                                {"rows", Json::Array{1, 2, Json::Object{{"z", 3}}, Json::Array{}}},
                                                {"zlast", 7}}));
  CHECK(numbers.size() == 5);
  CHECK(numbers.at("steps") == 12);
  CHECK(numbers.at("mean_C") == 0.1 + 0.2);
  CHECK(std::isnan(numbers.at("missing")));
  CHECK(numbers.at("flow.mean") == -1.5e-9);
  CHECK(numbers.at("zlast") == 7);
}

TEST_CASE("a file that is no summary has no numbers, and harms nothing") {
  for (auto const* text : {"", "{", "]\n]\n}\n", "\n\"a\" : {\n", "\n\" : \n", "\n\"a\" : 1e\n", "\n1\n", "\xff\n\xff"})
    CHECK(numbers_of_json(text).empty());
}

TEST_CASE("a study's table has its members in their order, with states, figures and messages") {
  Folder const folder;
  auto table = table_in(folder);
  CHECK(table.name_of(0) == "01");
  CHECK(table.name_of(11) == "12");
  folder.write("summary.json", to_json({{"steps", 3}}));
  table.set_end(1, "0\n\n", folder.path);
  table.set_end(2, "3\nerror: too \"fast\", it says\n", "nowhere");
  table.set_end(3, "143\n\n", "nowhere");
  table.set_end(4, "1\nerror\n", "nowhere");
  table.write();
  auto const text = content_of(folder / "study.csv");
  CHECK(
      text.starts_with("member,state,geometry.speed [rpm],case.name,steps,message\n"
                       "01,not begun,0,\"\"\"a, b\"\"\",,\n"
                       "02,finished,1,\"\"\"a, b\"\"\",3,\n"
                       "03,outside validity,2,\"\"\"a, b\"\"\",,\"error: too \"\"fast\"\", it says\"\n"
                       "04,stopped,3,\"\"\"a, b\"\"\",,\n"
                       "05,failed,4,\"\"\"a, b\"\"\",,error\n"));
  CHECK(table.counts() == "1 finished, 1 outside validity, 1 failed, 1 stopped, 8 not begun");
  CHECK(table.finished(1));
  CHECK(table.finished(2));
  CHECK_FALSE(table.finished(3));
  CHECK_FALSE(table.finished(0));
  CHECK(table.done() == 2);
  CHECK(table.values_of(1) == "geometry.speed = 1, case.name = \"a, b\"");
}

TEST_CASE("the exit code of a study is that of the member that went worst") {
  Folder const folder;
  StudyTable table(folder / "study.csv", 2, {});
  table.set_end(0, "0\n", folder.path);
  CHECK(table.exit_code() == 1);  // one has not begun
  table.set_end(1, "0\n", folder.path);
  CHECK(table.exit_code() == 0);
  table.set_end(1, "3\nleft\n", folder.path);
  CHECK(table.exit_code() == 3);
  table.set_end(0, "1\n", folder.path);
  CHECK(table.exit_code() == 1);
}

}  // namespace scree::test::study_table_tests
