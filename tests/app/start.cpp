// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shape.hpp"

#include <scree/app/start.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/io/write_file.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::start_tests {
namespace {

using namespace shape;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

/// A solver with the functions that Run::begin() needs.
struct Solver {
  struct Turnover {
    long added = 0;
  };
  struct Settings {
    double spacing = 0.005;
  };
  long at_start = 10, added = 0;
  std::vector<int> inlets = {};
  std::string fault = {};
  int checks = 0;

  long particles_at_start() const { return at_start; }
  Turnover turnover() const { return {added}; }
  std::vector<int> entered() const { return inlets; }
  Settings settings() const { return {}; }
  void check_start() {
    ++checks;
    if (!fault.empty()) throw std::invalid_argument(fault);
  }
};

/// A directory with the results of an earlier run, and runs of a program whose checkpoint paint.maker names.
struct Earlier {
  Folder folder;
  Program program{.name = "shape", .summary = "", .results = {"history.csv"}, .restart = "paint.maker"};

  Earlier() {
    for (auto const* name : {"history.csv", "case.toml"}) scree::write_file(folder / name, name);
  }
  Run<Options> run(std::vector<std::string> arguments = {}) const {
    for (std::string const more : {"--output", folder.path.c_str(), "--force"}) arguments.push_back(more);
    int exit_code = 0;
    return start(arguments, schema(), program, exit_code).value();
  }
  bool untouched() const {
    auto const same = [&](char const* name) { return content_of(folder / name) == name; };
    return same("history.csv") && same("case.toml");
  }
};

}  // namespace

TEST_CASE("results of an earlier run stay until the solver of the new one can take a step, also with --force") {
  Earlier const earlier;
  {
    auto const run = earlier.run();
    Solver wrong{.fault = "the weight of the material would crush it"};
    CHECK_THROWS_WITH(run.begin(wrong), wrong.fault);
    CHECK(wrong.checks == 1);
  }
  CHECK(earlier.untouched());
  auto const run = earlier.run();
  Solver good;
  run.begin(good);
  CHECK(good.checks == 1);
  CHECK_FALSE(fs::exists(earlier.folder / "history.csv"));
  CHECK(content_of(earlier.folder / "case.toml") == run.case_text);
}

TEST_CASE("a rank of a case meets the others after it has checked its start") {
  Earlier const earlier;
  auto run = earlier.run();
  Solver rank;
  run.meet = [&] {
    CHECK(rank.checks == 1);
    throw std::runtime_error("another rank has failed");
  };
  CHECK_THROWS_WITH(run.begin(rank), "another rank has failed");
  CHECK(earlier.untouched());
}

TEST_CASE("a case without particles is refused, unless an inlet brings some") {
  Earlier const earlier;
  auto const run = earlier.run();
  Solver empty{.at_start = 0};
  CHECK_THROWS_AS(run.begin(empty), CaseError);
  CHECK_THROWS_WITH(run.begin(empty), ContainsSubstring("no particles") && ContainsSubstring("the spacing, 0.005 m"));
  CHECK(earlier.untouched());
  Solver fed{.at_start = 0, .inlets = {1}}, filled{.at_start = 0, .added = 3};
  CHECK_NOTHROW(run.begin(fed));
  CHECK_NOTHROW(run.begin(filled));
}

TEST_CASE("a checkpoint to go on from that is missing or damaged stops a run before its simulation") {
  Earlier const earlier;
  auto const from = [&](fs::path const& file) { return earlier.run({"--set", "paint.maker=" + file.string()}); };
  auto const file = earlier.folder / "kept.h5";
  CHECK_THROWS_WITH(from(file), file.string() + ": cannot read the checkpoint: No such file or directory");
  scree::write_checkpoint(file, {});
  CHECK_NOTHROW(from(file));
  auto bytes = content_of(file);
  bytes.back() = char(bytes.back() ^ 1);
  scree::write_file(file, bytes);
  CHECK_THROWS_WITH(from(file), ContainsSubstring("it is damaged"));
  scree::write_file(file, "a text");
  CHECK_THROWS_WITH(from(file), ContainsSubstring("it is no checkpoint of scree"));
  CHECK_THROWS_WITH(from(earlier.folder.path), ContainsSubstring("it is not a regular file"));
  CHECK(earlier.untouched());
}

}  // namespace scree::test::start_tests
