// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study_table.hpp"

#include <scree/app/start.hpp>
#include <scree/io/write_file.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

namespace scree::app::detail {

namespace {

/// As a field of a table: in quotation marks where it needs them.
std::string as_field(std::string const& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char const c : text) quoted += c == '"' ? "\"\"" : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return quoted + "\"";
}

std::optional<double> number_of_json(std::string text) {
  if (text == "\"NaN\"") return std::numeric_limits<double>::quiet_NaN();
  if (text == "\"Infinity\"") return std::numeric_limits<double>::infinity();
  if (text == "\"-Infinity\"") return -std::numeric_limits<double>::infinity();
  char* end = nullptr;
  double const number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return number;
}

}  // namespace

std::map<std::string, double> numbers_of_json(std::string const& text) {
  std::map<std::string, double> numbers;
  std::vector<std::string> outer;      // an empty name: an array or what is in it
  auto const begin = text.find('\n');  // after the bracket of the whole
  std::istringstream lines(begin == std::string::npos ? "" : text.substr(begin));
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
    if (!line.empty() && line.back() == ',') line.pop_back();
    auto const middle = line.find("\" : ");
    bool const in_array = !outer.empty() && outer.back().empty();
    bool const named = line.starts_with('"') && middle != std::string::npos;
    auto const name = named ? line.substr(1, middle - 1) : "";
    auto const value = named ? line.substr(middle + 4) : line;
    if (value == "{" || value == "[") {
      bool const is_array = value == "[" || !named || in_array;
      outer.push_back(is_array ? "" : (outer.empty() ? "" : outer.back()) + name + ".");
    } else if (value == "}" || value == "]") {
      if (!outer.empty()) outer.pop_back();
    } else if (auto const number = number_of_json(value); named && number) {
      if (!in_array) numbers[(outer.empty() ? "" : outer.back()) + name] = *number;
    }
  }
  return numbers;
}

StudyTable::StudyTable(std::filesystem::path file, std::size_t members, std::vector<std::string> columns)
    : file_(std::move(file)), columns_(std::move(columns)), rows_(members) {}

std::string StudyTable::name_of(std::size_t member) const {
  return fmt::format("{:0{}}", member + 1, std::to_string(rows_.size()).size());
}

void StudyTable::set_end(std::size_t member, std::string const& end, std::filesystem::path const& directory) {
  Row& row = rows_[member];
  auto const line = end.find('\n');
  row.exit_code = std::atoi(end.c_str());
  row.message = line == std::string::npos ? "" : end.substr(line + 1);
  while (!row.message.empty() && row.message.back() == '\n') row.message.pop_back();
  std::ifstream summary(directory / "summary.json", std::ios::binary);
  row.figures = numbers_of_json({std::istreambuf_iterator<char>(summary), {}});
}

bool StudyTable::finished(std::size_t member) const {
  auto const& code = rows_[member].exit_code;
  return code && (*code == 0 || *code == outside_validity);
}

std::string StudyTable::state_of(std::size_t member) const {
  auto const& code = rows_[member].exit_code;
  if (!code) return "not begun";
  if (*code == 0) return "finished";
  if (*code == outside_validity) return "outside validity";
  return *code > 128 ? "stopped" : "failed";
}

std::string StudyTable::values_of(std::size_t member) const {
  std::string text;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (k > 0) text += ", ";
    text += columns_[k].substr(0, columns_[k].find(' ')) + " = " + rows_[member].values[k];
  }
  return text;
}

std::size_t StudyTable::done() const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) count += finished(k);
  return count;
}

std::string StudyTable::counts() const {
  std::map<std::string, int> counts;
  for (std::size_t k = 0; k < rows_.size(); ++k) ++counts[state_of(k)];
  std::string text;
  for (auto const* state : {"finished", "outside validity", "failed", "stopped", "not begun"})
    if (counts.contains(state)) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[state], state);
  return text;
}

int StudyTable::exit_code() const {
  int code = 0;
  for (auto const& row : rows_) {
    if (!row.exit_code || (*row.exit_code != 0 && *row.exit_code != outside_validity)) return failed;
    if (*row.exit_code != 0) code = *row.exit_code;
  }
  return code;
}

void StudyTable::write() const {
  std::set<std::string> figures;
  for (auto const& row : rows_)
    for (auto const& figure : row.figures) figures.insert(figure.first);
  std::string text = "member,state";
  auto const add = [&](std::string const& field) { text += fmt::format(",{}", as_field(field)); };
  for (auto const& column : columns_) add(column);
  for (auto const& name : figures) add(name);
  add("message");
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    auto const& row = rows_[k];
    text += fmt::format("\n{},{}", name_of(k), state_of(k));
    for (auto const& value : row.values) add(value);
    for (auto const& name : figures) {
      auto const figure = row.figures.find(name);
      add(figure == row.figures.end() ? "" : fmt::format("{}", figure->second));
    }
    add(row.message);
  }
  write_file(file_, fmt::format("{}\n", text));
}

}  // namespace scree::app::detail
