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
// nor on files; snapshot_of.hpp makes a snapshot of a system and restores a system from a snapshot.
namespace scree {

/// The storage format of one number.
enum class ElementType { float32, float64, int32 };

/// Returns the size of a number in bytes.
inline std::size_t size_of(ElementType element) { return element == ElementType::float64 ? 8 : 4; }
/// Returns the name of the storage format of a number.
inline std::string name_of(ElementType element) {
  if (element == ElementType::int32) return "int32";
  return element == ElementType::float64 ? "float64" : "float32";
}
/// Returns the storage format of a C++ number in a snapshot.
template <class T>
constexpr ElementType element_type() {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double> || std::is_same_v<T, std::int32_t>,
                "a snapshot holds float, double and int");
  if (std::is_same_v<T, float>) return ElementType::float32;
  return std::is_same_v<T, double> ? ElementType::float64 : ElementType::int32;
}

/// The exact values of one quantity for all particles.
struct SnapshotArray {
  std::string name;  ///< for instance "material/velocity"; without line breaks
  std::string unit;  ///< unit of the values
  ElementType element = ElementType::float64;
  int components = 1;  ///< numbers per particle
  std::vector<std::byte> bytes;

  /// Returns the size of the value of one particle in bytes.
  std::size_t bytes_of_each() const { return size_of(element) * static_cast<std::size_t>(components); }
  /// Returns the number of values.
  std::size_t count() const { return bytes.size() / bytes_of_each(); }
  /// Returns the layout as text, for instance "2 x float64, m/s".
  std::string layout() const { return std::to_string(components) + " x " + name_of(element) + ", " + unit; }
  bool operator==(SnapshotArray const&) const = default;
};

/// The complete state on which the next step of a run depends, except the settings of the run.
struct Snapshot {
  std::string signature;                 ///< the case that the snapshot fits, as lines "entry: value"
  double time = 0;                       ///< s
  long steps = 0;                        ///< number of steps since the start
  std::map<std::string, long> counters;  ///< for instance "step limits/sound"; names without line breaks
  /// Texts from the user, such as the input of the case, which are read back and never interpreted. The character '/'
  /// in a name separates groups, so it cannot be the first or last character or follow another '/'. All names together
  /// may have at most 60 000 bytes.
  std::map<std::string, std::string> notes;
  std::vector<SnapshotArray> arrays;  ///< the fields of the bodies and the data of components
  std::string origin;                 ///< the file from which the snapshot was read, for messages

  /// Returns the array with a name, or nullptr if there is none.
  SnapshotArray const* find(std::string const& name) const {
    for (auto const& array : arrays)
      if (array.name == name) return &array;
    return nullptr;
  }
  bool operator==(Snapshot const&) const = default;
};

/// Adds counters to a snapshot under the names "heading/name".
void add_counters(Snapshot& snapshot, std::string const& heading, std::map<std::string, long> const& counters);
/// Returns the counters under a heading, by their names without the heading.
std::map<std::string, long> counters_of(Snapshot const& snapshot, std::string const& heading);

/// Adds numbers to a snapshot under a name, with their units for readers of the file, for instance "s, m/s".
void add_numbers(Snapshot& snapshot, std::string const& name, std::string const& unit,
                 std::vector<double> const& numbers);
/// Returns the numbers under a name. Throws std::runtime_error unless there are `count` numbers with this unit, and all
/// are finite.
std::vector<double> numbers_of(Snapshot const& snapshot, std::string const& name, std::string const& unit,
                               std::size_t count);

namespace detail {

/// The largest size in bytes of a list of names, including line breaks; an HDF5 attribute holds less than 64 KiB.
inline constexpr std::size_t most_bytes_of_names = 60'000;

/// Returns the reason why texts cannot be names of entries in a file, in which '/' separates groups, or "" if they can.
/// `kind` is the kind of the entries, for instance "notes".
[[gnu::cold]] std::string fault_of_names(std::vector<std::string> names, std::string const& kind);
/// Returns the reason why a file cannot store these notes, such as a name with a line break, or "" if it can.
[[gnu::cold]] std::string fault_of_notes(std::map<std::string, std::string> const& notes);

std::vector<std::string> lines_of(std::string const& text);

using SignatureEntries = std::vector<std::pair<std::string, std::string>>;

[[noreturn]] void refuse(Snapshot const& snapshot, std::string const& why);
/// Returns the array of a snapshot with the name and layout of `head`. Throws std::runtime_error if there is none.
SnapshotArray const& matching_array(Snapshot const& snapshot, SnapshotArray const& head);

SignatureEntries entries_of(std::string const& signature);
std::string const* entry_of(SignatureEntries const& entries, std::string const& key);

}  // namespace detail

/// Returns a message about the first entry in which the signatures of a run and a snapshot differ, or "" if they are
/// equal.
std::string difference_of_signatures(std::string const& run, std::string const& snapshot);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "snapshot.ipp"
#endif
