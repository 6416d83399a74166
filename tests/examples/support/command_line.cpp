// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "folder.hpp"

#include <support/progress.hpp>
#include <support/start.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cstdlib>

using namespace support;

namespace {

std::optional<CommandLine> parse(std::vector<std::string> arguments, int& exit_code) {
  return read_command_line(std::move(arguments), {"shear_box", "A test."}, exit_code);
}

struct Part {
  double x = 1;
};
struct Options {
  Part part;
};
Schema<Options> schema() {
  Schema<Options> all;
  all.section("part", &Options::part, "A part").add("x", &Part::x, {.range = {0, 5}, .meaning = "a number"});
  return all;
}

// What is printed to a stream through `use(stream)`.
template <class Use>
std::string printed(Use use) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const stream = ::open_memstream(&text, &size);
  use(stream);
  std::fclose(stream);
  std::string const result(text, size);
  std::free(text);
  return result;
}

}  // namespace

TEST_CASE("the command line of an example") {
  int code = -1;
  SECTION("nothing") {
    auto const line = parse({}, code);
    REQUIRE(line);
    CHECK(line->case_file.empty());
    CHECK(line->output == "shear_box_output");
    CHECK(line->overrides.empty());
    CHECK_FALSE((line->force || line->options || line->quiet));
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

TEST_CASE("start reads the case, prepares the directory and writes the options in force") {
  Folder const folder;
  int code = -1;
  auto const output = (folder / "out").string();
  Example const example{.name = "test", .summary = "", .results = {"summary.json"}};
  std::vector<std::string> const arguments = {folder.write("a.toml", "[part]\nx = 2\n"), "--output", output, "--set",
                                              "part.x=3"};
  auto const run = start(arguments, schema(), example, code);
  REQUIRE(run);
  CHECK(code == 0);
  CHECK(run->options.part.x == 3);
  CHECK(run->output == output);
  CHECK(content_of(folder / "out" / "case.toml") == "# A part\n[part]\n# a number; a number in [0, 5]\nx = 3\n");
  CHECK(content_of(folder / "out" / "case.toml") == run->case_text);

  CHECK_THROWS_AS(start(arguments, schema(), example, code), std::runtime_error);  // case.toml is there
  auto again = arguments;
  again.push_back("--force");
  CHECK(start(again, schema(), example, code));

  CHECK_THROWS_AS(start({"--set", "part.x=6", "--output", (folder / "new").string()}, schema(), example, code),
                  CaseError);
  CHECK_FALSE(std::filesystem::exists(folder / "new"));  // a wrong case leaves no trace
}

TEST_CASE("main's body may throw") {
  CHECK(guarded_main([] { return 3; }) == 3);
  CHECK(guarded_main([]() -> int { throw std::runtime_error("a test of the message"); }) == 1);
  CHECK(guarded_main([]() -> int { throw CaseError({"a test of the message"}); }) == 2);
}

TEST_CASE("progress is one changing line on a terminal and lines now and then elsewhere") {
  double now = 100;
  auto const clock = [&] { return now; };
  auto const run = [&](std::FILE* stream, bool terminal, bool quiet) {
    now = 100;
    Progress progress(
        {.end = 120, .name = "t/T", .quiet = quiet, .stream = stream, .terminal = terminal, .seconds = clock});
    for (int step = 1; step <= 24; ++step) {
      now += 1;
      progress.update(5.0 * step, 100L * step);
    }
    progress.finish(120, 2400);
  };
  CHECK(printed([&](std::FILE* stream) { run(stream, false, false); }) ==
        "t/T 50.00 of 120 (42 %), 1000 steps, 100 steps/s, 0:14 left\n"
        "t/T 100.00 of 120 (83 %), 2000 steps, 100 steps/s, 0:04 left\n"
        "t/T 120.00 of 120 (100 %), 2400 steps, 100 steps/s, took 0:24\n");
  CHECK(printed([&](std::FILE* stream) { run(stream, true, true); }).empty());

  auto const line = printed([&](std::FILE* stream) { run(stream, true, false); });
  CHECK(std::ranges::count(line, '\r') == 25);
  CHECK(std::ranges::count(line, '\n') == 1);
  CHECK(line.ends_with("\rt/T 120.00 of 120 (100 %), 2400 steps, 100 steps/s, took 0:24\x1b[K\n"));

  auto const cut_off = printed([&](std::FILE* stream) {
    Progress progress({.end = 0, .stream = stream, .terminal = true, .seconds = clock});
    now += 1;
    progress.update(0, 1);  // nothing to divide by
  });
  CHECK(cut_off.ends_with("\n"));
  CHECK(clock_text(59.6) == "1:00");
  CHECK(clock_text(3723) == "1:02:03");
  CHECK(clock_text(-1) == "0:00");
}
