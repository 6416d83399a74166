// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "describe.hpp"
#include "say.hpp"
#include "toml.hpp"

#include <map>
#include <stdexcept>

namespace support {

/// Everything wrong with a case, one line each: "file:line:col: key: what is wrong; allowed: ...".
struct CaseError : std::runtime_error {
  std::vector<std::string> lines;
  explicit CaseError(std::vector<std::string> all) : runtime_error(join(all, "\n")), lines(std::move(all)) {}
};

/// What read_case() found: the options, and remarks about settings that are legal and without effect.
template <class T>
struct Case {
  T options{};
  std::vector<std::string> notes = {};
};

/// Reads sections in the order given, later ones over earlier ones, and collects what is wrong.
template <class T>
class CaseReader {
 public:
  explicit CaseReader(Schema<T> const& schema) : schema_(schema) {}

  void refuse(Problem const& problem) { problems_.emplace_back(problem.where, problem.message); }

  void read(Section const& section) {
    auto const names = schema_.section_names();
    if (std::ranges::find(names, section.name) == names.end()) return unknown_section(section, names);
    if (!section.is_table) {
      return refuse({section.where, fmt::format("{0}: a value where the section [{0}] is expected", section.name)});
    }
    for (auto const& entry : section.entries) read(section.name, entry);
  }

  /// Throws CaseError if anything was wrong.
  Case<T> finish() {
    if (problems_.empty()) check_rules(schema_.rules(), [&](Problem const& problem) { refuse(problem); });
    if (problems_.empty())
      for (auto const& [key, about] : schema_.complaints())
        if (auto const words = about(case_.options); !words.empty())
          refuse({place_of(key), fmt::format("{}: {}", key, words)});
    std::ranges::stable_sort(problems_, {}, [](auto const& problem) { return problem.first; });
    std::vector<std::string> lines;
    for (auto const& [where, message] : problems_) lines.push_back(printable(where.text() + ": " + message));
    if (!lines.empty()) throw CaseError(lines);
    note_settings_without_effect();
    return case_;
  }

 private:
  void read(std::string const& section, Entry const& entry) {
    auto const key = section + "." + entry.key;
    auto const* option = schema_.find(section, entry.key);
    if (option == nullptr) return unknown_key(section, entry);
    if (auto const before = set_at_.find(key); before != set_at_.end() && before->second == entry.where) {
      case_.notes.push_back(fmt::format("{}: {}: given more than once, the last one counts", entry.where.text(), key));
    }
    set_at_[key] = entry.where;
    try {
      option->read(case_.options, entry.value);
    } catch (Problem const& problem) {
      refuse({problem.where, fmt::format("{}: {}; allowed: {}", key, problem.message, option->allowed)});
    }
  }

  void unknown_key(std::string const& section, Entry const& entry) {
    auto const names = schema_.names_in(section);
    auto hint = nearest(entry.key, names);
    if (!hint.empty()) hint = section + "." + hint;
    for (auto const& option : schema_.options()) {
      if (hint.empty() && option.name == entry.key) hint = option.key();
    }
    refuse({entry.where,
            fmt::format("{}.{}: unknown key{}; allowed: {}", section, entry.key, suggestion(hint), join(names))});
  }

  void unknown_section(Section const& section, std::vector<std::string> const& names) {
    auto hint = nearest(section.name, names);
    for (auto const& option : schema_.options()) {
      if (!section.is_table && option.name == section.name) hint = option.key();
    }
    auto const what = section.is_table ? "unknown section" : "a key outside of the sections";
    refuse({section.where, fmt::format("{}: {}{}; allowed: {}", section.name, what, suggestion(hint), join(names))});
  }

  static std::string suggestion(std::string const& hint) {
    return hint.empty() ? "" : ", did you mean '" + hint + "'?";
  }

  Where place_of(std::string const& key) const {
    auto const found = set_at_.find(key);
    return found == set_at_.end() ? Where{"default"} : found->second;
  }

  template <class Report>
  void check_rules(std::vector<Rule<T>> const& rules, Report report) {
    for (auto const& [key, holds, message] : rules) {
      if (holds(case_.options)) continue;
      report({place_of(key), fmt::format("{}: {}", key, message)});
    }
  }

  void note_settings_without_effect() {
    check_rules(schema_.effects(), [&](Problem const& problem) {
      auto const key = problem.message.substr(0, problem.message.find(':'));
      auto const dot = key.find('.');
      auto const* option = schema_.find(key.substr(0, dot), key.substr(dot + 1));
      if (option->text(case_.options) == option->text(T{})) return;
      case_.notes.push_back(problem.where.text() + ": " + problem.message);
    });
  }

  Schema<T> const& schema_;
  Case<T> case_;
  std::map<std::string, Where> set_at_;
  std::vector<std::pair<Where, std::string>> problems_;
};

/// The options of a case: defaults, then the file (an empty path: none), then the overrides "section.key=value".
/// Throws CaseError naming everything that is wrong.
template <class T>
Case<T> read_case(Schema<T> const& schema, std::filesystem::path const& file,
                  std::span<std::string const> overrides = {}) {
  CaseReader<T> reader(schema);
  auto const guarded = [&](auto action) {
    try {
      action();
    } catch (Problem const& problem) {
      reader.refuse(problem);
    }
  };
  if (!file.empty()) {
    guarded([&] {
      for (auto const& section : read_toml_file(file)) reader.read(section);
    });
  }
  for (auto const& text : overrides) guarded([&] { reader.read(parse_override(text)); });
  return reader.finish();
}

}  // namespace support
