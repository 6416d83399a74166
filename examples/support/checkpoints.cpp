// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "checkpoints.hpp"

#include "say.hpp"

#include <scree/io/checkpoint.hpp>

#include <algorithm>
#include <cstring>

namespace support {

void write_checkpoint(std::filesystem::path const& file, scree::Snapshot const& snapshot) {
  scree::write_checkpoint(file, snapshot);
}

scree::Snapshot read_checkpoint(std::filesystem::path const& file) { return scree::read_checkpoint(file); }

namespace {

std::vector<std::string> lines_that_count(std::string const& text) {
  std::vector<std::string> lines;
  for (auto const& line : scree::detail::lines_of(text)) {
    auto const first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos && line[first] != '#') lines.push_back(line);
  }
  return lines;
}
/// Keys stand under [sections], of which more than one may have the same.
std::vector<std::string> with_sections(std::vector<std::string> lines) {
  std::string section;
  for (auto& line : lines) {
    if (line.front() == '[')
      section = line + " ";
    else
      line = section + line;
  }
  return lines;
}
bool has(std::vector<std::string> const& lines, std::string const& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

}  // namespace

void add_numbers(scree::Snapshot& snapshot, std::string const& name, std::vector<double> const& numbers) {
  scree::SnapshotArray array{.name = name, .unit = "1", .bytes = {}};
  array.bytes.resize(sizeof(double) * numbers.size());
  if (!numbers.empty()) std::memcpy(array.bytes.data(), numbers.data(), array.bytes.size());
  snapshot.arrays.push_back(std::move(array));
}

std::vector<double> numbers_in(scree::Snapshot const& snapshot, std::string const& name) {
  auto const* const array = snapshot.find(name);
  if (array == nullptr || array->element != scree::ElementType::float64 || array->components != 1) return {};
  std::vector<double> numbers(array->count());
  if (!numbers.empty()) std::memcpy(numbers.data(), array->bytes.data(), array->bytes.size());
  return numbers;
}

void print_note(std::string const& note) { say(stderr, "note: {}\n", printable(note)); }

std::vector<std::string> changes(std::map<std::string, std::string> const& checkpoint,
                                 std::map<std::string, std::string> const& run) {
  std::vector<std::string> found;
  auto names = checkpoint;
  names.insert(run.begin(), run.end());
  auto const lines = [](auto const& notes, auto const& name) {
    auto const note = notes.find(name);
    return with_sections(lines_that_count(note == notes.end() ? "" : note->second));
  };
  for (auto const& entry : names) {
    auto const before = lines(checkpoint, entry.first);
    auto const now = lines(run, entry.first);
    for (auto const& line : before)
      if (!has(now, line)) found.push_back(entry.first + ": '" + line + "' of the checkpoint is missing");
    for (auto const& line : now)
      if (!has(before, line)) found.push_back(entry.first + ": '" + line + "' is new");
  }
  return found;
}

}  // namespace support
