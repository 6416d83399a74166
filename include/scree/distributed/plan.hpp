// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/available_memory.hpp"
#include "../core/loop.hpp"
#include "../fields/array.hpp"
#include "team.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace scree {

/// A communication plan: which particles of a body each rank sends to which rank. Particles are listed by their number
/// on this rank, in the order of the receiving ranks. A list may contain a particle several times, each time with a
/// different shift (m), which is added to the position sent.
template <class P>
class Plan {
 public:
  using vector = Vec<P::dim, typename P::real>;
  using TeamOf = Team<typename P::space>;

  /// Plans to send the particles that `find(rank, first, numbers, shifts)` finds for each rank. `find` returns a
  /// functor for running_sum() over `size` particles, which writes numbers and shifts from index `first` on, as far as
  /// there is room.
  template <class Find>
  void make(typename P::space const& space, TeamOf const& team, int size, Find const& find) {
    auto const ranks = static_cast<std::size_t>(team.ranks());
    sent_.assign(ranks + 1, 0);
    for (std::size_t q = 0; q < ranks; ++q) {
      int const first = checked_count(std::size_t(sent_[q]));
      auto const count = [&] {
        return running_sum(space, "scree::plan", size, find(int(q), first, numbers_.span(), shifts_.span()));
      };
      int const found = count();
      check_number(double(first) + double(found));
      sent_[q + 1] = sent_[q] + found;
      if (numbers_.size() < first + found) {
        int const room = first + found + std::min(found / 8, most_particles - first - found);
        enlarge(space, numbers_, "scree::plan", room);
        enlarge(space, shifts_, "scree::plan", room);
        count();
      }
    }
    agree(space, team);
  }

  /// Returns the numbers of the particles that this rank sends, in the order of the receiving ranks.
  Array<P, int> numbers() const { return numbers_.part(0, sending()); }
  /// Returns the vector (m) to add to the position of each particle in numbers(). It is zero except across the ends of
  /// a period.
  Array<P, vector> shifts() const { return shifts_.part(0, sending()); }
  /// Returns the number of particles that this rank sends.
  int sending() const { return sent_.empty() ? 0 : static_cast<int>(sent_.back()); }
  /// Returns the number of particles that this rank receives.
  int receiving() const { return received_.empty() ? 0 : static_cast<int>(received_.back()); }
  /// Returns the total number of particles that all ranks send.
  std::int64_t everywhere() const { return everywhere_; }
  /// Returns the index of the first particle for each rank, and the total number at the end.
  std::vector<std::int64_t> const& sent() const { return sent_; }
  /// Returns the index of the first particle from each rank, and the total number at the end.
  std::vector<std::int64_t> const& received() const { return received_; }
  /// Returns sent() in the memory of the execution space, unless no rank sends anything.
  std::int64_t const* sent_there() const { return there_.data(); }
  /// Returns received() in the memory of the execution space, unless no rank sends anything.
  std::int64_t const* received_there() const { return there_.data() + sent_.size(); }

 private:
  /// Exchanges the particle counts, so that each rank knows how many particles to receive.
  void agree(typename P::space const& space, TeamOf const& team) {
    std::size_t const ranks = sent_.size() - 1, here = std::size_t(team.rank());
    std::vector<std::int64_t> counts(ranks);
    for (std::size_t q = 0; q < ranks; ++q) counts[q] = sent_[q + 1] - sent_[q];
    auto const all = team.gather(counts);  // by sender, then by receiver
    received_.assign(ranks + 1, 0);
    for (std::size_t q = 0; q < ranks; ++q) received_[q + 1] = received_[q] + all[q * ranks + here];
    check_number(double(received_.back()));
    everywhere_ = std::accumulate(all.begin(), all.end(), std::int64_t(0));
    if (everywhere_ == 0) return;
    auto both = sent_;
    both.insert(both.end(), received_.begin(), received_.end());
    reserve(space, there_, "scree::plan", both.size());
    copy_into(there_, both);
  }

  Array<P, int> numbers_;
  Array<P, vector> shifts_;
  std::vector<std::int64_t> sent_, received_;
  Array<P, std::int64_t> there_;  // sent_ and received_, in the memory of the execution space
  std::int64_t everywhere_ = 0;
};

}  // namespace scree
