// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "crafted_cases.hpp"

#include <catch2/catch_test_macros.hpp>

namespace scree::test::checkpoint_crafted_tests {
// Each file has an intact seal and one invalid entry. The message of the rejection names that entry.
using namespace checkpoint_test;

namespace {

auto const velocity = "arrays/material/velocity";

Handle pair_of_numbers() {
  Handle type{H5Tcreate(H5T_COMPOUND, 16), H5Tclose};
  H5Tinsert(type, "a", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "b", 8, H5T_NATIVE_DOUBLE);
  return type;
}
Handle null_space() { return {H5Screate(H5S_NULL), H5Sclose}; }
/// Possible replacements of any entry: `right` is a type that would fit.
std::vector<Crafted> in_place_of(std::string const& name, hid_t right) {
  auto const entry = "'" + name;
  return {
      {"nothing", [=](Content const& c) { c.remove(name); }, entry},
      {"a group",
       [=](Content const& c) {
         c.remove(name);
         Handle const group = scree::hdf5::create_group(c.file, name.c_str());
         scree::hdf5::write_text(group, "unit", "m/s");
       },
       entry},
      {"a soft link",
       [=](Content const& c) {
         H5Lmove(c.file, name.c_str(), c.file, "moved", H5P_DEFAULT, H5P_DEFAULT);
         H5Lcreate_soft("/moved", c.file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
       },
       "it is a link to another place"},
      {"an external link",
       [=](Content const& c) {
         c.remove(name);
         H5Lcreate_external("/etc/passwd", "/x", c.file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
       },
       "it is a link to another place"},
      {"a type of many parts", [=](Content const& c) { c.zeros(name, pair_of_numbers(), {1}); }, entry},
      {"20 dimensions", [=](Content const& c) { c.zeros(name, right, std::vector<hsize_t>(20, 1)); }, entry},
      {"no dimensions and no value",
       [=](Content const& c) {
         auto const dataset = c.replace(name, right, null_space(), Content::in_one_piece(), false);
         scree::hdf5::write_text(dataset, "unit", "m/s");
       },
       entry},
  };
}
std::vector<Crafted> texts() {
  return {
      {"three texts", [](Content const& c) { c.zeros("signature", text_of(7), {3}); },
       "'signature': it is more than one text"},
      {"a text of any length", [](Content const& c) { c.zeros("signature", variable_text(), {1}); },
       "'signature': it is no text of fixed length"},
      {"a number", [](Content const& c) { c.zeros("notes/case", H5T_NATIVE_INT, {1}); },
       "'notes/case': it is no text of fixed length"},
      {"a text that was never written",
       [](Content const& c) {
         c.replace("notes/case", text_of(1 << 30), scree::hdf5::scalar_space(), Content::in_one_piece(), false);
       },
       "'notes/case': it is larger than the file"},
      {"a short text that was never written",
       [](Content const& c) {
         c.replace("notes/case", text_of(9), scree::hdf5::scalar_space(), Content::in_one_piece(), false);
       },
       "'notes/case': 0 bytes of it are in the file instead of 9"},
      {"a note that is not there", [](Content const& c) { c.text_attribute("notes", "names", "case\nnone\n"); },
       "'notes/none': "},
      {"a name twice", [](Content const& c) { c.text_attribute("notes", "names", "case\ncase\n"); },
       "'notes': a name occurs twice"},
      {"a way out of the group", [](Content const& c) { c.text_attribute("notes", "names", "../time\n"); },
       "'notes/../time': "},
  };
}
std::vector<Crafted> numbers() {
  return {
      {"of single precision", [](Content const& c) { c.zeros("time", H5T_NATIVE_FLOAT, {1}); },
       "'time': its numbers have another type"},
      {"an integer", [](Content const& c) { c.zeros("time", H5T_NATIVE_INT64, {1}); },
       "'time': its numbers have another type"},
      {"a text", [](Content const& c) { c.zeros("time", text_of(8), {1}); }, "'time': its numbers have another type"},
      {"of the other order of bytes", [](Content const& c) { c.zeros("time", H5T_IEEE_F64BE, {1}); },
       "'time': its numbers have another type"},
      {"two", [](Content const& c) { c.zeros("time", H5T_NATIVE_DOUBLE, {2}); },
       "'time': it has 2 values instead of 1"},
      {"none", [](Content const& c) { c.zeros("time", H5T_NATIVE_DOUBLE, {0}); },
       "'time': it has 0 values instead of 1"},
      {"of rank two",
       [](Content const& c) {
         c.zeros("time", H5T_NATIVE_DOUBLE, {1, 1});
       },
       "'time': it has 2 dimensions instead of 1"},
      {"of real numbers", [](Content const& c) { c.zeros("steps", H5T_NATIVE_DOUBLE, {1}); },
       "'steps': its numbers have another type"},
      {"of 32 bits", [](Content const& c) { c.zeros("steps", H5T_NATIVE_INT32, {1}); },
       "'steps': its numbers have another type"},
      {"fewer than names", [](Content const& c) { c.zeros("counters", H5T_NATIVE_INT64, {2}); },
       "'counters': it has 2 values instead of 3"},
      {"more than names", [](Content const& c) { c.zeros("counters", H5T_NATIVE_INT64, {4}); },
       "'counters': it has 4 values instead of 3"},
  };
}
std::vector<Crafted> names() {
  std::vector<Crafted> all;
  for (std::string const object : {"counters", "notes", "arrays"}) {
    auto const entry = "'" + object + "/names': ";
    all.push_back({object + " without names",
                   [=](Content const& c) {
                     Handle const where{H5Oopen(c.file, object.c_str(), H5P_DEFAULT), H5Oclose};
                     H5Adelete(where, "names");
                   },
                   entry});
    all.push_back({object + ", three texts of names",
                   [=](Content const& c) { c.attribute(object, "names", text_of(100), Content::simple({3})); },
                   entry + "it is more than one text"});
    all.push_back(
        {object + ", names of any length",
         [=](Content const& c) { c.attribute(object, "names", variable_text(), scree::hdf5::scalar_space()); },
         entry + "it is no text of fixed length"});
    all.push_back(
        {object + ", numbers for names",
         [=](Content const& c) { c.attribute(object, "names", H5T_NATIVE_DOUBLE, scree::hdf5::scalar_space()); },
         entry + "it is no text of fixed length"});
  }
  return all;
}
}  // namespace

TEST_CASE("a sealed file with something else in place of an entry is refused") {
  check_refused(in_place_of("signature", H5T_NATIVE_DOUBLE));
  check_refused(in_place_of("time", H5T_NATIVE_DOUBLE));
  check_refused(in_place_of("steps", H5T_NATIVE_INT64));
  check_refused(in_place_of("counters", H5T_NATIVE_INT64));
  check_refused(in_place_of("notes", H5T_NATIVE_INT64));
  check_refused(in_place_of("notes/case", H5T_NATIVE_INT64));
  check_refused(in_place_of("arrays", H5T_NATIVE_INT64));
  check_refused(in_place_of(velocity, H5T_IEEE_F64LE));
}
TEST_CASE("a sealed file with wrong texts is refused") { check_refused(texts()); }
TEST_CASE("a sealed file with wrong numbers is refused") { check_refused(numbers()); }
TEST_CASE("a sealed file with wrong names is refused") { check_refused(names()); }
TEST_CASE("a sealed file that was not changed is read") {
  // Otherwise the tests above could pass for the wrong reason.
  Folder const folder;
  scree::write_checkpoint(folder / "a.h5", odd_snapshot());
  craft(folder / "a.h5", [](Content const&) {});
  CHECK(complaint_about(folder / "a.h5") == "");
}

TEST_CASE("a pipe is not waited for") {
  Folder const folder;
  ::mkfifo((folder / "a.h5").c_str(), 0600);
  CHECK(complaint_about(folder / "a.h5").ends_with(": cannot read the checkpoint: it is not a regular file"));
}

}  // namespace scree::test::checkpoint_crafted_tests
