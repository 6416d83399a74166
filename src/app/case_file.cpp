// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/case_file.hpp>

#include <scree/app/say.hpp>
#include <scree/app/text.hpp>

#include <algorithm>

namespace scree::app {

CaseError::CaseError(std::vector<std::string> all) : runtime_error(join(all, "\n")), lines(std::move(all)) {}

namespace {
std::string suggestion(std::string const& hint) { return hint.empty() ? "" : ", did you mean '" + hint + "'?"; }
}  // namespace

void CaseReader::read(Section const& section) {
  auto const names = list_.section_names();
  if (std::ranges::find(names, section.name) == names.end()) return unknown_section(section, names);
  if (!section.is_table)
    return refuse({section.where, fmt::format("{0}: a value where the section [{0}] is expected", section.name)});
  for (auto const& entry : section.entries) read(section.name, entry);
}

std::vector<std::string> CaseReader::finish() {
  if (problems_.empty()) refuse_what(list_.rules);
  if (problems_.empty()) refuse_what(list_.complaints);
  std::ranges::stable_sort(problems_, {}, [](auto const& problem) { return problem.first; });
  std::vector<std::string> lines;
  for (auto const& [where, message] : problems_) lines.push_back(printable(where.text() + ": " + message));
  if (!lines.empty()) throw CaseError(lines);
  note_settings_without_effect();
  return notes_;
}

void CaseReader::read(std::string const& section, Entry const& entry) {
  auto const* option = list_.find(section, entry.key);
  if (option == nullptr) return unknown_key(section, entry);
  auto const key = option->key(), given = section + "." + entry.key;
  if (given != key) notes_.push_back(fmt::format("{}: {}: it is now called {}", entry.where.text(), given, key));
  if (auto const before = set_at_.find(key); before != set_at_.end() && before->second == entry.where)
    notes_.push_back(fmt::format("{}: {}: given more than once, the last one counts", entry.where.text(), key));
  set_at_[key] = entry.where;
  try {
    option->read(options_, entry.value);
  } catch (Problem const& problem) {
    refuse({problem.where, fmt::format("{}: {}; allowed: {}", key, problem.message, option->allowed)});
  }
}

void CaseReader::unknown_key(std::string const& section, Entry const& entry) {
  auto const names = list_.names_in(section);
  auto hint = nearest(entry.key, names);
  if (!hint.empty()) hint = section + "." + hint;
  for (auto const& option : list_.options)
    if (hint.empty() && option.name == entry.key) hint = option.key();
  refuse({entry.where, fmt::format("{}.{}: unknown key{}; allowed: {}", section, shortened(entry.key), suggestion(hint),
                                   join(names))});
}

void CaseReader::unknown_section(Section const& section, std::vector<std::string> const& names) {
  auto hint = nearest(section.name, names);
  for (auto const& option : list_.options)
    if (!section.is_table && option.name == section.name) hint = option.key();
  auto const what = section.is_table ? "unknown section" : "a key outside of the sections";
  refuse({section.where,
          fmt::format("{}: {}{}; allowed: {}", shortened(section.name), what, suggestion(hint), join(names))});
}

Where CaseReader::place_of(std::string const& key) const {
  auto const found = set_at_.find(key);
  return found == set_at_.end() ? Where{"default"} : found->second;
}

void CaseReader::refuse_what(std::vector<OptionList::Check> const& checks) {
  for (auto const& check : checks)
    if (auto const words = check.about(options_); !words.empty())
      refuse({place_of(check.key), fmt::format("{}: {}", check.key, words)});
}

void CaseReader::note_settings_without_effect() {
  for (auto const& effect : list_.effects) {
    auto const words = effect.about(options_);
    auto const dot = effect.key.find('.');
    auto const* option = list_.find(effect.key.substr(0, dot), effect.key.substr(dot + 1));
    if (words.empty() || option->text(options_) == option->text(standard_)) continue;
    notes_.push_back(fmt::format("{}: {}: {}", place_of(effect.key).text(), effect.key, words));
  }
}

namespace detail {

std::vector<std::string> read_case(CaseReader reader, std::filesystem::path const& file,
                                   std::span<std::string const> overrides, std::span<Section const> last) {
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
  for (auto const& section : last) reader.read(section);
  return reader.finish();
}

}  // namespace detail

}  // namespace scree::app
