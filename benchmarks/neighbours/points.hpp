// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/by_hand/lists.hpp"
#include "../support/cloud.hpp"
#include "../support/kept.hpp"
#include "../support/timing.hpp"

#include <scree/neighbours/neighbours.hpp>

namespace scree::bench {

inline constexpr double smoothing =
    1.25;                            ///< over the spacing: in 3D 66 neighbours in the support, 88 with a skin of 0.1
inline constexpr double skin = 0.1;  ///< of lists by hand

template <class P>
Positions<P> on_device(std::vector<Vec<P::dim, double>> const& points) {
  return array_of<P>(cast<typename P::real>(points));
}

/// The points of a row at two times, between which all of them cross the skin of a list: a search that is updated for
/// one after the other is rebuilt at each call.
template <class P>
struct TwoTimes {
  double support;
  Positions<P> now, then;
  explicit TwoTimes(int about) : TwoTimes(cloud_of<P::dim>(about, smoothing)) {}

 private:
  explicit TwoTimes(Cloud<P::dim> const& cloud) : support(cloud.support), now(on_device<P>(cloud.points)) {
    auto moved = cloud.points;
    for (auto& x : moved) x[0] += support;
    then = on_device<P>(moved);
  }
};

template <class P>
std::string row_name(std::string const& what, std::string const& who, int particles) {
  return fmt::format("neighbours/{}/{}/{}/particles:{}", what, who, basis_name<P>(), particles);
}

}  // namespace scree::bench
