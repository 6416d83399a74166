// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/study_plan.hpp>

#include <scree/app/case_file.hpp>
#include <scree/app/say.hpp>
#include <scree/app/text.hpp>

#include <algorithm>

namespace scree::app {

std::vector<Section> StudyPlan::sections_of(std::size_t member) const {
  std::vector<Section> sections;
  for (auto const& each : varied) {
    Value const& value = each.values[member];
    sections.push_back({.name = each.section, .where = each.where, .entries = {{each.name, value.where, value}}});
  }
  return sections;
}

namespace {

class Reader {
 public:
  void read(std::vector<Section> const& sections) {
    for (auto const& section : sections) read(section);
  }
  template <class Action>
  void guarded(Action const& action) {
    try {
      action();
    } catch (Problem const& problem) {
      problems_.push_back(problem);
    }
  }
  StudyPlan finish() {
    if (problems_.empty()) guarded([&] { check_size(); });
    if (!problems_.empty()) throw CaseError(lines());
    if (!rows_) combine_all();
    return std::move(plan_);
  }

 private:
  void read(Section const& section) {
    if (!section.is_table)
      problems_.push_back(
          {section.where, fmt::format("{0}: a value where the section [{0}] is expected", shortened(section.name))});
    for (auto const& entry : section.entries)
      guarded([&] { section.name == "study" ? read_setting(entry) : add(section.name, entry); });
  }
  void read_setting(Entry const& entry) {
    auto const* text = std::get_if<std::string>(&entry.value.data);
    if (entry.key != "combine")
      throw Problem{entry.where, "study." + shortened(entry.key) + ": unknown key; allowed: combine"};
    if (text == nullptr || (*text != "all" && *text != "rows"))
      throw Problem{entry.value.where, "study.combine: allowed: \"all\", \"rows\""};
    rows_ = *text == "rows";
  }
  void add(std::string const& section, Entry const& entry) {
    auto const key = section + "." + entry.key, shown = shortened(key);
    auto const* values = std::get_if<Value::Array>(&entry.value.data);
    if (values == nullptr)
      throw Problem{entry.value.where, shown + ": a study needs a list of its values, [value, ...]"};
    if (values->empty()) throw Problem{entry.value.where, shown + ": the list of its values is empty"};
    auto const known = std::ranges::find(plan_.varied, key, &StudyPlan::Varied::key);
    if (known != plan_.varied.end())
      known->where = entry.where, known->values = *values;
    else
      plan_.varied.push_back({section, entry.key, entry.where, *values});
  }
  void check_size() const {
    if (plan_.varied.empty()) throw Problem{{"--study"}, "no option has a list of values"};
    double members = 1;
    for (auto const& each : plan_.varied) {
      auto const& first = plan_.varied.front();
      if (rows_ && each.values.size() != first.values.size())
        throw Problem{each.where, fmt::format("{}: {} values, but {} has {}; with study.combine = \"rows\" all lists "
                                              "have the same length",
                                              shortened(each.key()), each.values.size(), shortened(first.key()),
                                              first.values.size())};
      members = rows_ ? double(first.values.size()) : members * double(each.values.size());
    }
    if (members > double(StudyPlan::most))
      throw Problem{plan_.varied.back().where,
                    fmt::format("a study of {:.6g} members, at most {} are possible", members, StudyPlan::most)};
  }
  void combine_all() {
    std::size_t before = 1, all = 1;
    for (auto const& each : plan_.varied) all *= each.values.size();
    for (auto& each : plan_.varied) {
      auto const given = std::exchange(each.values, {});
      before *= given.size();
      for (std::size_t k = 0; k < all; ++k) each.values.push_back(given[k / (all / before) % given.size()]);
    }
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (auto const& [where, message] : problems_) lines.push_back(printable(where.text() + ": " + message));
    return lines;
  }

  StudyPlan plan_;
  bool rows_ = false;
  std::vector<Problem> problems_;
};

}  // namespace

StudyPlan read_study(std::filesystem::path const& file, std::span<std::string const> vary) {
  Reader reader;
  if (!file.empty()) reader.guarded([&] { reader.read(read_toml_file(file)); });
  for (auto const& text : vary) reader.guarded([&] { reader.read(std::vector{parse_override(text, "--vary")}); });
  return reader.finish();
}

}  // namespace scree::app
