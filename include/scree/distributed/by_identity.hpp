// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "shared_memory.hpp"
#include "team.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

namespace scree::detail {

/// Returns the team of a case with one rank.
template <class Space>
Team<Space> team_of_one() {
  return Team<Space>(SharedMemory::ends(1).front());
}

/// Returns the values on all ranks, in the order of the ranks.
template <class Space, class T>
std::vector<T> joined_values(Team<Space> const& team, std::vector<T> values) {
  auto const sizes = team.gather(std::int64_t(values.size()));
  auto const most = static_cast<std::size_t>(*std::max_element(sizes.begin(), sizes.end()));
  values.resize(most);
  auto const padded = team.gather(values);
  std::vector<T> all;
  for (std::size_t q = 0; q < sizes.size(); ++q) {
    auto const first = padded.begin() + static_cast<std::ptrdiff_t>(q * most);
    all.insert(all.end(), first, first + static_cast<std::ptrdiff_t>(sizes[q]));
  }
  return all;
}

/// Sorts values of the particles on all ranks by particle identity; every rank gets all values.
template <class Space>
class ByIdentity {
 public:
  /// Takes the identities of the particles on this rank. `divided`: the other ranks have other particles.
  ByIdentity(Team<Space> const& team, std::vector<int> identities, bool divided) : team_(team), divided_(divided) {
    auto const numbers = joined(std::move(identities));
    order_.resize(numbers.size());
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
  }
  /// Returns the sorted values of all particles, with `of_each` values for each particle.
  template <class T>
  std::vector<T> of(std::vector<T> here, std::size_t of_each = 1) const {
    auto const values = joined(std::move(here));
    auto sorted = values;
    for (std::size_t k = 0; k < order_.size(); ++k)
      std::copy_n(values.begin() + std::ptrdiff_t(order_[k] * of_each), of_each,
                  sorted.begin() + std::ptrdiff_t(k * of_each));
    return sorted;
  }

 private:
  template <class T>
  std::vector<T> joined(std::vector<T> here) const {
    return divided_ ? joined_values(team_, std::move(here)) : here;
  }

  Team<Space> team_;
  bool divided_;
  std::vector<std::size_t> order_;  // for each sorted particle, its index among the joined particles
};

}  // namespace scree::detail
