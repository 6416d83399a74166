// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "crafted_file.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// Changes of a checkpoint with the expected messages.
namespace checkpoint_test {

using Change = std::function<void(Content const&)>;
struct Crafted {
  std::string what;
  Change change;
  std::string complaint;
};

inline Handle variable_text() {
  Handle type{H5Tcopy(H5T_C_S1), H5Tclose};
  H5Tset_size(type, H5T_VARIABLE);
  return type;
}
inline Handle text_of(std::size_t size) {
  Handle type{H5Tcopy(H5T_C_S1), H5Tclose};
  H5Tset_size(type, size);
  return type;
}
/// Each is rejected with its message.
inline void check_refused(std::vector<Crafted> const& all) {
  Folder const folder;
  auto const file = folder / "checkpoint.h5";
  for (auto const& [what, change, complaint] : all) {
    INFO(what);
    scree::write_checkpoint(file, odd_snapshot());
    craft(file, change);
    auto const found = complaint_about(file);
    INFO(found);
    CHECK(found.starts_with(file.string() + ": cannot read the checkpoint: "));
    CHECK(found.find(complaint) != std::string::npos);
  }
}

}  // namespace checkpoint_test
