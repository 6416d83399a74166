// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shape.hpp"

#include <scree/app/start.hpp>
#include <scree/io/write_file.hpp>
#include <scree/passes/outside_validity.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>

namespace scree::test::preview_tests {
namespace {

using namespace shape;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

template <class T>
SnapshotArray array(std::string name, std::string unit, int components, std::vector<T> const& values) {
  SnapshotArray result{std::move(name), std::move(unit), element_type<T>(), components, {}};
  result.bytes.resize(values.size() * sizeof(T));
  std::memcpy(result.bytes.data(), values.data(), result.bytes.size());
  return result;
}

/// Grains of a plane in a row, the k-th at (k/10, 1 - k/5), on two particles of a wall. The stress of the k-th is
/// -(1, 2, 3) k, its mixture (k/3, 1 - k/3).
Snapshot row_of(int grains) {
  std::vector<double> position, stress, mixture;
  std::vector<float> velocity;
  for (int k = 0; k < grains; ++k) {
    position.push_back(0.1 * k), position.push_back(1 - 0.2 * k);
    velocity.push_back(3), velocity.push_back(-4);
    for (int c : {-1, -2, -3, 0}) stress.push_back(c * k);
    mixture.push_back(k / 3.0), mixture.push_back(1 - k / 3.0);
  }
  Snapshot row;
  row.signature = "dimension: 2\nmaterial particles: n\nwall particles: 2\n";
  row.arrays = {array("material/position", "m", 2, position),
                array("material/velocity", "m/s", 2, velocity),
                array("material/stress", "Pa", 4, stress),
                array("material/concentrations", "1", 2, mixture),
                array("material/previous velocity", "m/s", 2, velocity),
                array("wall/position", "m", 2, std::vector<double>{-1, -2, 5, 0}),
                array("neighbours/material", "m", 2, position)};
  return row;
}

/// A solver with the functions that Run::begin() needs.
struct Solver {
  struct Turnover {
    long added = 0;
  };
  struct Physics {
    std::string warning() const { return "ill-posed at all inertial numbers"; }
  };
  struct Settings {
    double spacing = 0.1;
    bool start_checks = true;
    Physics physics = {};
  };
  int grains = 4;
  std::function<void()> fault = [] {};
  std::map<std::string, long> counts = {{"sound", 7}};

  long particles_at_start() const { return grains; }
  Turnover turnover() const { return {}; }
  std::vector<int> entered() const { return {}; }
  Settings settings() const { return {}; }
  std::map<std::string, long> const& limits() const { return counts; }
  Snapshot snapshot() const { return row_of(grains); }
  void check_start() { fault(); }
  double step(double longest) {
    ++counts["friction"];
    return std::min(2.5e-4, longest);
  }
};

// Not within the class: nvcc 13 does not come to an end where a class that checks stands before large headers.
void check_content(fs::path const& file, std::string const& text) { CHECK(content_of(file) == text); }

/// A folder with results of an earlier run, and the preview of a case in it.
struct Earlier {
  Folder folder;
  Program program{.name = "shape", .summary = "", .results = {"history.csv"}, .restart = "paint.maker"};
  fs::path page = folder / "preview.html";

  Earlier() {
    for (auto const* name : {"history.csv", "case.toml"}) scree::write_file(folder / name, name);
  }
  Run<Options> run(std::vector<std::string> arguments = {}) const {
    for (std::string const more : {"--output", folder.path.c_str(), "--preview", "--quiet"}) arguments.push_back(more);
    int exit_code = 0;
    return start(arguments, schema(), program, exit_code).value();
  }
  Outcome outcome(Solver solver, std::vector<std::string> const& arguments = {}) const {
    return outcome_of([&] {
      run(arguments).begin(solver);
      return 77;  // it goes on
    });
  }
  /// The names of all files, each with a blank; those of the earlier run are as they were.
  std::string files() const {
    std::set<std::string> names;
    for (auto const& file : fs::directory_iterator(folder.path)) names.insert(file.path().filename());
    std::string all;
    for (auto const& name : names) all += name + " ";
    for (auto const* name : {"history.csv", "case.toml"}) check_content(folder / name, name);
    return all;
  }
  std::string part(std::string const& name) const {
    auto const text = content_of(page);
    auto const head = "id=\"" + name + "\">";
    auto const at = text.find(head) + head.size();
    return text.substr(at, text.find("</script>", at) - at);
  }
  /// The numbers of a row of the page, in its range.
  std::vector<double> row(std::size_t number, std::size_t particles, double low, double high) const {
    std::vector<unsigned> bytes;
    unsigned bits = 0, held = 0;
    for (char const c : part("data")) {
      auto const digit = std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(c);
      if (digit == std::string_view::npos) continue;
      bits = bits << 6 | unsigned(digit), held += 6;
      if (held >= 8) held -= 8, bytes.push_back(bits >> held & 255);
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < particles; ++i) {
      auto const at = number * particles + i;
      values.push_back(low + (bytes.at(at) + 256 * bytes.at(bytes.size() / 2 + at)) / 65535.0 * (high - low));
    }
    return values;
  }
};

void check_close(std::vector<double> const& found, std::vector<double> const& expected, double within) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) CHECK(std::abs(found[k] - expected[k]) <= within);
}

}  // namespace

TEST_CASE("a preview shows the particles of all bodies, and ends the program with the exit code 0") {
  Earlier const earlier;
  auto const end = earlier.outcome({});
  CHECK(end.exit_code == 0);
  CHECK(end.message.empty());
  CHECK(earlier.files() == "case.toml history.csv preview.html ");
  check_close(earlier.row(0, 6, -1, 5), {0, 0.1, 0.2, 0.3, -1, 5}, 6 / 65535.0);
  check_close(earlier.row(1, 6, -2, 1), {1, 0.8, 0.6, 0.4, -2, 0}, 3 / 65535.0);
  check_close(earlier.row(2, 6, 0, 1), {0, 0, 0, 0, 1, 1}, 0);
  check_close(earlier.row(3, 6, 0, 5), {5, 5, 5, 5, 0, 0}, 5 / 65535.0);              // |velocity|
  check_close(earlier.row(4, 6, 0, 6), {0, 2, 4, 6, 0, 0}, 6 / 65535.0);              // pressure
  check_close(earlier.row(5, 6, 0, 1), {0, 1.0 / 3, 2.0 / 3, 1, 0, 0}, 1 / 65535.0);  // no vector
  check_close(earlier.row(6, 6, 0, 1), {1, 2.0 / 3, 1.0 / 3, 0, 0, 0}, 1 / 65535.0);
  auto const meta = earlier.part("meta");
  CHECK_THAT(meta, ContainsSubstring("concentration 1") && ContainsSubstring("concentration 2"));
  CHECK_THAT(meta, ContainsSubstring("passed") && ContainsSubstring("0.00025 s, limited by: friction"));
  CHECK_THAT(meta, ContainsSubstring("ill-posed at all inertial numbers"));
  CHECK_THAT(meta, !ContainsSubstring("previous velocity"));
}

TEST_CASE("a preview of a case that the checks refuse shows it, and has the exit code of the run") {
  Earlier const earlier;
  auto const refused = [&](std::function<void()> const& fault, int grains = 4) {
    auto const end = earlier.outcome({.grains = grains, .fault = fault});
    CHECK(earlier.files() == "case.toml history.csv preview.html ");
    CHECK_THAT(earlier.part("meta"), ContainsSubstring("refused: ") && !ContainsSubstring("first step"));
    fs::remove(earlier.page);
    return end;
  };
  CHECK(refused([] { throw std::invalid_argument("two particles at one place"); }).message ==
        "error: two particles at one place");
  CHECK(refused([] { throw std::invalid_argument(""); }).exit_code == failed);
  CHECK(refused([] { throw OutsideValidity("too fast"); }).exit_code == outside_validity);
  CHECK(refused([] {}, 0).exit_code == app::refused);
}

TEST_CASE("a preview replaces an earlier one, and no other file of that name") {
  Earlier const earlier;
  CHECK(earlier.outcome({}).exit_code == 0);
  CHECK(earlier.outcome({.grains = 2}).exit_code == 0);
  check_close(earlier.row(0, 4, -1, 5), {0, 0.1, -1, 5}, 6 / 65535.0);
  scree::write_file(earlier.page, "of the user");
  auto const end = earlier.outcome({});
  CHECK(end.exit_code == failed);
  CHECK_THAT(end.message, ContainsSubstring("preview.html: is no preview; give another --output"));
  CHECK(content_of(earlier.page) == "of the user");
}

TEST_CASE("the title of a preview has the settings of the case, which cannot end its text") {
  Earlier const earlier;
  CHECK(earlier.outcome({}, {"--set", "paint.maker=\"</script><b>\""}).exit_code == 0);
  CHECK_THAT(earlier.part("meta"), ContainsSubstring("default case, paint.maker") && ContainsSubstring("<\\/script>"));
  CHECK_THAT(content_of(earlier.page), !ContainsSubstring("\"</script><b>"));
}

TEST_CASE("of many particles a preview shows one in so many") {
  Earlier const earlier;
  CHECK(earlier.outcome({.grains = 700'000}).exit_code == 0);
  CHECK_THAT(earlier.part("meta"), ContainsSubstring("700000 particles") && ContainsSubstring("\"stride\" : 3"));
  CHECK(fs::file_size(earlier.page) < 5'000'000);
}

TEST_CASE("a study has no preview") {
  for (auto const* const other : {"--vary", "--study"}) {
    int code = 0;
    CHECK_FALSE(read_command_line({other, "a.b=[1]", "--preview"}, {.name = "shape", .summary = ""}, code));
    CHECK(code == 2);
  }
}

}  // namespace scree::test::preview_tests
