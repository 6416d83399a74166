// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"
#include "toml.hpp"

#include <map>
#include <span>
#include <stdexcept>

namespace scree::app {

/// An error that lists all problems of a case, one line each: "file:line:col: key: what is wrong; allowed: ...".
struct CaseError : std::runtime_error {
  std::vector<std::string> lines;  ///< one for each problem
  /// Creates an error from lines, one for each problem of a case file; `what()` joins the lines.
  explicit CaseError(std::vector<std::string> all);
};

/// The result of read_case(): the options, and notes, for instance about valid settings that have no effect.
template <class T>
struct Case {
  T options{};
  std::vector<std::string> notes = {};
};

/// A reader that reads sections into a struct of options. Later sections override earlier ones; errors are collected.
class CaseReader {
 public:
  /// Creates a reader into `options`, which must still have the default values, as `standard` does.
  CaseReader(OptionList const& list, void* options, void const* standard)
      : list_(list), options_(options), standard_(standard) {}

  /// Records a problem, which finish() throws together with all others.
  void refuse(Problem const& problem) { problems_.emplace_back(problem.where, problem.message); }
  /// Reads the options of a section and records problems, which finish() throws.
  void read(Section const& section);
  /// Checks the rules and returns the notes. Throws CaseError if there are problems.
  std::vector<std::string> finish();

 private:
  void read(std::string const& section, Entry const& entry);
  void unknown_key(std::string const& section, Entry const& entry);
  void unknown_section(Section const& section, std::vector<std::string> const& names);
  Where place_of(std::string const& key) const;
  void refuse_what(std::vector<OptionList::Check> const& checks);
  void note_settings_without_effect();

  OptionList const& list_;
  void* options_;
  void const* standard_;
  std::vector<std::string> notes_;
  std::map<std::string, Where> set_at_;
  std::vector<std::pair<Where, std::string>> problems_;
};

namespace detail {
/// Reads a case file, then the `overrides` of the command line, then `last`, each overriding the values before. Returns
/// the result of finish().
std::vector<std::string> read_case(CaseReader reader, std::filesystem::path const& file,
                                   std::span<std::string const> overrides, std::span<Section const> last = {});
}  // namespace detail

/// Returns the options of a case: the defaults, overridden by the file (an empty path: none) and then by the overrides
/// "section.key=value". Throws CaseError with all problems.
template <class T>
Case<T> read_case(Schema<T> const& schema, std::filesystem::path const& file,
                  std::span<std::string const> overrides = {}) {
  Case<T> found{.options = schema.standard()};
  found.notes = detail::read_case({schema.list(), &found.options, &schema.standard()}, file, overrides);
  return found;
}

}  // namespace scree::app
