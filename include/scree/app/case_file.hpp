// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"
#include "toml.hpp"

#include <map>
#include <span>
#include <stdexcept>

namespace scree::app {

/// Everything wrong with a case, one line each: "file:line:col: key: what is wrong; allowed: ...".
struct CaseError : std::runtime_error {
  std::vector<std::string> lines;  ///< one for each problem
  /// An error with these lines, one for each problem of a case file; `what()` joins them.
  explicit CaseError(std::vector<std::string> all);
};

/// The result of read_case(): the options, and remarks about settings that are legal and without effect.
template <class T>
struct Case {
  T options{};
  std::vector<std::string> notes = {};
};

/// Reads sections into a struct of options in the given order, later ones over earlier ones, and collects the mistakes.
class CaseReader {
 public:
  /// `options` has its defaults, and so has `standard`.
  CaseReader(OptionList const& list, void* options, void const* standard)
      : list_(list), options_(options), standard_(standard) {}

  /// Notes a problem, which finish() throws with all others.
  void refuse(Problem const& problem) { problems_.emplace_back(problem.where, problem.message); }
  /// Reads the options of a section. Problems are noted, and finish() throws them.
  void read(Section const& section);
  /// Returns the notes. Throws CaseError if anything was wrong.
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
/// Reads a case file, `overrides` of the command line over it, and `last` over both. Returns what finish() does.
std::vector<std::string> read_case(CaseReader reader, std::filesystem::path const& file,
                                   std::span<std::string const> overrides, std::span<Section const> last = {});
}  // namespace detail

/// The options of a case: defaults, then the file (an empty path: none), then the overrides "section.key=value".
/// Throws CaseError naming everything that is wrong.
template <class T>
Case<T> read_case(Schema<T> const& schema, std::filesystem::path const& file,
                  std::span<std::string const> overrides = {}) {
  Case<T> found{.options = schema.standard()};
  found.notes = detail::read_case({schema.list(), &found.options, &schema.standard()}, file, overrides);
  return found;
}

}  // namespace scree::app
