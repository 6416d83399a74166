// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"

#include <cmath>
#include <concepts>

namespace scree {

/// The grains of a law, as a value:
///   reads                  fields of the point that their size depends on; Fields<> if none
///   mean_diameter(point)   m
template <class G>
concept GrainSizes = requires(G const& grains, Record<detail::AnyPoint, reads_of<G>> const& point) {
  typename G::reads;
  { grains.mean_diameter(point) } -> std::convertible_to<double>;
};

/// Grains of one size.
struct UniformGrains {
  double diameter = 0;  ///< d, m
  using reads = Fields<>;
  void check() const { check_setting(diameter > 0 && std::isfinite(diameter), "diameter (m)", diameter, "above 0"); }
  template <class Point>
  SCREE_FN double mean_diameter(Point const&) const {
    return diameter;
  }
};

/// Grains of two sizes: d_avg = d_S C + d_L (1 - C) with C the concentration of the small ones, 0 to 1 (Zhu et al.
/// 2024, below eq. 2.7).
struct BidisperseGrains {
  double d_small = 0;  ///< d_S, m
  double d_large = 0;  ///< d_L, m
  using reads = Fields<Concentration>;
  void check() const {
    check_setting(d_small > 0 && std::isfinite(d_small), "d_small (m)", d_small, "above 0");
    check_setting(d_large > 0 && std::isfinite(d_large), "d_large (m)", d_large, "above 0");
  }
  template <class Point>
  SCREE_FN double mean_diameter(Point const& point) const {
    return d_large + (d_small - d_large) * double(point[concentration]);
  }
};

}  // namespace scree
