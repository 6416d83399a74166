// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <fmt/format.h>

#include <compare>
#include <cstdint>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

namespace scree::app {

/// The place of a value: a line and column (from 1) in a file; line 0: the command line.
struct Where {
  std::string source;
  unsigned line = 0, column = 0;

  auto operator<=>(Where const&) const = default;
  /// Returns "file:line:column", or the source alone if there is no line.
  std::string text() const { return line == 0 ? source : fmt::format("{}:{}:{}", source, line, column); }
};

/// A value as written in the case file, before its type is known.
struct Value {
  struct Other {  // a type that no option accepts: a table, a date, ...
    std::string kind;
  };
  struct TooLarge {       // a number that does not fit a 64-bit integer or a double
    std::string written;  ///< as written in the file
    char const* beyond;   ///< "integers beyond 9223372036854775807"
  };
  using Array = std::vector<Value>;

  std::variant<bool, std::int64_t, double, std::string, Array, TooLarge, Other> data;
  Where where;

  /// Returns the kind of value for messages: "an integer", "a text", ...
  std::string kind() const {
    char const* const names[] = {"true or false", "an integer", "a number", "a text", "an array", "a number"};
    return data.index() < std::size(names) ? names[data.index()] : std::get<Other>(data).kind;
  }
};

/// An entry `key = value` of a section.
struct Entry {
  std::string key;
  Where where;
  Value value;
};
/// A section of a case file with its entries.
struct Section {
  std::string name;
  Where where;
  bool is_table = true;  ///< false: not a section, but written in the place of one
  std::vector<Entry> entries = {};
};

/// An error in the input, and its place.
struct Problem {
  Where where;
  std::string message;  ///< what is wrong, with the allowed values
};

}  // namespace scree::app
