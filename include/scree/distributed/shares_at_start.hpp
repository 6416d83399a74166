// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/bodies.hpp"
#include "../fields/groups.hpp"
#include "../rigid/settings.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

// Checks of a case whose ranks begin with shares of the particles. Start is a BodyAtStart (solver/body_at_start.hpp).
namespace scree::detail {

/// Whether any body of a case begins from shares.
template <class List, class Start>
bool begins_from_shares(PerBody<Start, List> const& start) {
  return std::any_of(start.all.begin(), start.all.end(), [](auto const& body) { return body.is_share; });
}

/// Throws std::invalid_argument unless the ranges on all ranks together contain each number exactly once. `ranges` has
/// `of_each` ranges for each rank.
[[gnu::cold]] inline void check_ranges(std::vector<RangeHere> const& ranges, std::size_t of_each,
                                       std::string const& name_of_body) {
  for (std::size_t group = 0; group < of_each; ++group) {
    std::vector<IdentityRange> here;
    IdentityRange const all = ranges[group].all;
    for (std::size_t k = group; k < ranges.size(); k += of_each) {
      auto const& other = ranges[k].all;
      if (other.first != all.first || other.last != all.last)
        throw std::invalid_argument(
            formatted("scree: the ranks have shares of different points of the %s: of %d on rank 0, of %d on rank %zu",
                      name_of_body.c_str(), all.size(), other.size(), k / of_each));
      if (ranges[k].here.size() > 0) here.push_back(ranges[k].here);
    }
    std::sort(here.begin(), here.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
    here.push_back({all.last, all.last});
    int next = all.first;
    for (IdentityRange const& range : here) {
      if (range.first != next)
        throw std::invalid_argument(formatted(
            "scree: the shares of the %s do not fit: particle %d of %d is given on %s rank; each rank gives its own "
            "share, team.share()",
            name_of_body.c_str(), std::min(range.first, next), all.size(),
            range.first < next ? "more than one" : "no"));
      next = range.last;
    }
  }
}

/// Throws std::invalid_argument unless all ranks have groups with the same names in the same order.
template <class Start, class Ranks>
[[gnu::cold]] void check_same_groups(Start const& body, Ranks const& ranks, std::string const& name_of_body) {
  std::string names;
  for (auto const& name : body.names) (names += name) += '\n';
  std::vector<std::size_t> const here = {body.ranges.size(), std::hash<std::string>()(names)};
  auto const all = ranks.of_all(here);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k] != here[k % here.size()])
      throw std::invalid_argument("scree: the ranks have other groups of the " + name_of_body +
                                  ": each rank adds all groups in the same order, also where its share is empty");
}

/// Throws std::invalid_argument unless the shares of each body fit together and no body is rigid. All ranks call this
/// function together.
template <class List, class Start, class Ranks>
[[gnu::cold]] void check_shares(PerBody<Start, List> const& start, Ranks const& ranks) {
  if (has_rigid_bodies<List>)
    throw std::invalid_argument(
        "scree: a case with rigid bodies cannot begin from shares: the surfaces of bodies and walls are found while "
        "each rank has the whole case; give all points whole");
  for_each_body(List{}, [&]<class Body>() {
    auto const& body = start.template of<Body>();
    std::string const name(Body::name);
    if (!body.is_share && !body.points.empty())
      throw std::invalid_argument("scree: the " + name +
                                  " is given whole, and other bodies in shares: give share_of(points, team.share())");
    check_same_groups(body, ranks, name);
    check_ranges(ranks.of_all(body.ranges), body.ranges.size(), name);
  });
}

}  // namespace scree::detail
