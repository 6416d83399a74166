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

/// The source of a value: a line and column (from 1) of a file; line 0: the command line.
struct Where {
  std::string source;
  unsigned line = 0, column = 0;

  auto operator<=>(Where const&) const = default;
  /// "file:line:column"; the source alone where there is no line.
  std::string text() const { return line == 0 ? source : fmt::format("{}:{}:{}", source, line, column); }
};

/// A value as it is written in the case file, before its type is known.
struct Value {
  struct Other {  // a type that no option takes: a table, a date, ...
    std::string kind;
  };
  struct TooLarge {       // a number that is no 64-bit integer or no double
    std::string written;  ///< as it is written there
    char const* beyond;   ///< "integers beyond 9223372036854775807"
  };
  using Array = std::vector<Value>;

  std::variant<bool, std::int64_t, double, std::string, Array, TooLarge, Other> data;
  Where where;

  /// "an integer", "a text", ...: for messages.
  std::string kind() const {
    char const* const names[] = {"true or false", "an integer", "a number", "a text", "an array", "a number"};
    return data.index() < std::size(names) ? names[data.index()] : std::get<Other>(data).kind;
  }
};

/// One `key = value`, and a section with all of its own.
struct Entry {
  std::string key;
  Where where;
  Value value;
};
/// A section of a case file with its entries.
struct Section {
  std::string name;
  Where where;
  bool is_table = true;  ///< false: this is not a section, but is written where sections belong
  std::vector<Entry> entries = {};
};

/// Something wrong with the input, and where.
struct Problem {
  Where where;
  std::string message;  ///< what is wrong, with the allowed values
};

}  // namespace scree::app
