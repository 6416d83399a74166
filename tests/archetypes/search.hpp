// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/neighbours/neighbours.hpp>

namespace scree::test::archetypes {

/// Offers all sources.
template <class P>
class Search {
 public:
  struct View {
    int sources = 0;
    template <class F>
    SCREE_LOOP_FN void for_each(int, Vec<P::dim, typename P::real> const&, F const& f, LaneRange range) const {
      for (int j = range.lane; j < sources; j += range.lanes) f(j);
    }
  };
  explicit Search(double) {}
  void update(Positions<P> const&, Positions<P> const& sources) { view_.sources = sources.size(); }
  View view() const { return view_; }
  long builds() const { return 0; }

 private:
  View view_;
};

}  // namespace scree::test::archetypes
