// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/loop.hpp"
#include "../fields/particles.hpp"

namespace scree {
namespace detail {

/// A loop that writes the indices of the particles that satisfy a condition, or of all other particles, in ascending
/// order.
template <class P, class Condition>
struct Pick {
  Condition condition;
  Columns<P, reads_of<Condition>> reads;
  Span<int> picked;
  bool wanted;

  SCREE_FN void operator()(int i, int& count, bool last) const {
    if (bool(condition(reads.load(i))) != wanted) return;
    if (last) picked(count) = i;
    ++count;
  }
};

}  // namespace detail

/// Returns the indices of the owned particles of a body for which `condition(i)` equals `wanted`, in ascending order. A
/// condition has a list `reads`, like a term.
template <class Condition, class Body>
auto pick(Body const& body, Condition const& condition, bool wanted = true) {
  using P = typename Body::policy;
  static_assert(std::is_invocable_r_v<bool, Condition const&, Record<P, reads_of<Condition>> const&>,
                "a condition is a struct with a list `reads`, using reads = Fields<Position>, and a function of a "
                "particle that returns a bool: template <class I> SCREE_FN bool operator()(I const& i) const");
  ProfilingRegion const region("scree::pick");
  Array<P, int> const all(body.space(), "scree::picked", static_cast<std::size_t>(body.size()));
  detail::Pick<P, Condition> const loop{condition, body.select(reads_of<Condition>{}), all, wanted};
  int const count = running_sum(body.space(), "scree::pick", body.size(), loop);
  return Array<P, int const>(all.part(0, count));
}

}  // namespace scree
