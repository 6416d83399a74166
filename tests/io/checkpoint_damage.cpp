// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "checkpoint_file.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::checkpoint_damage_tests {
using namespace checkpoint_test;
using scree::read_checkpoint;
using scree::write_checkpoint;

namespace {

struct Written {
  Folder folder;
  fs::path file = folder / "checkpoint.h5";
  std::string content;
  Written() {
    write_checkpoint(file, snapshot_at(1));
    content = content_of(file);
  }
  std::string complaint_with(std::string const& changed) const {
    set_content(file, changed);
    auto const found = complaint_about(file);
    auto const start = file.string() + ": cannot read the checkpoint: ";
    return found.starts_with(start) ? found.substr(start.size()) : found;
  }
};

}  // namespace

TEST_CASE("a checkpoint with any byte changed is refused") {
  Written const written;
  int accepted = 0, unnamed = 0;
  auto const change = [&](std::size_t place, char bits) {
    auto changed = written.content;
    changed[place] = static_cast<char>(changed[place] ^ bits);
    auto const complaint = written.complaint_with(changed);
    accepted += complaint.empty();
    unnamed += complaint.find("damaged") == std::string::npos && complaint.find("no checkpoint") == std::string::npos &&
               complaint.find("format") == std::string::npos;
  };
  for (std::size_t place = 0; place < 512; ++place) change(place, 1);
  for (std::size_t place = 0; place < written.content.size(); place += 97) change(place, char(1 << (place % 8)));
  for (std::size_t place = 512; place < 4096; place += 5) change(place, char(0xff));
  CHECK(accepted == 0);
  CHECK(unnamed == 0);
  CHECK(written.complaint_with(written.content) == "");
}

TEST_CASE("a checkpoint that was cut or grew is refused") {
  Written const written;
  auto const size = written.content.size();
  for (std::size_t const left : {size - 1, size / 2, std::size_t(513), std::size_t(512)})
    CHECK(written.complaint_with(written.content.substr(0, left)) ==
          fmt::format("it is damaged: it has {} bytes instead of {}", left, size));
  CHECK(written.complaint_with(written.content + '\0') ==
        fmt::format("it is damaged: it has {} bytes instead of {}", size + 1, size));
  CHECK(written.complaint_with(written.content.substr(0, 300)) ==
        "it is damaged: its first 512 bytes are not as they were written");
  CHECK(written.complaint_with("") == "it is no checkpoint of scree, which begins with 'scree checkpoint '");
}

TEST_CASE("what is no checkpoint is refused") {
  Written const written;
  auto const foreign = "it is no checkpoint of scree, which begins with 'scree checkpoint '";
  {
    scree::hdf5::Handle const file{H5Fcreate(written.file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose};
    scree::hdf5::Handle const group = scree::hdf5::create_group(file, "arrays");
  }
  CHECK(written.complaint_with(content_of(written.file)) == foreign);
  CHECK(written.complaint_with("time,C\n0,0.5\n") == foreign);
  auto newer = written.content;
  newer[17] = '2';
  CHECK(written.complaint_with(newer) == "it has format 2, this program reads format 1");

  auto const missing = written.folder / "missing.h5";
  CHECK(complaint_about(missing) == missing.string() + ": cannot read the checkpoint: No such file or directory");
  CHECK(complaint_about(written.folder.path) ==
        written.folder.path.string() + ": cannot read the checkpoint: it is not a regular file");
}

TEST_CASE("a file with a seal and other content is refused") {
  Written const written;
  scree::hdf5::Handle const creation{H5Pcreate(H5P_FILE_CREATE), H5Pclose};
  H5Pset_userblock(creation, 512);
  { scree::hdf5::Handle const file{H5Fcreate(written.file.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT), H5Fclose}; }
  scree::detail::seal(written.file);
  CHECK(complaint_about(written.file).starts_with(written.file.string() + ": cannot read the checkpoint: "));
}

TEST_CASE("a checkpoint that cannot be written leaves those before it as they were") {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  write_checkpoint(file, snapshot_at(1));
  write_checkpoint(file, snapshot_at(2));
  auto const complaint = [&] { return complaint_of([&] { write_checkpoint(file, snapshot_at(3)); }); };
  auto const start = file.string() + ": cannot write the checkpoint: ";
  SECTION("no room, at any point") {
    for (std::uintmax_t const bytes : {0, 100, 600, 2000, 20'000, 120'000}) {
      FileSizeLimit const limit(bytes);
      CHECK(complaint() == start + "File too large");
    }
  }
  SECTION("no permission") {
    if (::geteuid() == 0) SKIP("root may write everywhere");
    fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
    CHECK(complaint() == start + "Permission denied");
    fs::permissions(folder.path, fs::perms::owner_all);
  }
  SECTION("a directory in place of the new file") {
    fs::create_directories(folder / "checkpoint.h5.part");
    CHECK(complaint() == start + "Is a directory");
  }
  CHECK(read_checkpoint(file).time == 2);
  CHECK(read_checkpoint(folder / "checkpoint.previous.h5").time == 1);
}

TEST_CASE("a place where no checkpoint can be is named with the reason") {
  Folder const folder;
  auto const complaint = [&](fs::path const& file) {
    return complaint_of([&] { write_checkpoint(file, snapshot_at(1)); });
  };
  auto const missing = folder.path / "missing" / "a.h5", plain = folder.path / "plain" / "a.h5";
  set_content(folder / "plain", "x");
  CHECK(complaint(missing) == missing.string() + ": cannot write the checkpoint: No such file or directory");
  CHECK(complaint(plain) == plain.string() + ": cannot write the checkpoint: Not a directory");
  CHECK(complaint(folder.path) == folder.path.string() + ": cannot write the checkpoint: it is not a regular file");
  CHECK(files_in(folder.path) == std::vector<std::string>{"plain"});
}

}  // namespace scree::test::checkpoint_damage_tests
