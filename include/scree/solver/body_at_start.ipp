// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "body_at_start.hpp"

#include <algorithm>
#include <numeric>

namespace scree::detail {

SCREE_BODY std::vector<int> identities_at_start(std::size_t particles, std::vector<RangeHere> const& ranges) {
  std::vector<int> numbers(particles);
  std::iota(numbers.begin(), numbers.end(), 0);
  auto next = numbers.begin();
  for (RangeHere const& range : ranges) {
    std::iota(next, next + range.here.size(), range.here.first);
    next += range.here.size();
  }
  return numbers;
}

SCREE_BODY void require_same_groups(Snapshot const& snapshot, std::vector<int> here, std::string const& name_of_body,
                                    bool sorted) {
  SnapshotArray const* const array = snapshot.find(name_of_body + "/group");
  if (array == nullptr) return;  // then the signature differs, too
  auto there = values_of<int>(*array);
  if (sorted) std::sort(there.begin(), there.end()), std::sort(here.begin(), here.end());
  if (there != here)
    refuse(snapshot,
           "does not fit this run: the motion is by group, and the groups of the " + name_of_body + " differ");
}

}  // namespace scree::detail
