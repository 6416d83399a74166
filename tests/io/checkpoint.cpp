// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "checkpoint_file.hpp"
#include "hdf5_file.hpp"

#include <catch2/catch_test_macros.hpp>

namespace scree::test::checkpoint_tests {
using namespace checkpoint_test;
using scree::read_checkpoint;
using scree::write_checkpoint;
using Names = std::vector<std::string>;

TEST_CASE("a checkpoint comes back bit by bit") {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  for (auto snapshot : {odd_snapshot(), scree::Snapshot{}}) {
    write_checkpoint(file, snapshot);
    auto const found = read_checkpoint(file);
    CHECK(found.origin == file.string());
    snapshot.origin = found.origin;
    CHECK(found == snapshot);
  }
}

TEST_CASE("a checkpoint is an HDF5 file that others can read") {
  Folder const folder;
  write_checkpoint(folder / "a.h5", odd_snapshot());
  File const file(folder / "a.h5");
  CHECK(file.read<double>("time") == std::vector<double>{0.1 + 0.2});
  CHECK(file.text("time", "unit") == "s");
  CHECK(file.read<std::int64_t>("steps") == std::vector<std::int64_t>{123456789012});
  CHECK(file.text("counters", "names") == "a: b\nneighbour builds/material-wall\nstep limits/sound\n");
  CHECK(file.read<std::int64_t>("counters") == std::vector<std::int64_t>{-1, 0, 7});
  CHECK(file.shape("arrays/material/velocity") == std::vector<hsize_t>{3, 2});
  CHECK(file.text("arrays/material/velocity", "unit") == "m/s");
  CHECK(file.stored_as("arrays/material/velocity", H5T_IEEE_F64LE));
  CHECK(file.stored_as("arrays/material/a name (2)", H5T_IEEE_F32LE));
  CHECK(file.read<std::int32_t>("arrays/wall/identity") == std::vector<std::int32_t>{1, -2, 2147483647});
  CHECK(fs::file_size(folder / "a.h5") < 130'000);  // reserved disk space is given back
}

TEST_CASE("the seal of a checkpoint is the CRC-64/XZ of what stands behind it") {
  scree::detail::Checksum checksum;  // the check value of the catalogue of CRCs
  std::string const digits = "123456789";
  checksum.add(std::as_bytes(std::span(digits)));
  CHECK(checksum.value() == 0x995dc9bbdf1939fa);
  scree::detail::Checksum pieces;
  for (auto const& [from, size] : {std::pair(0, 3), std::pair(3, 0), std::pair(3, 6)})
    pieces.add(std::as_bytes(std::span(digits)).subspan(std::size_t(from), std::size_t(size)));
  CHECK(pieces.value() == checksum.value());

  Folder const folder;
  write_checkpoint(folder / "a.h5", odd_snapshot());
  auto const content = content_of(folder / "a.h5");
  scree::detail::Checksum all;
  all.add(std::as_bytes(std::span(content)).subspan(512));
  CHECK(content.substr(0, content.find('\0')) ==
        fmt::format("scree checkpoint 1\nsize {:020}\nCRC-64/XZ {:016x}\n", content.size(), all.value()));
}

TEST_CASE("the checkpoint before the last is kept") {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  CHECK(scree::previous_checkpoint(file) == folder / "checkpoint.previous.h5");
  CHECK(scree::previous_checkpoint("checkpoint.h5") == "checkpoint.previous.h5");
  write_checkpoint(file, snapshot_at(1));
  CHECK(files_in(folder.path) == Names{"checkpoint.h5"});
  write_checkpoint(file, snapshot_at(2));
  write_checkpoint(file, snapshot_at(3));
  CHECK(files_in(folder.path) == Names{"checkpoint.h5", "checkpoint.previous.h5"});
  CHECK(read_checkpoint(file).time == 3);
  CHECK(read_checkpoint(folder / "checkpoint.previous.h5").time == 2);
}

TEST_CASE("what a run that was killed while it wrote left behind does not matter") {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  write_checkpoint(file, snapshot_at(1));
  write_checkpoint(file, snapshot_at(2));
  SECTION("half a new one") { set_content(folder / "checkpoint.h5.part", "half"); }
  SECTION("before the new one got its name") {
    fs::remove(folder / "checkpoint.previous.h5");
    fs::create_hard_link(file, folder / "checkpoint.previous.h5");
    fs::create_hard_link(file, folder / "checkpoint.previous.h5.part");
  }
  SECTION("with the previous one alone") {
    fs::rename(file, folder / "checkpoint.previous.h5");
    write_checkpoint(file, snapshot_at(2.5));
  }
  CHECK(read_checkpoint(file).time >= 2);
  write_checkpoint(file, snapshot_at(3));
  CHECK(read_checkpoint(file).time == 3);
  CHECK(read_checkpoint(folder / "checkpoint.previous.h5").time >= 2);
  CHECK(files_in(folder.path) == Names{"checkpoint.h5", "checkpoint.previous.h5"});
}

TEST_CASE("a checkpoint in the working directory needs no directory in its name") {
  Folder const folder;
  auto const before = fs::current_path();
  fs::current_path(folder.path);
  write_checkpoint("here.h5", snapshot_at(1));
  write_checkpoint("here.h5", snapshot_at(2));
  CHECK(read_checkpoint("here.previous.h5").time == 1);
  fs::current_path(before);
  CHECK(files_in(folder.path) == Names{"here.h5", "here.previous.h5"});
}

TEST_CASE("names that a file cannot hold are refused") {
  Folder const folder;
  auto const complaint = [&](auto change) {
    auto bad = odd_snapshot();
    change(bad);
    return complaint_of([&] { write_checkpoint(folder / "a.h5", bad); });
  };
  auto const start = (folder / "a.h5").string() + ": cannot write the checkpoint: ";
  CHECK(complaint([](auto& s) { s.counters["two\nlines"] = 1; }) ==
        start + "'two\nlines' is no name: it is empty or has a line break");
  auto const no_name = [&](std::string const& name, char const* kind) {
    return start + "'" + name + "' cannot be among the names of " + kind +
           ": it is empty, has a line break or a NUL byte, or a part of it between '/' is empty or '.'";
  };
  for (std::string const& name :
       {std::string(), std::string("/x"), std::string("x/"), std::string("a//b"), std::string("."),
        std::string("a/./b"), std::string("a\nb"), std::string("a\0b", 3)}) {
    auto const shown = name.size() == 3 && name[1] == '\0' ? "a\\0b" : name;
    CHECK(complaint([&](auto& s) { s.notes[name] = "x"; }) == no_name(shown, "notes"));
    CHECK(complaint([&](auto& s) { s.arrays[0].name = name; }) == no_name(shown, "arrays"));
  }
  CHECK(complaint([](auto& s) {
          s.notes = {{"a", ""}, {"a-b", ""}, {"a/b/c", ""}};
        }) == start + "'a' and 'a/b/c' cannot both be names of notes: '/' puts the second into the first");
  CHECK(complaint([](auto& s) {
          s.arrays[0].name = "material";
        }).find("'material' and 'material/a name (2)' cannot both") != std::string::npos);
  CHECK(complaint([](auto& s) { s.arrays.push_back(s.arrays[0]); }) ==
        start + "'material/velocity' is twice among the names of arrays");
  CHECK(complaint([](auto& s) { s.notes["nul"] = std::string(1, '\0'); }) ==
        start + "the text of the note 'nul' is a NUL byte");
  auto const many = [](auto& s, int number, std::size_t letters) {
    for (int k = 0; k < number; ++k) s.notes[fmt::format("{:0{}}", k, letters)] = "x";
  };
  CHECK(complaint([&](auto& s) { s.notes.clear(), many(s, 5000, 15); }) ==
        start + "the names of 5000 notes have 80000 bytes with their line breaks, at most 60000 are allowed");
  CHECK(complaint([&](auto& s) { s.notes[std::string(70'000, 'n')] = "x"; }).size() < 300);
  CHECK(complaint([](auto& s) { s.counters[std::string(70'000, 'n')] = 1; }).find("at most 60000") !=
        std::string::npos);
  CHECK(files_in(folder.path).empty());

  auto legal = odd_snapshot();
  legal.notes = {{"a/b", "1"}, {"a/c", "2"}, {"ab", "3"}, {"..", "4"}, {".x", "5"}, {"zero", std::string("a\0b\0", 4)}};
  many(legal, 5994, 9);  // 59 940 bytes, and 22 of the six above
  write_checkpoint(folder / "a.h5", legal);
  CHECK(read_checkpoint(folder / "a.h5").notes == legal.notes);
}

}  // namespace scree::test::checkpoint_tests
