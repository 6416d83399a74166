// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "points.hpp"

#include <string>
#include <vector>

// The candidates of a search, on the host.
namespace scree::test {

template <class P, class View>
struct CountCandidates {
  View search;
  PositionSpan<P> targets;
  Span<int> lengths;
  SCREE_FN void operator()(int i) const {
    int length = 0;
    search.for_each(i, targets(i), [&](int) { ++length; });
    lengths(i) = length;
  }
};
template <class P, class View>
struct ListCandidates {
  View search;
  PositionSpan<P> targets;
  Span<int const> starts;
  Span<int> found;
  SCREE_FN void operator()(int i) const {
    int next = starts(i);
    search.for_each(i, targets(i), [&](int j) { found(next++) = j; });
  }
};

/// The candidates of each target, in the order of the search.
template <class P, class Search>
std::vector<std::vector<int>> candidates(Search const& search, Positions<P> const& targets) {
  int const n = targets.size();
  using View = decltype(search.view());
  Array<P, int> const lengths(targets.space(), "scree::test::lengths", static_cast<std::size_t>(n));
  for_each_index(targets.space(), "scree::test::count", 0, n,
                 CountCandidates<P, View>{search.view(), targets, lengths});
  std::vector<int> starts(1, 0);
  for (int const length : values_of(lengths)) starts.push_back(starts.back() + length);
  Array<P, int> const found(targets.space(), "scree::test::found", static_cast<std::size_t>(starts.back()));
  auto const starts_there = array_of<P>(targets.space(), starts);
  for_each_index(targets.space(), "scree::test::list", 0, n,
                 ListCandidates<P, View>{search.view(), targets, starts_there, found});
  auto const flat = values_of(found);
  std::vector<std::vector<int>> result;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i)
    result.emplace_back(flat.begin() + starts[i], flat.begin() + starts[i + 1]);
  return result;
}

/// Describes errors in the candidates of a search; empty if there are none. A search must offer, once each, all sources
/// within the radius of each target, found here by brute force.
template <class P>
std::string fault_of_candidates(std::vector<std::vector<int>> const& offered,
                                std::vector<Vec<P::dim, typename P::real>> const& targets,
                                std::vector<Vec<P::dim, typename P::real>> const& sources, double radius) {
  using real = typename P::real;
  if (offered.size() != targets.size()) return "wrong number of targets";
  for (std::size_t i = 0; i < targets.size(); ++i) {
    std::vector<int> times(sources.size(), 0);
    for (int const j : offered[i]) {
      if (j < 0 || j >= static_cast<int>(sources.size())) return "an index is out of range";
      ++times[static_cast<std::size_t>(j)];
    }
    for (std::size_t j = 0; j < sources.size(); ++j) {
      bool const near = (targets[i] - sources[j]).squaredNorm() < sq(real(radius));
      bool const missed = near && times[j] == 0;
      if (missed || times[j] > 1)
        return (missed ? "misses source " : "repeats source ") + std::to_string(j) + " of target " + std::to_string(i);
    }
  }
  return "";
}

}  // namespace scree::test
