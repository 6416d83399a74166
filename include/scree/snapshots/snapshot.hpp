// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The state of a run as plain data, which io/checkpoint.hpp writes and reads. This header depends neither on devices
// nor on files; snapshot_of.hpp fills a snapshot from a system and restores the system from it.
namespace scree {

/// How one number is stored.
enum class ElementType { float32, float64, int32 };

/// The bytes of a number.
inline std::size_t size_of(ElementType element) { return element == ElementType::float64 ? 8 : 4; }
/// The name of the type of a number.
inline std::string name_of(ElementType element) {
  if (element == ElementType::int32) return "int32";
  return element == ElementType::float64 ? "float64" : "float32";
}
/// The type of a number of C++ in a snapshot.
template <class T>
constexpr ElementType element_type() {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double> || std::is_same_v<T, std::int32_t>,
                "a snapshot holds float, double and int");
  if (std::is_same_v<T, float>) return ElementType::float32;
  return std::is_same_v<T, double> ? ElementType::float64 : ElementType::int32;
}

/// The values of one quantity of all particles, bit by bit.
struct SnapshotArray {
  std::string name;  ///< "material/velocity"; no line break
  std::string unit;
  ElementType element = ElementType::float64;
  int components = 1;  ///< numbers per particle
  std::vector<std::byte> bytes;

  std::size_t bytes_of_each() const { return size_of(element) * static_cast<std::size_t>(components); }
  std::size_t count() const { return bytes.size() / bytes_of_each(); }
  /// "2 x float64, m/s".
  std::string layout() const { return std::to_string(components) + " x " + name_of(element) + ", " + unit; }
  bool operator==(SnapshotArray const&) const = default;
};

/// Everything that the next step of a run depends on, except its settings.
struct Snapshot {
  std::string signature;  ///< the case that it fits: lines "entry: value"
  double time = 0;        ///< s
  long steps = 0;
  std::map<std::string, long> counters;  ///< "step limits/sound", ...; no line break
  /// The user's: the case as text, ...; read back and never interpreted. '/' in a name puts it into a group, so that it
  /// cannot be at an end or beside another; names have 60 000 bytes together at most.
  std::map<std::string, std::string> notes;
  std::vector<SnapshotArray> arrays;
  std::string origin;  ///< the file it came from, for messages

  SnapshotArray const* find(std::string const& name) const {
    for (auto const& array : arrays)
      if (array.name == name) return &array;
    return nullptr;
  }
  bool operator==(Snapshot const&) const = default;
};

/// Adds counters as "heading/name".
inline void add_counters(Snapshot& snapshot, std::string const& heading, std::map<std::string, long> const& counters) {
  for (auto const& [name, count] : counters) snapshot.counters[heading + "/" + name] = count;
}
/// The counters under a heading, without it.
inline std::map<std::string, long> counters_of(Snapshot const& snapshot, std::string const& heading) {
  std::map<std::string, long> result;
  for (auto const& [name, count] : snapshot.counters)
    if (name.rfind(heading + "/", 0) == 0) result[name.substr(heading.size() + 1)] = count;
  return result;
}

namespace detail {

/// Of a list of names with line breaks: HDF5 holds less than 64 KiB in an attribute.
inline constexpr std::size_t most_bytes_of_names = 60'000;

/// What keeps texts from being the names of entries in a file, where '/' separates groups; empty: nothing. `kind`: of
/// the entries, "notes".
[[gnu::cold]] inline std::string fault_of_names(std::vector<std::string> names, std::string const& kind) {
  constexpr std::size_t longest = 80;  // of a name in a message, bytes
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
/// The same for notes and their texts.
[[gnu::cold]] inline std::string fault_of_notes(std::map<std::string, std::string> const& notes) {
  std::vector<std::string> names;
  for (auto const& [name, text] : notes) {
    if (text == std::string(1, '\0')) return "the text of the note '" + name.substr(0, 80) + "' is a NUL byte";
    names.push_back(name);
  }
  return fault_of_names(std::move(names), "notes");
}

inline std::vector<std::string> lines_of(std::string const& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

using SignatureEntries = std::vector<std::pair<std::string, std::string>>;

inline SignatureEntries entries_of(std::string const& signature) {
  SignatureEntries entries;
  for (auto const& line : lines_of(signature)) {
    std::size_t const colon = std::min(line.find(": "), line.size());
    entries.emplace_back(line.substr(0, colon), line.substr(std::min(colon + 2, line.size())));
  }
  return entries;
}
inline std::string const* entry_of(SignatureEntries const& entries, std::string const& key) {
  for (auto const& [name, value] : entries)
    if (name == key) return &value;
  return nullptr;
}

}  // namespace detail

/// A message about the first entry in which a snapshot does not fit a run; empty if it fits.
inline std::string difference_of_signatures(std::string const& run, std::string const& snapshot) {
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
