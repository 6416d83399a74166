// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "snapshot_of.hpp"

namespace scree::detail {

SCREE_BODY std::vector<std::byte> picked(SnapshotArray const& array, std::vector<int> const& numbers) {
  std::size_t const each = array.bytes_of_each();
  std::vector<std::byte> bytes(numbers.size() * each);
  for (std::size_t k = 0; k < numbers.size(); ++k)
    std::copy_n(array.bytes.begin() + std::ptrdiff_t(std::size_t(numbers[k]) * each), each,
                bytes.begin() + std::ptrdiff_t(k * each));
  return bytes;
}

SCREE_BODY void check_counts(Snapshot const& snapshot) {
  if (!(snapshot.time >= 0) || std::isinf(snapshot.time))
    refuse(snapshot, "'time' is " + exact_text(snapshot.time) + " s");
  constexpr long most = 1L << 62;  // leaves room for further counts
  auto counts = snapshot.counters;
  counts["steps"] = snapshot.steps;
  for (auto const& [name, count] : counts)
    if (count < 0 || count > most) refuse(snapshot, "'" + name + "' is " + std::to_string(count));
}

SCREE_BODY long counter_within(Snapshot const& snapshot, std::string const& name, long least, long most) {
  auto const found = snapshot.counters.find(name);
  long const count = found == snapshot.counters.end() ? 0 : found->second;
  if (count < least || count > most)
    refuse(snapshot, "'" + name + "' is " + std::to_string(count) + ", and must be from " + std::to_string(least) +
                         " to " + std::to_string(most));
  return count;
}

SCREE_BODY void check_identities(Snapshot const& snapshot, std::string const& body, long below) {
  SnapshotArray const* const array = snapshot.find(body + "/identity");
  if (array == nullptr) return;
  auto numbers = values_of<int>(*array);
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (numbers[k] < 0 || numbers[k] >= below || (k > 0 && numbers[k] == numbers[k - 1]))
      refuse(snapshot, "'" + array->name + "' has " + std::to_string(numbers[k]) + " twice, or it is not from 0 to " +
                           std::to_string(below - 1));
}

}  // namespace scree::detail
