// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "snapshot.hpp"

namespace scree {

SCREE_BODY void add_counters(Snapshot& snapshot, std::string const& heading,
                             std::map<std::string, long> const& counters) {
  for (auto const& [name, count] : counters) snapshot.counters[heading + "/" + name] = count;
}

SCREE_BODY std::map<std::string, long> counters_of(Snapshot const& snapshot, std::string const& heading) {
  std::map<std::string, long> result;
  for (auto const& [name, count] : snapshot.counters)
    if (name.rfind(heading + "/", 0) == 0) result[name.substr(heading.size() + 1)] = count;
  return result;
}

SCREE_BODY void detail::refuse(Snapshot const& snapshot, std::string const& why) {
  throw std::runtime_error((snapshot.origin.empty() ? "scree: the snapshot" : snapshot.origin) + ": " + why);
}

SCREE_BODY SnapshotArray const& detail::matching_array(Snapshot const& snapshot, SnapshotArray const& head) {
  SnapshotArray const* const array = snapshot.find(head.name);
  if (array == nullptr) refuse(snapshot, "'" + head.name + "' (" + head.layout() + ") is missing");
  if (array->layout() != head.layout())
    refuse(snapshot, "'" + head.name + "' is " + array->layout() + " instead of " + head.layout());
  if (array->bytes.size() % array->bytes_of_each() != 0)
    refuse(snapshot, "'" + head.name + "' ends within the values of a particle");
  return *array;
}

SCREE_BODY void add_numbers(Snapshot& snapshot, std::string const& name, std::string const& unit,
                            std::vector<double> const& numbers) {
  SnapshotArray array{name, unit, ElementType::float64, 1, {}};
  auto const* const first = reinterpret_cast<std::byte const*>(numbers.data());
  array.bytes.assign(first, first + numbers.size() * sizeof(double));
  snapshot.arrays.push_back(std::move(array));
}

SCREE_BODY std::vector<double> numbers_of(Snapshot const& snapshot, std::string const& name, std::string const& unit,
                                          std::size_t count) {
  SnapshotArray const head{name, unit, ElementType::float64, 1, {}};
  auto const& array = detail::matching_array(snapshot, head);
  if (array.count() != count)
    detail::refuse(snapshot, "'" + name + "' has " + std::to_string(array.count()) + " numbers instead of " +
                                 std::to_string(count));
  std::vector<double> numbers(count);
  std::memcpy(numbers.data(), array.bytes.data(), array.bytes.size());
  for (double const number : numbers)
    if (!std::isfinite(number)) detail::refuse(snapshot, "'" + name + "' has a number that is not finite");
  return numbers;
}

SCREE_BODY std::string detail::fault_of_names(std::vector<std::string> names, std::string const& kind) {
  constexpr std::size_t longest = 80;  // length of a name in a message, bytes
  auto const quoted = [](std::string name) {
    if (name.size() > longest) name = name.substr(0, longest) + "...";
    for (auto at = name.find('\0'); at != std::string::npos; at = name.find('\0')) name.replace(at, 1, "\\0");
    return "'" + name + "'";
  };
  std::size_t bytes = 0;
  for (auto const& name : names) {
    auto const within = "/" + name + "/";
    bool const parts = within.find("//") == std::string::npos && within.find("/./") == std::string::npos;
    if (!parts || name.find_first_of(std::string("\n\0", 2)) != std::string::npos)
      return quoted(name) + " cannot be among the names of " + kind +
             ": it is empty, has a line break or a NUL byte, or a part of it between '/' is empty or '.'";
    bytes += name.size() + 1;
  }
  if (bytes > most_bytes_of_names)
    return "the names of " + std::to_string(names.size()) + " " + kind + " have " + std::to_string(bytes) +
           " bytes with their line breaks, at most " + std::to_string(most_bytes_of_names) + " are allowed";
  std::sort(names.begin(), names.end());
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0 && names[k] == names[k - 1]) return quoted(names[k]) + " is twice among the names of " + kind;
    for (auto slash = names[k].find('/'); slash != std::string::npos; slash = names[k].find('/', slash + 1)) {
      auto const group = names[k].substr(0, slash);
      if (std::binary_search(names.begin(), names.end(), group))
        return quoted(group) + " and " + quoted(names[k]) + " cannot both be names of " + kind +
               ": '/' puts the second into the first";
    }
  }
  return "";
}

SCREE_BODY std::string detail::fault_of_notes(std::map<std::string, std::string> const& notes) {
  std::vector<std::string> names;
  for (auto const& [name, text] : notes) {
    if (text == std::string(1, '\0')) return "the text of the note '" + name.substr(0, 80) + "' is a NUL byte";
    names.push_back(name);
  }
  return fault_of_names(std::move(names), "notes");
}

SCREE_BODY std::vector<std::string> detail::lines_of(std::string const& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

SCREE_BODY detail::SignatureEntries detail::entries_of(std::string const& signature) {
  SignatureEntries entries;
  for (auto const& line : lines_of(signature)) {
    std::size_t const colon = std::min(line.find(": "), line.size());
    entries.emplace_back(line.substr(0, colon), line.substr(std::min(colon + 2, line.size())));
  }
  return entries;
}

SCREE_BODY std::string const* detail::entry_of(SignatureEntries const& entries, std::string const& key) {
  for (auto const& [name, value] : entries)
    if (name == key) return &value;
  return nullptr;
}

SCREE_BODY std::string difference_of_signatures(std::string const& run, std::string const& snapshot) {
  auto const here = detail::entries_of(run);
  auto const there = detail::entries_of(snapshot);
  for (auto const& [name, expected] : here) {
    std::string const* const found = detail::entry_of(there, name);
    if (found == nullptr) return "this run has '" + name + "' (" + expected + "), the snapshot has not";
    if (*found != expected) return "'" + name + "' is " + expected + " in this run and " + *found + " in the snapshot";
  }
  for (auto const& [name, found] : there)
    if (detail::entry_of(here, name) == nullptr)
      return "the snapshot has '" + name + "' (" + found + "), this run has not";
  if (run != snapshot) return "the entries of the two signatures have another order";
  return "";
}

}  // namespace scree
