// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shape.hpp"

#include <scree/app/describe.hpp>
#include <scree/app/text.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::describe_tests {
using namespace shape;

TEST_CASE("the options in force are written as a case file that reads back to them") {
  auto options = read("[shape]\nlength = 0.1\ncolour = 'dark-blue'\n[paint]\nmaker = 'a \"b\" \\c'\n").options;
  auto const text = case_text(schema(), options);
  CHECK(text == R"(# Its form
[shape]
# of an edge; a number in (0, 10] m
length = 0.1
# how many; an integer in [3, 12]
corners = 4
# of its face; "red", "dark-blue"
colour = "dark-blue"
# of the first edge; a number in [-1, 1] rad
# angle =   # not given: by corners

# Its coat
[paint]
# it shines; true or false
glossy = true
# who made it; a text in quotes
maker = "a \"b\" \\c"
# thickness of each layer; an array of numbers, each in [0, 9] mm
layers = [1, 2.5]
)");
  CHECK(case_text(schema(), read(text).options) == text);
  options.shape.angle = 0.1 + 0.2;  // 17 digits
  options.paint.maker = "tab\tnewline\n";
  auto const again = read(case_text(schema(), options)).options;
  CHECK(again.shape.angle == options.shape.angle);
  CHECK(again.paint.maker == options.paint.maker);
}

TEST_CASE("the table lists every option") {
  auto const table = option_table(schema());
  CHECK(table ==
        R"(| key           | unit | default    | allowed                             | meaning                 |
| ------------- | ---- | ---------- | ----------------------------------- | ----------------------- |
| shape.length  | m    | 0.25       | a number in (0, 10]                 | of an edge              |
| shape.corners | 1    | 4          | an integer in [3, 12]               | how many                |
| shape.colour  | 1    | "red"      | "red", "dark-blue"                  | of its face             |
| shape.angle   | rad  | by corners | a number in [-1, 1]                 | of the first edge       |
| paint.glossy  | 1    | true       | true or false                       | it shines               |
| paint.maker   | 1    | "nobody"   | a text in quotes                    | who made it             |
| paint.layers  | mm   | [1, 2.5]   | an array of numbers, each in [0, 9] | thickness of each layer |
)");
}

TEST_CASE("the nearest name is found by edits and swaps, and not at any price") {
  std::vector<std::string> const names = {"spacing", "scheme", "seed"};
  CHECK(nearest("spacng", names) == "spacing");
  CHECK(nearest("shceme", names) == "scheme");
  CHECK(nearest("sed", names) == "seed");
  CHECK(nearest("flux", names).empty());
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("ca", "ac") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

}  // namespace scree::test::describe_tests
