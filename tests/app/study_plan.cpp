// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shape.hpp"

#include <scree/app/describe.hpp>
#include <scree/app/study_plan.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::study_plan_tests {
namespace {

using namespace shape;

/// The members of a study as "length corners".
std::vector<std::string> members(StudyPlan const& plan) {
  std::vector<std::string> found;
  for (std::size_t k = 0; k < plan.members(); ++k) {
    Options options;
    auto const all = schema();
    auto const sections = plan.sections_of(k);
    scree::app::detail::read_case({all.list(), &options, &all.standard()}, "", {}, sections);
    found.push_back(fmt::format("{} {}", options.shape.length, options.shape.corners));
  }
  return found;
}
std::vector<std::string> members(std::string const& text, std::vector<std::string> const& vary = {}) {
  Folder const folder;
  return members(read_study(folder.write("study.toml", text), vary));
}
std::string problems(std::string const& text, std::vector<std::string> const& vary = {}) {
  Folder const folder;
  auto const file = folder.write("study.toml", text);
  try {
    members(read_study(file, vary));
  } catch (CaseError const& error) {
    std::string what = error.what();
    for (auto at = what.find(file.string()); at != std::string::npos; at = what.find(file.string()))
      what.replace(at, file.string().size(), "F");
    return what;
  }
  return "";
}
using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("a study has all combinations of its lists, the last one changes fastest") {
  CHECK(members("[shape]\nlength = [1, 2.5]\ncorners = [3, 4, 5]\n") ==
        Texts{"1 3", "1 4", "1 5", "2.5 3", "2.5 4", "2.5 5"});
  CHECK(members("[shape]\ncorners = [7]\n") == Texts{"0.25 7"});
}

TEST_CASE("a study by rows takes the values of its lists together") {
  CHECK(members("[study]\ncombine = \"rows\"\n[shape]\nlength = [1, 2]\ncorners = [3, 4]\n") == Texts{"1 3", "2 4"});
  CHECK(members("[study]\ncombine = \"all\"\n[shape]\nlength = [1]\ncorners = [3]\n") == Texts{"1 3"});
}

TEST_CASE("lists of the command line make a study, or replace those of its file") {
  CHECK(members(read_study("", Texts{"shape.length=[1, 2]", "shape.corners=[5]"})) == Texts{"1 5", "2 5"});
  CHECK(members("[shape]\nlength = [1, 2]\ncorners = [3]\n", {"shape.length=[4]"}) == Texts{"4 3"});
}

TEST_CASE("a study varies options of any type") {
  Folder const folder;
  auto const plan = read_study(folder.write("study.toml", "[paint]\nlayers = [[1], [2, 3]]\nmaker = [\"a, b\"]\n"));
  REQUIRE(plan.members() == 2);
  Options options;
  auto const all = schema();
  scree::app::detail::read_case({all.list(), &options, &all.standard()}, "", {}, plan.sections_of(1));
  CHECK(options.paint.layers == std::vector<double>{2, 3});
  CHECK(options.paint.maker == "a, b");
}

TEST_CASE("mistakes in a study are named with their place") {
  CHECK(problems("[shape]\nlenght = [1]\n") ==
        "F:2:11: shape.lenght: unknown key, did you mean 'shape.length'?; allowed: length, corners, colour, angle");
  CHECK(problems("[shape]\nlength = [1, 20]\n").starts_with("F:2:14: shape.length: 20 is out of range"));
  CHECK(problems("[shape]\nlength = 1\n") == "F:2:10: shape.length: a study needs a list of its values, [value, ...]");
  CHECK(problems("[shape]\nlength = []\n") == "F:2:10: shape.length: the list of its values is empty");
  CHECK(problems("length = [1]\n").starts_with("F:1:1: length: a value where the section [length] is expected"));
  CHECK(problems("[study]\ncombine = \"some\"\n").starts_with("F:2:11: study.combine: allowed"));
  CHECK(problems("[study]\nmode = \"rows\"\n") == "F:2:1: study.mode: unknown key; allowed: combine");
  CHECK(problems("[study]\ncombine = \"rows\"\n[shape]\nlength = [1, 2]\ncorners = [3]\n")
            .starts_with("F:5:1: shape.corners: 1 values, but shape.length has 2"));
  CHECK(problems("") == "--study: no option has a list of values");
  CHECK(problems("[shape", {}).starts_with("F:1:"));
  CHECK(problems("", {"shape.length=1"}) == "--vary: shape.length: a study needs a list of its values, [value, ...]");
  CHECK(problems("", {"length"}) == "--vary: 'length' is not of the form section.key=value");
  CHECK(problems("", {"shape.length=[11]"}).starts_with("--vary: shape.length: 11 is out of range"));
}

TEST_CASE("a study that cannot be counted is refused") {
  std::string list = "[1";
  for (int k = 0; k < 999; ++k) list += ", 1";
  CHECK(problems("[shape]\nlength = " + list + "]\ncorners = " + list + "]\n").find("1e+06 members, at most 100000") !=
        std::string::npos);
}

TEST_CASE("numbers too large and long keys of a study are refused as those of a case") {
  CHECK(problems("[shape]\nlength = [1, 1e400]\n") ==
        "F:2:14: shape.length: 1e400 is out of range, as all numbers beyond 1.8e+308; allowed: a number in (0, 10] m");
  CHECK(problems("", {"shape.length=[1e400]"}) ==
        "--vary: shape.length: 1e400 is out of range, as all numbers beyond 1.8e+308; allowed: a number in (0, 10] m");
  std::string key;
  while (key.size() < 4000) key += "k k";
  for (auto const& text : {"['" + key + "']\na = 1\n", "[study]\n'" + key + "' = 1\n", "[shape]\n'" + key + "' = []\n",
                           "'" + key + "' = 1\n"})
    CHECK(problems(text).size() < 400);
}

}  // namespace scree::test::study_plan_tests
