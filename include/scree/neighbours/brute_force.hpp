// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "neighbours.hpp"

namespace scree {

/// A search in which every source is a candidate for every target. It is the reference for the other searches.
template <class P>
class BruteForce {
 public:
  struct View {
    int sources = 0;
    /// Calls f(j) for each source, or only for the sources that belong to a lane.
    template <class F>
    SCREE_LOOP_FN void for_each(int, Vec<P::dim, typename P::real> const&, F const& f, LaneRange range = {}) const {
      for (int j = range.lane; j < sources; j += range.lanes) f(j);
    }
  };

  /// Ignores the radius, because all sources are candidates.
  explicit BruteForce(double) {}
  void update(Positions<P> const&, Positions<P> const& sources) { view_.sources = sources.size(); }
  View view() const { return view_; }
  long builds() const { return 0; }

 private:
  View view_;
};

}  // namespace scree
