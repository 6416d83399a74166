// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shape.hpp"

#include <catch2/catch_test_macros.hpp>

namespace scree::test::case_file_tests {
using namespace shape;

namespace {

// The error lines for a case text and overrides, without the folder's path in the file name.
std::vector<std::string> errors(std::string const& text, std::vector<std::string> const& overrides = {}) {
  Folder const folder;
  auto const file = folder.write("case.toml", text);
  try {
    read_case(schema(), file, overrides);
  } catch (CaseError const& error) {
    auto lines = error.lines;
    for (auto& line : lines) {
      if (line.starts_with(folder.path.string())) line.erase(0, folder.path.string().size() + 1);
    }
    return lines;
  }
  return {};
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("a case file changes the options it names and no other") {
  auto const options = read(R"(
[shape]
length = 3            # an integer where a number is expected
colour = "dark-blue"
[paint]
glossy = false
layers = [1, 2.5, 9]
)")
                           .options;
  CHECK(options.shape.length == 3);
  CHECK(options.shape.colour == Colour::dark_blue);
  CHECK(options.shape.corners == 4);
  CHECK_FALSE(options.shape.angle.has_value());
  CHECK_FALSE(options.paint.glossy);
  CHECK(options.paint.maker == "nobody");
  CHECK(options.paint.layers == std::vector<double>{1, 2.5, 9});
  CHECK(read("").options.shape.length == 0.25);
  CHECK(read("shape.length = 2\npaint = { maker = 'me' }\r\n").options.paint.maker == "me");  // TOML's other spellings
  CHECK(read_case(schema(), "").options.shape.corners == 4);
}

TEST_CASE("unknown names are reported at their place with the name that was probably meant") {
  CHECK(errors("[shape]\nlenght = 1\n") ==
        Lines{"case.toml:2:1: shape.lenght: unknown key, did you mean 'shape.length'?; "
              "allowed: length, corners, colour, angle"});
  CHECK(errors("[shape]\n  glossy = true\n") ==
        Lines{"case.toml:2:3: shape.glossy: unknown key, did you mean 'paint.glossy'?; "
              "allowed: length, corners, colour, angle"});
  CHECK(errors("[shape]\nzzzzzz = 1\n") ==
        Lines{"case.toml:2:1: shape.zzzzzz: unknown key; allowed: length, corners, colour, angle"});
  CHECK(errors("\n[shpae]\nlength = 1\n") ==
        Lines{"case.toml:2:2: shpae: unknown section, did you mean 'shape'?; allowed: shape, paint"});
  CHECK(errors("[weather]\n") == Lines{"case.toml:1:2: weather: unknown section; allowed: shape, paint"});
  CHECK(errors("corners = 5\n") ==
        Lines{"case.toml:1:1: corners: a key outside of the sections, did you mean 'shape.corners'?; "
              "allowed: shape, paint"});
  CHECK(errors("paint = 5\n") == Lines{"case.toml:1:1: paint: a value where the section [paint] is expected"});
  CHECK(errors("[[paint]]\nglossy = true\n") ==
        Lines{"case.toml:1:3: paint: a value where the section [paint] is expected"});
}

TEST_CASE("wrong types are reported where the value stands") {
  CHECK(errors("[shape]\nlength = \"long\"\n") ==
        Lines{"case.toml:2:10: shape.length: a text where a number is expected; allowed: a number in (0, 10] m"});
  CHECK(errors("[shape]\ncorners =   4.0\n") ==
        Lines{"case.toml:2:13: shape.corners: a number where an integer is expected; allowed: an integer in [3, 12]"});
  CHECK(errors("[shape]\ncolour = 3\n") == Lines{"case.toml:2:10: shape.colour: an integer where a name in quotes is "
                                                 "expected; allowed: \"red\", \"dark-blue\""});
  CHECK(errors("[paint]\nglossy = 1\n") ==
        Lines{"case.toml:2:10: paint.glossy: an integer where true or false is expected; allowed: true or false"});
  CHECK(
      errors("[paint]\nmaker = true\n") ==
      Lines{"case.toml:2:9: paint.maker: true or false where a text in quotes is expected; allowed: a text in quotes"});
  CHECK(errors("[paint]\nlayers = 1\n") ==
        Lines{"case.toml:2:10: paint.layers: an integer where an array of numbers is expected; "
              "allowed: an array of numbers, each in [0, 9] mm"});
  CHECK(errors("[paint]\nlayers = [1,\n  'two']\n") ==
        Lines{"case.toml:3:3: paint.layers: a text where a number is expected; allowed: an array of numbers, each in "
              "[0, 9] mm"});
  CHECK(
      errors("[shape]\nlength = 2024-01-01\n") ==
      Lines{"case.toml:2:10: shape.length: a date or time where a number is expected; allowed: a number in (0, 10] m"});
  CHECK(errors("[shape.length]\nx = 1\n") ==
        Lines{"case.toml:1:1: shape.length: a table where a number is expected; allowed: a number in (0, 10] m"});
}

TEST_CASE("numbers out of range and names out of the list are reported with what is allowed") {
  CHECK(errors("[shape]\nlength = 0\n") ==
        Lines{"case.toml:2:10: shape.length: 0 is out of range; allowed: a number in (0, 10] m"});
  CHECK(errors("[shape]\nlength = 10.5\n") ==
        Lines{"case.toml:2:10: shape.length: 10.5 is out of range; allowed: a number in (0, 10] m"});
  CHECK(errors("[shape]\nlength = nan\n") ==
        Lines{"case.toml:2:10: shape.length: nan is not a finite number; allowed: a number in (0, 10] m"});
  CHECK(errors("[shape]\nlength = -inf\n") ==
        Lines{"case.toml:2:10: shape.length: -inf is not a finite number; allowed: a number in (0, 10] m"});
  CHECK(errors("[shape]\ncorners = 2\n") ==
        Lines{"case.toml:2:11: shape.corners: 2 is out of range; allowed: an integer in [3, 12]"});
  CHECK(errors("[shape]\ncorners = 4294967300\n") ==  // 4 + 2^32
        Lines{"case.toml:2:11: shape.corners: 4294967300 is out of range; allowed: an integer in [3, 12]"});
  CHECK(errors("[shape]\nangle = 2\n") ==
        Lines{"case.toml:2:9: shape.angle: 2 is out of range; allowed: a number in [-1, 1] rad"});
  CHECK(errors("[paint]\nlayers = [1, 2, -3]\n") ==
        Lines{"case.toml:2:17: paint.layers: -3 is out of range; allowed: an array of numbers, each in [0, 9] mm"});
  CHECK(errors("[shape]\ncolour = \"dark_blue\"\n") ==
        Lines{"case.toml:2:10: shape.colour: unknown name \"dark_blue\", did you mean \"dark-blue\"?; "
              "allowed: \"red\", \"dark-blue\""});
  CHECK(read("[shape]\nlength = 10\ncorners = 12\nangle = -1\n").options.shape.angle == -1.0);  // ends belong to it
}

TEST_CASE("numbers too large for any type are refused at their place like others out of range") {
  auto const integer = "99999999999999999999 is out of range, as all integers beyond 9223372036854775807; allowed: ";
  auto const number = [](std::string const& written) {
    return written + " is out of range, as all numbers beyond 1.8e+308; ";
  };
  std::string const length = "allowed: a number in (0, 10] m";
  CHECK(errors("[shape]\nlength = 1e400\n") == Lines{"case.toml:2:10: shape.length: " + number("1e400") + length});
  CHECK(errors("[shape]\r\nlength = -1_0.5e+400  # x\r\n") ==
        Lines{"case.toml:2:10: shape.length: " + number("-1_0.5e+400") + length});
  CHECK(errors("shape = { colour = \"é\", length = 1e400, corners = 99999999999999999999 }\n") ==
        Lines{"case.toml:1:20: shape.colour: unknown name \"é\"; allowed: \"red\", \"dark-blue\"",
              "case.toml:1:34: shape.length: " + number("1e400") + length,
              "case.toml:1:51: shape.corners: " + (integer + std::string("an integer in [3, 12]"))});
  CHECK(errors("[shape]\nlength = 99999999999999999999") ==
        Lines{"case.toml:2:10: shape.length: " + (integer + length.substr(9))});
  CHECK(errors("[shape]\nlength = 0x8000000000000000\n").at(0).find("0x8000000000000000 is out of range") !=
        std::string::npos);
  CHECK(errors("[paint]\nlayers = [1,\n  1e999]\nmaker = 1e400\n") ==
        Lines{"case.toml:3:3: paint.layers: " + number("1e999") + "allowed: an array of numbers, each in [0, 9] mm",
              "case.toml:4:9: paint.maker: a number where a text in quotes is expected; allowed: a text in quotes"});
  CHECK(errors("", {"shape.length=1e400"}) == Lines{"--set: shape.length: " + number("1e400") + length});
  CHECK(errors("", {"shape.corners=1e400"}) ==
        Lines{"--set: shape.corners: " + number("1e400") + "allowed: an integer in [3, 12]"});
  CHECK(read("[paint]\nmaker = \"1e400\"\n").options.paint.maker == "1e400");
  CHECK(read("", {"paint.maker=1e400x"}).options.paint.maker == "1e400x");
}

TEST_CASE("keys, names and numbers of thousands of characters are shortened in messages") {
  for (std::string const letter : {"k", "k ", "\\u00e4", "."}) {
    std::string word;
    for (int k = 0; k < 4000; ++k) word += letter;
    auto const key = "\"" + word + "\"";
    for (auto const& text : {"[shape]\n" + key + " = 1\n", "[" + key + "]\n", "[shape]\ncolour = " + key + "\n",
                             key + " = 1\n", "[shape]\nlength = " + word + "\n", "[shape]\n" + word + "\n"})
      for (auto const& line : errors(text)) CHECK(line.size() < 500);
    for (auto const& text : {"shape." + word + "=1", word + "=1", word, "shape.colour=" + word})
      for (auto const& line : errors("", {text})) CHECK(line.size() < 500);
  }
  auto const huge = "1" + std::string(4000, '0') + ".5";
  CHECK(errors("[shape]\nlength = " + huge + "\n").at(0).size() < 300);
  CHECK(errors("[shape]\n" + std::string(4000, 'k') + " = 1\n").at(0) ==
        "case.toml:2:1: shape." + std::string(39, 'k') + "..." + std::string(38, 'k') +
            ": unknown key; allowed: length, corners, colour, angle");
}

TEST_CASE("what is not TOML is reported with line and column, duplicates included") {
  CHECK(errors("[shape]\nlength = 1\nlength = 2\n") ==
        Lines{"case.toml:3:10: Error while parsing key-value pair: cannot redefine existing integer 'length'"});
  CHECK(errors("[shape]\nlength = 1\n[shape]\ncorners = 3\n") ==
        Lines{"case.toml:3:1: Error while parsing table header: cannot redefine existing table 'shape'"});
  CHECK(errors("[shape]\nlength = \n") ==
        Lines{"case.toml:2:10: Error while parsing key-value pair: expected value, saw '\\n'"});
  CHECK(errors("[shape\n") == Lines{"case.toml:1:7: Error while parsing table header: expected ']', saw '\\n'"});
  CHECK(errors("[shape]\nmaker = \"a\n") ==
        Lines{"case.toml:2:11: Error while parsing string: unescaped control characters other than TAB (U+0009) are "
              "explicitly prohibited"});
}

TEST_CASE("keys of very many parts are refused") {
  auto const deep = [](std::size_t parts) {
    std::string key = "a";
    while (--parts > 0) key += ".a";
    return key;
  };
  auto const refused = "case.toml:2:1: a key of more than 100 parts";
  CHECK(errors("\n[" + deep(100'000) + "]\n") == Lines{refused});
  CHECK(errors("\n  [[" + deep(100'000) + "]]\n") == Lines{refused});
  CHECK(errors("\n" + deep(100'000) + " = 1\n") == Lines{refused});
  CHECK(errors("[paint]\nlayers = [" + deep(101) + "]").at(0).find("parts") == std::string::npos);
  std::string numbers = "[paint]\nlayers = [0.5";
  for (int k = 0; k < 200; ++k) numbers += ", 0.5";
  CHECK(errors(numbers + "]\n").empty());
}

TEST_CASE("a file that cannot be read is named") {
  Folder const folder;
  auto const message = [](std::filesystem::path const& file) {
    try {
      read_case(schema(), file);
    } catch (CaseError const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message(folder / "none.toml") ==
        (folder / "none.toml").string() + ": cannot be read: No such file or directory");
  CHECK(message(folder.path) == folder.path.string() + ": cannot be read: Is a directory");
  CHECK(message("/dev/zero") == "/dev/zero: cannot be read: File too large");  // it has no end
}

TEST_CASE("all errors are reported together, in the order of the file") {
  CHECK(errors("[paint]\nglossy = 0\n[shape]\nlength = -1\ncolor = 'red'\n", {"shape.corners=1"}) ==
        Lines{"--set: shape.corners: 1 is out of range; allowed: an integer in [3, 12]",
              "case.toml:2:10: paint.glossy: an integer where true or false is expected; allowed: true or false",
              "case.toml:4:10: shape.length: -1 is out of range; allowed: a number in (0, 10] m",
              "case.toml:5:1: shape.color: unknown key, did you mean 'shape.colour'?; allowed: length, corners, "
              "colour, angle"});
}

TEST_CASE("a setting of the command line goes over the file and is checked like it") {
  auto const file = "[shape]\nlength = 3\n";
  auto const found = read(file, {"shape.length=2e0", "shape.colour=dark-blue", "paint.maker=\"a = b\"",
                                 " paint.layers = [3, 4] ", "paint.glossy=false"});
  CHECK(found.options.shape.length == 2);
  CHECK(found.options.shape.colour == Colour::dark_blue);
  CHECK(found.options.paint.maker == "a = b");
  CHECK(found.options.paint.layers == std::vector<double>{3, 4});
  CHECK_FALSE(found.options.paint.glossy);
  CHECK(found.notes.empty());

  CHECK(errors(file, {"shape.length=long"}) ==
        Lines{"--set: shape.length: a text where a number is expected; allowed: a number in (0, 10] m"});
  CHECK(errors(file, {"shape.length="}) ==
        Lines{"--set: shape.length: a text where a number is expected; allowed: a number in (0, 10] m"});
  CHECK(errors(file, {"shape.length=1\nshape.corners=5"}) ==
        Lines{"--set: shape.length: a text where a number is expected; allowed: a number in (0, 10] m"});
  CHECK(errors(file, {"shape.length=nan"}) ==
        Lines{"--set: shape.length: nan is not a finite number; allowed: a number in (0, 10] m"});
  CHECK(errors(file, {"paint.layers=[1,-1]"}) ==
        Lines{"--set: paint.layers: -1 is out of range; allowed: an array of numbers, each in [0, 9] mm"});
  CHECK(
      errors(file, {"shape.lengthh=1"}) ==
      Lines{
          "--set: shape.lengthh: unknown key, did you mean 'shape.length'?; allowed: length, corners, colour, angle"});
  CHECK(errors(file, {"shaep.length=1"}) ==
        Lines{"--set: shaep: unknown section, did you mean 'shape'?; allowed: shape, paint"});
  CHECK(errors(file, {"shape.length"}) == Lines{"--set: 'shape.length' is not of the form section.key=value"});
  CHECK(errors(file, {"length=2"}) == Lines{"--set: 'length=2' is not of the form section.key=value"});
  CHECK(errors(file, {""}) == Lines{"--set: '' is not of the form section.key=value"});

  auto const twice = read(file, {"shape.length=1", "shape.length=2"});
  CHECK(twice.options.shape.length == 2);
  CHECK(twice.notes == Lines{"--set: shape.length: given more than once, the last one counts"});
}

TEST_CASE("conditions between options are checked, settings without effect are noted") {
  CHECK(errors("[paint]\nlayers = []\n") == Lines{"case.toml:2:1: paint.layers: there must be one"});
  CHECK(read("[shape]\nangle = 1\n").notes.empty());
  CHECK(read("[shape]\ncorners = 3\n").notes.empty());
  CHECK(read("[shape]\ncorners = 3\n", {"shape.angle=1"}).notes ==
        Lines{"--set: shape.angle: has no effect on triangles"});
}

TEST_CASE("an option is read under the key of an earlier version, which the user is told") {
  auto all = schema();
  all.rename("shape.sides", "shape.corners");
  Folder const folder;
  auto const file = folder.write("case.toml", "[shape]\nsides = 5\n");
  auto const found = read_case(all, file);
  CHECK(found.options.shape.corners == 5);
  CHECK(found.notes == Lines{file.string() + ":2:1: shape.sides: it is now called shape.corners"});
  CHECK(read_case(all, file, std::vector<std::string>{"shape.corners=6"}).options.shape.corners == 6);
  try {
    read_case(all, file, std::vector<std::string>{"shape.sides=99"});
    FAIL("the range is that of shape.corners");
  } catch (CaseError const& error) {
    CHECK(error.lines == Lines{"--set: shape.corners: 99 is out of range; allowed: an integer in [3, 12]"});
  }
}

}  // namespace scree::test::case_file_tests
