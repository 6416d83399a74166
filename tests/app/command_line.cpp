// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/folder.hpp>
#include <support/printed.hpp>

#include <scree/app/say.hpp>
#include <scree/app/start.hpp>
#include <scree/app/streams.hpp>
#include <scree/app/text.hpp>
#include <scree/io/checkpoint.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

namespace scree::test::command_line_tests {
using namespace scree::app;

namespace {

std::optional<CommandLine> parse(std::vector<std::string> arguments, int& exit_code) {
  return read_command_line(std::move(arguments), {.name = "shear_box", .summary = "A test."}, exit_code);
}

struct Part {
  double x = 1;
  std::string from = {};
};
struct Options {
  Part part;
};
Schema<Options> schema() {
  Schema<Options> all;
  all.section("part", &Options::part, "A part")
      .add("x", &Part::x, {.range = {0, 5}, .meaning = "a number"})
      .add("from", &Part::from, {.meaning = "a file"});
  return all;
}

}  // namespace

TEST_CASE("the command line of an example") {
  int code = -1;
  SECTION("only one option") {
    auto const line = parse({"--set", "a.b=1"}, code);
    REQUIRE(line);
    CHECK(line->case_file.empty());
    CHECK(line->output == "shear_box_output");
    CHECK_FALSE((line->force || line->options || line->quiet));
  }
  SECTION("nothing") {
    CHECK_FALSE(parse({}, code));
    CHECK(code == 2);
  }
  SECTION("only words for Kokkos") {
    CHECK_FALSE(parse({"--kokkos-num-threads=4"}, code));
    CHECK(code == 2);
  }
  SECTION("the version") {
    CHECK_FALSE(parse({"--version"}, code));
    CHECK(code == 0);
  }
  SECTION("everything, in any order") {
    auto const line = parse({"--set", "a.b=1", "--kokkos-num-threads=4", "case.toml", "--force", "--set=c.d=[1, 2]",
                             "--quiet", "--output", "out", "--kokkos-device-id=1", "--options"},
                            code);
    REQUIRE(line);
    CHECK(line->case_file == "case.toml");
    CHECK(line->output == "out");
    CHECK(line->overrides == std::vector<std::string>{"a.b=1", "c.d=[1, 2]"});
    CHECK((line->force && line->options && line->quiet));
  }
  SECTION("--set takes one value, so that the case file may follow it") {
    auto const line = parse({"--set", "a.b=-1", "case.toml"}, code);
    REQUIRE(line);
    CHECK(line->case_file == "case.toml");
    CHECK(line->overrides == std::vector<std::string>{"a.b=-1"});
  }
  SECTION("help and mistakes") {
    CHECK_FALSE(parse({"--help"}, code));
    CHECK(code == 0);
    CHECK_FALSE(parse({"--forse"}, code));
    CHECK(code == 2);
    CHECK_FALSE(parse({"a.toml", "b.toml"}, code));
    CHECK(code == 2);
    CHECK_FALSE(parse({"--output"}, code));
    CHECK(code == 2);
  }
}

TEST_CASE("the option --profile belongs to programs that print one, and not to studies") {
  Program const program{.name = "drum", .summary = "A test.", .profiles = true};
  int code = -1;
  auto const line = read_command_line({"--profile"}, program, code);
  REQUIRE(line);
  CHECK(line->profile);
  CHECK_FALSE(read_command_line({"--profile", "--vary", "a.b=[1, 2]"}, program, code));
  CHECK(code == 2);
  CHECK_FALSE(parse({"--profile"}, code));
  CHECK(code == 2);
}

TEST_CASE("a name that is empty is refused") {  // an unset variable of the shell
  int code = -1;
  for (std::vector<std::string> const& arguments : {std::vector<std::string>{""}, {"--output", ""}}) {
    CHECK_FALSE(parse(arguments, code));
    CHECK(code == 2);
  }
}

TEST_CASE("start reads the case and takes the directory; the options in force are written when results begin") {
  Folder const folder;
  int code = -1;
  auto const output = (folder / "out").string();
  Program const example{.name = "test", .summary = "", .results = {"summary.json"}, .restart = "part.from"};
  std::vector<std::string> const arguments = {folder.write("a.toml", "[part]\nx = 2\n"), "--output", output, "--set",
                                              "part.x=3"};
  auto run = start(arguments, schema(), example, code);
  REQUIRE(run);
  CHECK_FALSE(std::filesystem::exists(folder / "out" / "case.toml"));
  run->directory->begin(run->case_text);
  CHECK(code == 0);
  CHECK(run->options.part.x == 3);
  CHECK(run->output == output);
  CHECK(content_of(folder / "out" / "case.toml") ==
        "# A part\n[part]\n# a number; a number in [0, 5]\nx = 3\n# a file; a text in quotes\nfrom = \"\"\n");
  CHECK(content_of(folder / "out" / "case.toml") == run->case_text);

  CHECK_THROWS_AS(start(arguments, schema(), example, code), std::runtime_error);  // the first runs
  run.reset();
  CHECK_THROWS_AS(start(arguments, schema(), example, code), std::runtime_error);  // case.toml is there
  auto again = arguments;
  again.push_back("--force");
  CHECK(start(again, schema(), example, code));
  scree::write_checkpoint(folder / "out" / "checkpoint.h5", {});
  auto in_place = arguments;
  for (auto const& word : {std::string("--set"), "part.from=" + output + "/checkpoint.h5"}) in_place.push_back(word);
  CHECK(start(in_place, schema(), example, code));

  CHECK_THROWS_AS(start({"--set", "part.x=6", "--output", (folder / "new").string()}, schema(), example, code),
                  CaseError);
  CHECK_FALSE(std::filesystem::exists(folder / "new"));  // a wrong case leaves no trace
}

TEST_CASE("main's body may throw") {
  CHECK(guarded_main([] { return 3; }) == 3);
  CHECK(guarded_main([]() -> int { throw std::runtime_error("a test of the message"); }) == 1);
  CHECK(guarded_main([]() -> int { throw CaseError({"a test of the message"}); }) == 2);
}

TEST_CASE("words that cannot be printed do not stop a program") {
  std::FILE* const full = std::fopen("/dev/full", "w");
  REQUIRE(full != nullptr);
  std::setvbuf(full, nullptr, _IONBF, 0);
  CHECK_NOTHROW(say(full, "{}\n", 1));
  std::fclose(full);
  CHECK(printed([](std::FILE* stream) { say(stream, "{} of {}\n", 1, 2); }) == "1 of 2\n");
}

TEST_CASE("texts of others are printed on one line, without control characters and not endless") {
  CHECK(printable("Größe 1\n2\x1b[31m\x7f") == "Größe 1\\x0a2\\x1b[31m\\x7f");
  CHECK(printable(std::string(240, 'x')) == std::string(240, 'x'));
  // The message keeps both ends of a long word or text, and so the reason.
  CHECK(printable("/" + std::string(3000, 'x') + ": gone") ==
        "/" + std::string(38, 'x') + "..." + std::string(36, 'x') + ": gone");
  CHECK(printable("a" + std::string(3000, '\x01') + "b").size() == 80);
  std::string words = "first";
  for (int k = 0; k < 1000; ++k) words += " ä";
  auto const line = printable(words + " last");
  CHECK(line.size() <= 1000);
  CHECK((line.starts_with("first ä") && line.ends_with("ä last")));
  CHECK(std::count(line.begin(), line.end(), '\xc3') == std::count(line.begin(), line.end(), '\xa4'));  // no half ä
  std::string const long_key(5'000'000, 'k');
  CHECK(nearest(long_key, std::vector<std::string>{"k"}).empty());  // at once
  int code = -1;
  try {
    start({"--set", "part.a\nb=1"}, schema(), {.name = "test", .summary = "", .results = {}}, code);
    CHECK(false);
  } catch (CaseError const& error) {
    CHECK(std::string(error.what()).starts_with("--set: part.a\\x0ab: unknown key"));
  }
}

TEST_CASE("standard streams that are closed do not end up in results, and nothing that is not read ends a run") {
  ::pid_t const child = ::fork();
  if (child == 0) {
    for (int number : {0, 1, 2}) ::close(number);
    guard_streams();
    int const file = ::open("/dev/null", O_RDONLY);
    int pipe_ends[2];
    if (file <= 2 || ::pipe(pipe_ends) != 0) std::_Exit(1);
    ::close(pipe_ends[0]);
    bool const fails = ::write(pipe_ends[1], "x", 1) == -1 && errno == EPIPE;
    std::_Exit(fails && ::write(2, "x", 1) == 1 ? 0 : 2);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
}

}  // namespace scree::test::command_line_tests
