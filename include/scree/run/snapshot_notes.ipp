// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "snapshot_notes.hpp"

namespace scree {

SCREE_BODY void add_numbers(Snapshot& snapshot, std::string const& name, std::vector<double> const& numbers) {
  SnapshotArray array{.name = name, .unit = "1", .bytes = {}};
  array.bytes.resize(sizeof(double) * numbers.size());
  if (!numbers.empty()) std::memcpy(array.bytes.data(), numbers.data(), array.bytes.size());
  snapshot.arrays.push_back(std::move(array));
}

SCREE_BODY std::vector<double> numbers_in(Snapshot const& snapshot, std::string const& name) {
  auto const* const array = snapshot.find(name);
  if (array == nullptr || array->element != ElementType::float64 || array->components != 1) return {};
  std::vector<double> numbers(array->count());
  if (!numbers.empty()) std::memcpy(numbers.data(), array->bytes.data(), array->bytes.size());
  return numbers;
}

SCREE_BODY std::vector<std::string> detail::lines_with_sections(std::string const& text) {
  std::vector<std::string> lines;
  std::string section;
  for (auto const& line : lines_of(text)) {
    auto const first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    if (line.front() == '[') section = line + " ";
    lines.push_back(line.front() == '[' ? section : section + line);
  }
  return lines;
}

SCREE_BODY std::vector<std::string> changes_of_notes(Notes const& checkpoint, Notes const& run) {
  auto const lines = [](Notes const& notes, std::string const& name) {
    auto const note = notes.find(name);
    return detail::lines_with_sections(note == notes.end() ? "" : note->second);
  };
  auto const has = [](std::vector<std::string> const& all, std::string const& line) {
    return std::find(all.begin(), all.end(), line) != all.end();
  };
  std::vector<std::string> found;
  auto names = checkpoint;
  names.insert(run.begin(), run.end());
  for (auto const& entry : names) {
    auto const before = lines(checkpoint, entry.first), now = lines(run, entry.first);
    for (auto const& line : before)
      if (!has(now, line)) found.push_back(entry.first + ": '" + line + "' of the checkpoint is missing");
    for (auto const& line : now)
      if (!has(before, line)) found.push_back(entry.first + ": '" + line + "' is new");
  }
  return found;
}

}  // namespace scree
