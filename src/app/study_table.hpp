// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scree::app::detail {

/// The numbers of a text that to_json() wrote, by their names; those of an object within as "outer.inner", those of
/// arrays are left out. What is not such a text has none.
std::map<std::string, double> numbers_of_json(std::string const& text);

/// How the members of a study ended, as a table of comma-separated values: number, state, varied options, the numbers
/// of summary.json, message.
class StudyTable {
 public:
  StudyTable(std::filesystem::path file, std::size_t members, std::vector<std::string> columns);

  std::filesystem::path const& file() const { return file_; }
  /// "07": the number from 1, with the digits of the last one.
  std::string name_of(std::size_t member) const;
  void set_values(std::size_t member, std::vector<std::string> values) { rows_[member].values = std::move(values); }
  /// `end`: its exit code and, in the next line, a message.
  void set_end(std::size_t member, std::string const& end, std::filesystem::path const& directory);

  bool finished(std::size_t member) const;
  /// "finished", "outside validity", "failed", "stopped" or "not begun".
  std::string state_of(std::size_t member) const;
  std::string values_of(std::size_t member) const;
  std::size_t done() const;
  /// "62 finished, 2 failed".
  std::string counts() const;
  /// 0, or that of a member that failed or left the validity of the model.
  int exit_code() const;
  void write() const;

 private:
  struct Row {
    std::vector<std::string> values = {};
    std::optional<int> exit_code = {};
    std::string message = {};
    std::map<std::string, double> figures = {};
  };
  std::filesystem::path file_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace scree::app::detail
