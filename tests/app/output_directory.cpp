// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/folder.hpp>

#include <scree/app/output_directory.hpp>
#include <scree/io/write_file.hpp>

#include <fmt/format.h>

#include <sys/wait.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <csignal>
#include <set>

namespace scree::test::output_directory_tests {
using namespace scree::app;
using Catch::Matchers::ContainsSubstring;
using scree::write_file;
namespace fs = std::filesystem;

namespace {

std::string message_of(OutputRequest const& request) {
  try {
    OutputDirectory const directory(request);
  } catch (std::runtime_error const& error) {
    return error.what();
  }
  return "";
}
void begin(OutputRequest const& request) { OutputDirectory(request).begin("new case"); }

std::set<std::string> names_in(fs::path const& directory) {
  std::set<std::string> names;
  for (auto const& entry : fs::directory_iterator(directory)) names.insert(entry.path().filename());
  return names;
}
using Names = std::set<std::string>;

/// A stopped run: every file contains its own name.
struct Earlier {
  Folder folder;
  Names names = {"case.toml", "checkpoint.h5", "checkpoint.previous.h5", "history.csv", "notes.txt", "summary.json"};
  Earlier() {
    for (auto const& name : names) write_file(folder / name, name);
  }
  OutputRequest request() const {
    return {.directory = folder.path, .results = {"summary.json", "history.csv", "particles.vtkhdf"}};
  }
};
// Not within the class: nvcc 13 does not come to an end where a class that checks stands before large headers.
void check_untouched(Earlier const& earlier) {
  CHECK(names_in(earlier.folder.path) == earlier.names);
  for (auto const& name : earlier.names) CHECK(content_of(earlier.folder / name) == name);
}
std::string held(fs::path const& file) {
  return file.string() + ": holds an earlier result; give another --output, or --force to replace it";
}

}  // namespace

TEST_CASE("the output directory is created, and left alone until the run begins") {
  Folder const folder;
  auto const directory = folder / "a" / "b";
  {
    OutputDirectory const output({.directory = directory});
    CHECK(names_in(directory) == Names{".lock"});
  }
  CHECK_FALSE(fs::exists(directory));  // of a start that failed
  begin({.directory = directory});
  CHECK(names_in(directory) == Names{"case.toml"});
  CHECK(content_of(directory / "case.toml") == "new case");
}

TEST_CASE("earlier results are replaced only by force, and not before the run begins") {
  Earlier const earlier;
  auto request = earlier.request();
  CHECK(message_of(request) == held(earlier.folder / "summary.json"));
  request.force = true;
  CHECK(message_of(request).empty());  // a start that fails later
  check_untouched(earlier);
  begin(request);
  CHECK(names_in(earlier.folder.path) == Names{"case.toml", "notes.txt"});
  CHECK(content_of(earlier.folder / "case.toml") == "new case");
}

TEST_CASE("a checkpoint alone is a result") {
  Folder const folder;
  for (auto const* name : {"checkpoint.h5", "checkpoint.previous.h5"}) {
    write_file(folder / name, "x");
    CHECK(message_of({.directory = folder.path}) == held(folder / name));
    fs::remove(folder / name);
  }
}

TEST_CASE("a directory in place of a result stops before anything is removed") {
  Earlier const earlier;
  fs::create_directory(earlier.folder / "particles.vtkhdf");
  auto request = earlier.request();
  request.force = true;
  CHECK(message_of(request) == (earlier.folder / "particles.vtkhdf").string() + ": is a directory, not a result");
  fs::remove(earlier.folder / "particles.vtkhdf");
  check_untouched(earlier);
}

TEST_CASE("a run goes on in its directory, with or without force") {
  bool const force = GENERATE(false, true);
  Earlier const earlier;
  auto request = earlier.request();
  request.force = force;
  SECTION("from its checkpoint") {
    request.continues = earlier.folder / "checkpoint.h5";
    begin(request);
    CHECK(names_in(earlier.folder.path) == earlier.names);
    CHECK(content_of(earlier.folder / "checkpoint.h5") == "checkpoint.h5");
  }
  SECTION("from the one before, which is the newest of the new run") {
    request.continues = earlier.folder / "checkpoint.previous.h5";
    begin(request);
    CHECK(names_in(earlier.folder.path) == earlier.names);
    CHECK(content_of(earlier.folder / "checkpoint.h5") == "checkpoint.previous.h5");
  }
  SECTION("from another one there, which may be older than both") {
    write_file(earlier.folder / "kept.h5", "kept");
    request.continues = earlier.folder / "kept.h5";
    begin(request);
    CHECK(content_of(earlier.folder / "checkpoint.h5") == "kept");
    CHECK_FALSE(fs::exists(earlier.folder / "checkpoint.previous.h5"));
  }
  CHECK(content_of(earlier.folder / "history.csv") == "history.csv");
  CHECK(content_of(earlier.folder / "case.toml") == "new case");
  request.continues = earlier.folder / "chekpoint.h5";  // found missing by its reader
  CHECK(message_of(request).empty());
  CHECK(content_of(earlier.folder / "history.csv") == "history.csv");
}

TEST_CASE("a run goes on in another directory with the checkpoint it starts from") {
  Earlier const earlier, other;
  auto request = other.request();
  request.continues = earlier.folder / "checkpoint.previous.h5";
  CHECK(message_of(request) == held(other.folder / "summary.json"));
  request.force = true;
  begin(request);
  check_untouched(earlier);
  CHECK(names_in(other.folder.path) == Names{"case.toml", "checkpoint.h5", "notes.txt"});
  CHECK(content_of(other.folder / "checkpoint.h5") == "checkpoint.previous.h5");
}

TEST_CASE("one run at a time writes to a directory, also by force") {
  Folder const folder;
  OutputRequest request{.directory = folder.path, .results = {"history.csv"}, .force = true};
  {
    OutputDirectory const first(request);
    first.begin("first");
    CHECK(message_of(request) == fmt::format("{}: another run (process {}) is writing its results there; give another "
                                             "--output",
                                             folder.path.string(), ::getpid()));
    CHECK(content_of(folder / "case.toml") == "first");
  }
  CHECK(message_of(request).empty());
}

TEST_CASE("a killed run keeps nobody out") {
  Folder const folder;
  OutputRequest const request{.directory = folder.path};
  int ready[2];
  REQUIRE(::pipe(ready) == 0);
  ::pid_t const child = ::fork();
  if (child == 0) {
    OutputDirectory const output(request);
    char const letter = 'x';
    if (::write(ready[1], &letter, 1) == 1) ::pause();
    std::_Exit(0);
  }
  char letter = 0;
  REQUIRE(::read(ready[0], &letter, 1) == 1);
  CHECK_THAT(message_of(request), ContainsSubstring(fmt::format("another run (process {})", child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  for (int const end : ready) ::close(end);
  CHECK(fs::exists(folder / ".lock"));
  CHECK(message_of(request).empty());
}

TEST_CASE("an output directory that cannot be written stops before the run") {
  Folder const folder;
  auto const file = folder.write("file", "x");
  CHECK(message_of({.directory = file}) == file.string() + ": cannot create the output directory: Not a directory");
  CHECK(message_of({.directory = file / "below"}) ==
        (file / "below").string() + ": cannot create the output directory: Not a directory");
  CHECK(message_of({.directory = "/proc/self"}) == "/proc/self/.lock: cannot write it: No such file or directory");
  if (::geteuid() == 0) return;  // root may write everywhere
  fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
  CHECK(message_of({.directory = folder.path}) == (folder / ".lock").string() + ": cannot write it: Permission denied");
  fs::permissions(folder.path, fs::perms::owner_all);
}

}  // namespace scree::test::output_directory_tests
