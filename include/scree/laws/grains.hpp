// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/species.hpp"
#include "law.hpp"

#include <algorithm>
#include <concepts>

namespace scree {

/// The grain sizes of a law are a struct with these members:
///   reads                  fields of the point that the grain size depends on; Fields<> if there are none
///   mean_diameter(point)   the mean diameter of the grains at a point, m
template <class G>
concept GrainSizes = requires(G const& grains, Record<detail::AnyPoint, reads_of<G>> const& point) {
  typename G::reads;
  { grains.mean_diameter(point) } -> std::convertible_to<double>;
};

/// Grains of one size.
struct UniformGrains {
  double diameter = 0;  ///< d
  using reads = Fields<>;
  static constexpr auto parameters() {
    return std::array{
        parameter("diameter", &UniformGrains::diameter, "m", "diameter of the grains", allowed::above(0))};
  }
  /// Throws std::invalid_argument if the diameter is out of range.
  void check() const { check_parameters(*this); }
  template <class Point>
  SCREE_FN double mean_diameter(Point const&) const {
    return diameter;
  }
};

/// Grains of two sizes: d_avg = d_S C + d_L (1 - C), with C the concentration of the small grains, 0 to 1 (Zhu et al.
/// 2024, below eq. 2.7).
struct BidisperseGrains {
  double d_small = 0;  ///< d_S
  double d_large = 0;  ///< d_L
  using reads = Fields<Concentration>;
  static constexpr auto parameters() {
    return std::array{
        parameter("d_small", &BidisperseGrains::d_small, "m", "diameter of the small grains", allowed::above(0)),
        parameter("d_large", &BidisperseGrains::d_large, "m", "diameter of the large grains", allowed::above(0))};
  }
  /// Throws std::invalid_argument if a diameter is out of range.
  void check() const { check_parameters(*this); }
  template <class Point>
  SCREE_FN double mean_diameter(Point const& point) const {
    return d_large + (d_small - d_large) * double(point[fields::concentration]);
  }
};

/// Grains of N sizes: $d_{\mathrm{avg}} = \sum_k C_k d_k$.
template <int N>
struct PolydisperseGrains {
  Vec<N, double> diameters = zero<Vec<N, double>>();  ///< d_k, m
  using reads = Fields<Concentrations<N>>;
  /// Throws std::invalid_argument if a diameter is out of range.
  void check() const { check_diameters<N>(diameters, "PolydisperseGrains"); }
  template <class Point>
  SCREE_FN double mean_diameter(Point const& point) const {
    return mean_of_species(point[fields::concentrations<N>], diameters);
  }
};

/// Returns the largest grain diameter of a law, m; for ByGroup the largest of all groups. It is 0 for laws without
/// grains and for user-defined grains.
template <class Law>
double largest_diameter(Law const& law) {
  double largest = 0;
  if constexpr (requires { double(law.grains.diameter); })
    largest = law.grains.diameter;
  else if constexpr (requires { double(law.grains.d_small + law.grains.d_large); })
    largest = std::max(law.grains.d_small, law.grains.d_large);
  else if constexpr (requires { double(law.grains.diameters.maxCoeff()); })
    largest = law.grains.diameters.maxCoeff();
  else if constexpr (requires { law.of(law.groups()); })
    for (int k = 0; k < law.groups(); ++k) largest = std::max(largest, largest_diameter(law.of(k)));
  return largest;
}

}  // namespace scree
