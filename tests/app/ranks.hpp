// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/case_file.hpp>
#include <scree/app/ranks.hpp>

/// Options of a program whose files are compiled differently.
namespace cases {

namespace app = scree::app;

struct Numerics {
  int ranks = 1;
};
struct Options {
  Numerics numerics;
};

/// Whether a file allows a case of two ranks.
template <class File>
bool allows_two() {
  app::Schema<Options> schema;
  schema.section("numerics", &Options::numerics, "Ranks").add("ranks", &Numerics::ranks, app::about_ranks());
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  std::vector<std::string> const two = {"numerics.ranks=2"};
  try {
    app::read_case(schema, {}, two);
  } catch (app::CaseError const&) {
    return false;
  }
  return true;
}
bool allowed_in_whole_cases();  // whole_cases.cpp

}  // namespace cases
