// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace scree::detail {

/// A loop that copies columns word by word, with adjacent threads copying adjacent words. Several threads share the
/// columns, because a thread waits for one word after another.
struct CopyColumns {
  static constexpr int most = 32;
  UntypedColumn from[most], to[most];
  int count = 0;
  int values = 0;   ///< number of values in each column
  int sharing = 1;  ///< number of threads for each value

  SCREE_FN void operator()(int thread) const {
    std::size_t const first = std::size_t(thread % values), step = std::size_t(values);
    for (int k = thread / values; k < count; k += sharing)
      for (std::size_t w = first; w < step * std::size_t(to[k].of_each); w += step) to[k].words[w] = from[k].words[w];
  }
};

/// A copy of all fields of the owned particles of a body, in device memory.
template <class Space>
class SavedFields {
 public:
  void save(UntypedParticles<Space> const& particles) { copy(particles, true); }
  /// Restores the saved fields. The number of particles must be unchanged.
  void restore(UntypedParticles<Space> const& particles) { copy(particles, false); }

 private:
  void copy(UntypedParticles<Space> const& particles, bool to_copy);

  std::vector<Memory<typename Space::memory_space>> copies_;
};

template <class Space>
void SavedFields<Space>::copy(UntypedParticles<Space> const& particles, bool to_copy) {
  ProfilingRegion const region("scree::trial");
  copies_.resize(particles.kinds());
  int const values = particles.size();
  if (values == 0) return;
  for (std::size_t first = 0; first < copies_.size(); first += CopyColumns::most) {
    CopyColumns columns;
    columns.values = values;
    for (std::size_t k = first; k < copies_.size() && columns.count < columns.most; ++k, ++columns.count) {
      if (copies_[k].size() < particles.memory(k).size()) copies_[k] = {"scree::saved", particles.memory(k).size()};
      auto const there = particles.untyped(k), copied = particles.untyped(copies_[k], k);
      columns.from[columns.count] = to_copy ? there : copied;
      columns.to[columns.count] = to_copy ? copied : there;
    }
    columns.sharing = std::min(columns.count, std::numeric_limits<int>::max() / values);
    for_each_index(particles.space(), "scree::saved", 0, values * columns.sharing, columns);
  }
}

}  // namespace scree::detail
