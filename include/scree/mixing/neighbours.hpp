// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/pass.hpp"
#include "../passes/resolution.hpp"
#include "../terms/shepard.hpp"
#include "intensity.hpp"

#include <limits>

namespace scree {

/// The probability that a grain of a particle and a grain of a neighbour are of different kinds; 0 without neighbours.
struct UnlikeNeighbours : Scalar<"unlike neighbours", "1"> {};

namespace fields {
inline constexpr UnlikeNeighbours unlike_neighbours{};
}  // namespace fields

namespace detail {

/// The sums $\sum_j V_j W_{ij} (1 - \sum_k C_{k,i} C_{k,j})$ and $\sum_j V_j W_{ij}$ over the neighbours j of i,
/// without i itself.
template <class Kinds>
struct UnlikeSums {
  Kinds kinds;
  using reads = Merge<Fields<Volume>, reads_of<Kinds>>;
  using adds = Fields<UnlikeNeighbours, Weight>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using Real = typename IJ::real;
    auto const Ci = kinds(i), Cj = kinds(j);
    double unlike = 1;
    for (int k = 0; k < Kinds::kinds; ++k) unlike -= Ci[k] * Cj[k];
    auto const w = j[volume] * ij.W();
    sum[unlike_neighbours] += w * Real(unlike);
    sum[weight] += w;
  }
};
struct ShareOfUnlike {
  using reads = Fields<>;
  using writes = Fields<UnlikeNeighbours>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    out[unlike_neighbours] = total[weight] > 0 ? total[unlike_neighbours] / total[weight] : 0;
  }
};
struct VolumeOfUnlike {
  static constexpr int count = 1;
  using reads = Fields<Volume, UnlikeNeighbours>;
  template <class I>
  SCREE_FN Vec<1, double> operator()(I const& i) const {
    Vec<1, double> term;
    term[0] = double(i[fields::volume]) * double(i[fields::unlike_neighbours]);
    return term;
  }
};

}  // namespace detail

/// Diagnostics that compute `unlike_neighbours` of the material, for neighbour_index() and for output. To combine them
/// with other diagnostics, join the lists of passes (docs/theory/mixing.md).
template <class Kinds = TwoSizes>
struct NeighbourMixing {
  Kinds kinds = {};  ///< the kinds of the grains
  /// Returns the pass that computes `unlike_neighbours`.
  auto passes(Resolution const&) const {
    return std::tuple(pair_pass_then<Material>("scree::unlike_neighbours", detail::ShareOfUnlike{},
                                               over<Material>(detail::UnlikeSums<Kinds>{kinds})));
  }
};

/// The share of neighbours of a different kind.
struct NeighbourIndex {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< 1: mixed, 0: separated; NaN for a single kind
  double unlike = 0;                                        ///< mean of `unlike_neighbours`
};

/// Returns the nearest-neighbour index (Godlieb, Deen & Kuipers 2007) for concentrations: the probability that a grain
/// of a particle and a grain of a neighbour are of different kinds, divided by this probability for two grains of the
/// whole material, $\sum_k P_k (1 - P_k)$. The neighbours are all particles within the support, weighted by
/// $V_j W_{ij}$, rather than a fixed number of nearest particles, because many particles on a lattice are equally near.
///
/// The index is 1 if positions and kinds are independent, as in a uniform mixture, or in a random arrangement of
/// particles that contain one kind each. For two separated kinds that each have half of the volume, the index is twice
/// the area of their interface times the mean distance of neighbours along its normal, $\langle |z| \rangle$, divided
/// by the volume of the material. Above 1, unlike neighbours are preferred, as on a chessboard. Updates the
/// diagnostics, which must contain NeighbourMixing<Kinds>. The result is bitwise identical on any number of ranks
/// (WholeBody). Throws std::runtime_error if a value is not finite. By default, the kinds are the species in the
/// material.
template <class S, class Kinds = kinds_in<S>>
NeighbourIndex neighbour_index(S& solver, Kinds const& kinds = {}) {
  NeighbourIndex found;
  if constexpr (detail::explain_kinds<Kinds, S>()) {
    constexpr bool computed = OneOf<UnlikeNeighbours, typename detail::material_of<S>::fields>;
    static_assert(computed,
                  "no pass computes `unlike_neighbours`: name NeighbourMixing in `diagnostics` of the formulation");
    if constexpr (computed) {
      char const* const what = "the index of the neighbours";
      solver.update_diagnostics();
      auto const whole = detail::means_of_kinds(solver, kinds, what);
      double const unlike = sums_over(solver.whole(), detail::VolumeOfUnlike{}, what)[0];
      found.unlike = whole.volume > 0 ? unlike / whole.volume : 0;
      double const of_all = detail::variance_of_separated(whole.mean);
      if (of_all > 0) found.value = found.unlike / of_all;
    }
  }
  return found;
}

}  // namespace scree
