// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <column_collapse/case.hpp>
#include <drum/schema.hpp>
#include <inclined_flow/case.hpp>
#include <scree/app/case_file.hpp>
#include <scree/app/describe.hpp>
#include <shear_box/case.hpp>

#include <cstdlib>

// Any text as the case file of each program, and its first line as `--set`. It is rejected with CaseError, or it gives
// options that can be written as a case file and read again.
namespace {

using namespace scree::app;

template <class T, class Read>
bool accepts(Schema<T> const& schema, T& options, Read const& read) {
  options = schema.standard();
  CaseReader reader(schema.list(), &options, &schema.standard());
  try {
    read(reader);
  } catch (Problem const& problem) {
    reader.refuse(problem);
  }
  try {
    reader.finish();
    return true;
  } catch (CaseError const&) {
    return false;
  }
}

template <class T>
void read_as(Schema<T> const& schema, std::string const& text) {
  T options;
  auto const from_file = [](std::string const& content) {
    return [&content](CaseReader& reader) {
      for (auto const& section : parse_toml(content, "case.toml")) reader.read(section);
    };
  };
  if (accepts(schema, options, from_file(text))) {
    auto const written = case_text(schema, options);
    if (!accepts(schema, options, from_file(written)) || case_text(schema, options) != written) std::abort();
  }
  auto const line = text.substr(0, text.find('\n'));
  accepts(schema, options, [&](CaseReader& reader) { reader.read(parse_override(line)); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  static auto const box = shear_box::schema();
  static auto const turning = drum::schema();
  static auto const column = column_collapse::schema();
  static auto const slope = inclined_flow::schema();
  std::string const text(reinterpret_cast<char const*>(data), size);
  read_as(box, text);
  read_as(turning, text);
  read_as(column, text);
  read_as(slope, text);
  return 0;
}
