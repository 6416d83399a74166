// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "crafted_cases.hpp"

#include <catch2/catch_test_macros.hpp>

namespace scree::test::checkpoint_crafted_arrays_tests {
// Arrays of a sealed file that are invalid, or stored elsewhere.
using namespace checkpoint_test;

namespace {

auto const velocity = "arrays/material/velocity";
auto const elsewhere = "it does not lie in one piece in this file";

void in_pieces(hid_t creation) {
  hsize_t const piece[2] = {1, 1};
  H5Pset_chunk(creation, 2, piece);
}

std::vector<Crafted> arrays() {
  auto const entry = "'" + std::string(velocity) + "': ", unit = "'" + std::string(velocity) + "/unit': ";
  auto const number = H5T_IEEE_F64LE;
  std::vector<Crafted> all;
  for (int const rank : {1, 3, 8, 32})
    all.push_back({fmt::format("of rank {}", rank),
                   [=](Content const& c) {
                     c.zeros(velocity, number, std::vector<hsize_t>(std::size_t(rank), rank > 8 ? 1 : 2));
                   },
                   entry + fmt::format("it has {} dimensions instead of 2", rank)});
  all.insert(
      all.end(),
      {
          {"one number without dimensions",
           [=](Content const& c) {
             scree::hdf5::write_text(
                 c.replace(velocity, number, scree::hdf5::scalar_space(), Content::in_one_piece(), true), "unit",
                 "m/s");
           },
           entry + "it has 0 dimensions instead of 2"},
          {"no numbers per particle",
           [=](Content const& c) {
             c.zeros(velocity, number, {3, 0});
           },
           entry + "it has 0 numbers for each particle"},
          {"too many numbers per particle",
           [=](Content const& c) {
             c.zeros(velocity, number, {0, 1 << 20});
           },
           entry + "it has 1048576 numbers for each particle"},
          {"huge and never written",
           [=](Content const& c) {
             c.stored(
                 velocity, number, {hsize_t(1) << 48, 2}, [](hid_t) {}, false);
           },
           entry + "it is larger than the file"},
          {"more bytes than 64 bits can count",
           [=](Content const& c) {
             c.stored(velocity, number, {hsize_t(1) << 60, 32}, in_pieces, false);
           },
           entry},
          {"never written",
           [=](Content const& c) {
             c.stored(
                 velocity, number, {3, 2}, [](hid_t) {}, false);
           },
           entry + "0 bytes of it are in the file instead of 48"},
          {"of 64-bit integers",
           [=](Content const& c) {
             c.zeros(velocity, H5T_STD_I64LE, {3, 2});
           },
           entry + "its numbers are neither"},
          {"of numbers without sign",
           [=](Content const& c) {
             c.zeros(velocity, H5T_STD_U32LE, {3, 2});
           },
           entry + "its numbers are neither"},
          {"of the other order of bytes",
           [=](Content const& c) {
             c.zeros(velocity, H5T_IEEE_F64BE, {3, 2});
           },
           entry + "its numbers are neither"},
          {"of texts",
           [=](Content const& c) {
             c.zeros(velocity, text_of(8), {3, 2});
           },
           entry + "its numbers are neither"},
          {"without a unit",
           [=](Content const& c) {
             c.replace(velocity, number, Content::simple({3, 2}), Content::in_one_piece(), true);
           },
           unit},
          {"a number for a unit",
           [=](Content const& c) { c.attribute(velocity, "unit", H5T_NATIVE_INT, scree::hdf5::scalar_space()); },
           unit + "it is no text of fixed length"},
          {"many units", [=](Content const& c) { c.attribute(velocity, "unit", text_of(8), Content::simple({1000})); },
           unit + "it is more than one text"},
          {"a unit of any length",
           [=](Content const& c) { c.attribute(velocity, "unit", variable_text(), scree::hdf5::scalar_space()); },
           unit + "it is no text of fixed length"},
          {"a name that is not there", [](Content const& c) { c.text_attribute("arrays", "names", "material/none\n"); },
           "'arrays/material/none/unit': "},
          {"one array under many names",
           [](Content const& c) {
             std::string names;
             c.stored("arrays/large", H5T_IEEE_F64LE, {1 << 16, 1}, [](hid_t) {});
             for (int k = 0; k < 100; ++k) {
               auto const name = fmt::format("again {}", k);
               H5Lcreate_hard(c.file, "arrays/large", c.file, ("arrays/" + name).c_str(), H5P_DEFAULT, H5P_DEFAULT);
               names += name + "\n";
             }
             c.text_attribute("arrays", "names", names);
           },
           "it is larger than the file"},
      });
  return all;
}
/// Values that are stored outside this file, or packed.
std::vector<Crafted> storage() {
  auto const entry = "'" + std::string(velocity) + "': " + elsewhere;
  auto const stored = [](auto change, bool write) -> Change {
    return [=](Content const& c) { c.stored(velocity, H5T_IEEE_F64LE, {3, 2}, change, write); };
  };
  return {
      {"in a raw file", stored([](hid_t p) { H5Pset_external(p, "/etc/passwd", 0, 48); }, false), entry},
      {"in pieces", stored(in_pieces, true), entry},
      {"packed", stored([](hid_t p) { in_pieces(p), H5Pset_deflate(p, 9); }, true), entry},
      {"with the description", stored([](hid_t p) { H5Pset_layout(p, H5D_COMPACT); }, true), entry},
      {"put together from another file",
       stored(
           [](hid_t p) {
             auto const space = Content::simple({3, 2});
             H5Pset_virtual(p, space, "/etc/passwd", "/x", space);
           },
           false),
       entry},
      {"the clock in a raw file",
       [](Content const& c) {
         c.stored(
             "time", H5T_NATIVE_DOUBLE, {1}, [](hid_t p) { H5Pset_external(p, "/etc/passwd", 0, 8); }, false);
       },
       std::string("'time': ") + elsewhere},
  };
}

}  // namespace

TEST_CASE("a sealed file with wrong arrays is refused") { check_refused(arrays()); }
TEST_CASE("a sealed file with values elsewhere is refused") { check_refused(storage()); }

}  // namespace scree::test::checkpoint_crafted_arrays_tests
