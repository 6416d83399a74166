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

/// Who sends which particles of a body to whom. Particles are listed by their number here, for rank 0 first; a list may
/// contain a particle several times, each time with another shift (m), which is added to its position on the way.
template <class P>
class Plan {
 public:
  using vector = Vec<P::dim, typename P::real>;
  using TeamOf = Team<typename P::space>;

  /// The particles that `find(rank, first, numbers, shifts)` gives for each rank: a function for running_sum() over
  /// `size` particles, which writes numbers and shifts from place `first` on as far as there is room.
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

  /// The numbers of the particles that this rank sends, in the order of the ranks that receive them.
  Array<P, int> numbers() const { return numbers_.part(0, sending()); }
  /// The vector that is added to the position of each of these particles, m. It is zero except across the ends of a
  /// period.
  Array<P, vector> shifts() const { return shifts_.part(0, sending()); }
  /// The number of particles that this rank sends, and that it receives.
  int sending() const { return sent_.empty() ? 0 : static_cast<int>(sent_.back()); }
  /// The number of particles that this rank receives.
  int receiving() const { return received_.empty() ? 0 : static_cast<int>(received_.back()); }
  /// The number of particles that all ranks together send.
  std::int64_t everywhere() const { return everywhere_; }
  /// Index of the first particle for each rank, or from each rank, and the number of all at the end.
  std::vector<std::int64_t> const& sent() const { return sent_; }
  /// Index of the first particle from each rank, and the number of all at the end.
  std::vector<std::int64_t> const& received() const { return received_; }
  /// sent() and received() in the memory of the execution space, unless nothing is sent on any rank.
  std::int64_t const* sent_there() const { return there_.data(); }
  /// received() in the memory of the execution space, unless nothing is sent on any rank.
  std::int64_t const* received_there() const { return there_.data() + sent_.size(); }

 private:
  /// Sends the numbers of particles to the ranks that will receive them.
  void agree(typename P::space const& space, TeamOf const& team) {
    std::size_t const ranks = sent_.size() - 1, here = std::size_t(team.rank());
    std::vector<std::int64_t> counts(ranks);
    for (std::size_t q = 0; q < ranks; ++q) counts[q] = sent_[q + 1] - sent_[q];
    auto const all = team.gather(counts);  // by sender and receiver
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
  Array<P, std::int64_t> there_;  // both, in the memory of the execution space
  std::int64_t everywhere_ = 0;
};

}  // namespace scree
