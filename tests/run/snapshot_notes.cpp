// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/snapshot_notes.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::snapshot_notes_tests {
using namespace scree;
using Lines = std::vector<std::string>;

TEST_CASE("changes of the case since a checkpoint are reported by line and section") {
  std::string const before = "# sizes\n[a]\nspacing = 0.04 \n\n[b]\nend = 3\n",
                    now = "[a]\nspacing = 0.05\nend = 3\n[b]\nend = 3\n";
  CHECK(changes_of_notes({{"case", before}}, {{"case", before + "# more\n"}}).empty());
  CHECK(changes_of_notes({{"case", before}, {"x", "1"}}, {{"case", now}}) ==
        Lines{"case: '[a] spacing = 0.04 ' of the checkpoint is missing", "case: '[a] spacing = 0.05' is new",
              "case: '[a] end = 3' is new", "x: '1' of the checkpoint is missing"});
}

TEST_CASE("numbers in a snapshot are found by name") {
  Snapshot snapshot;
  add_numbers(snapshot, "none", {});
  add_numbers(snapshot, "some", {1.0 / 3, -0.0});
  CHECK(numbers_in(snapshot, "none").empty());
  CHECK(numbers_in(snapshot, "some") == std::vector<double>{1.0 / 3, -0.0});
  CHECK(numbers_in(snapshot, "missing").empty());
  snapshot.arrays.push_back({.name = "of a field", .unit = "m", .components = 2, .bytes = std::vector<std::byte>(32)});
  CHECK(numbers_in(snapshot, "of a field").empty());
}

}  // namespace scree::test::snapshot_notes_tests
