// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The state of a run as plain data, which io/checkpoint.hpp writes and reads. This header depends neither on devices
// nor on files; snapshot_of.hpp fills a snapshot from a system and restores the system from it.
namespace scree {

/// The storage of one number.
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
  std::string unit;  ///< of the values
  ElementType element = ElementType::float64;
  int components = 1;  ///< numbers per particle
  std::vector<std::byte> bytes;

  /// The number of bytes of the value of one particle.
  std::size_t bytes_of_each() const { return size_of(element) * static_cast<std::size_t>(components); }
  /// The number of values.
  std::size_t count() const { return bytes.size() / bytes_of_each(); }
  /// "2 x float64, m/s".
  std::string layout() const { return std::to_string(components) + " x " + name_of(element) + ", " + unit; }
  bool operator==(SnapshotArray const&) const = default;
};

/// Everything that the next step of a run depends on, except its settings.
struct Snapshot {
  std::string signature;                 ///< the case that it fits: lines "entry: value"
  double time = 0;                       ///< s
  long steps = 0;                        ///< since the start
  std::map<std::string, long> counters;  ///< "step limits/sound", ...; no line break
  /// Texts of the user, such as the case; they are read back and never interpreted. '/' in a name separates groups, so
  /// that it cannot be the first or last letter or follow another '/'; all names together have at most 60 000 bytes.
  std::map<std::string, std::string> notes;
  std::vector<SnapshotArray> arrays;  ///< the fields of the bodies, and what components keep
  std::string origin;                 ///< the file it came from, for messages

  /// The array of a name, or nullptr.
  SnapshotArray const* find(std::string const& name) const {
    for (auto const& array : arrays)
      if (array.name == name) return &array;
    return nullptr;
  }
  bool operator==(Snapshot const&) const = default;
};

/// Adds counters as "heading/name".
void add_counters(Snapshot& snapshot, std::string const& heading, std::map<std::string, long> const& counters);
/// The counters under a heading, without it.
std::map<std::string, long> counters_of(Snapshot const& snapshot, std::string const& heading);

/// Adds numbers under a name, with their units for readers of the file: "s, m/s".
void add_numbers(Snapshot& snapshot, std::string const& name, std::string const& unit,
                 std::vector<double> const& numbers);
/// The numbers under a name. Throws std::runtime_error unless there are `count` of them with this unit, and all are
/// finite.
std::vector<double> numbers_of(Snapshot const& snapshot, std::string const& name, std::string const& unit,
                               std::size_t count);

namespace detail {

/// The most bytes of a list of names with line breaks: HDF5 holds less than 64 KiB in an attribute.
inline constexpr std::size_t most_bytes_of_names = 60'000;

/// The reason why texts cannot be the names of entries in a file, where '/' separates groups; empty if they can. `kind`
/// is the kind of the entries, "notes".
[[gnu::cold]] std::string fault_of_names(std::vector<std::string> names, std::string const& kind);
/// The reason why a file cannot store these notes, such as a name with a line break; empty if it can.
[[gnu::cold]] std::string fault_of_notes(std::map<std::string, std::string> const& notes);

std::vector<std::string> lines_of(std::string const& text);

using SignatureEntries = std::vector<std::pair<std::string, std::string>>;

[[noreturn]] void refuse(Snapshot const& snapshot, std::string const& why);
/// The array of a snapshot with the layout of `head`; throws std::runtime_error if there is none.
SnapshotArray const& matching_array(Snapshot const& snapshot, SnapshotArray const& head);

SignatureEntries entries_of(std::string const& signature);
std::string const* entry_of(SignatureEntries const& entries, std::string const& key);

}  // namespace detail

/// A message about the first entry in which a snapshot does not fit a run; empty if it fits.
std::string difference_of_signatures(std::string const& run, std::string const& snapshot);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "snapshot.ipp"
#endif
