// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/case_file.hpp>
#include <scree/app/parts.hpp>

/// Options of a program whose files are compiled differently.
namespace cases {

namespace app = scree::app;

struct Numerics {
  int parts = 1;
};
struct Options {
  Numerics numerics;
};

/// Whether a file allows a case of two parts.
template <class File>
bool allows_two() {
  app::Schema<Options> schema;
  schema.section("numerics", &Options::numerics, "Parts").add("parts", &Numerics::parts, app::about_parts());
  app::require_parts<Options>(schema, "numerics.parts", [](Options const& o) { return o.numerics.parts; });
  std::vector<std::string> const two = {"numerics.parts=2"};
  try {
    app::read_case(schema, {}, two);
  } catch (app::CaseError const&) {
    return false;
  }
  return true;
}
bool allowed_in_whole_cases();  // whole_cases.cpp

}  // namespace cases
