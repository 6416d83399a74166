// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/pack.hpp"
#include "../passes/pass.hpp"
#include "../terms/antisymmetric_stress.hpp"
#include "adami.hpp"
#include "slip_normal.hpp"

#include <tuple>
#include <type_traits>

// The antisymmetric stress (terms/antisymmetric_stress.hpp) that walls show: what they show of the symmetric part.
namespace scree {
namespace walls {

/// The antisymmetric stress of a wall particle: the mean of the material in front of it.
struct MeanAntisymmetricStress {
  using reads = Fields<>;
  using writes = Fields<AntisymmetricStress>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    using Axial = std::remove_cvref_t<decltype(out[antisymmetric_stress])>;
    auto const w = total[weight];
    out[antisymmetric_stress] = w > 0 ? Axial(total[WeightedSum<AntisymmetricStress>{}] / w) : zero<Axial>();
  }
};

/// The part of an antisymmetric tensor (axial vector a) without shear along a plane with the unit normal n: in space
/// the rotation about n, in the plane nothing. All of it where n is zero.
template <class Axial, class X>
SCREE_FN Axial without_shear(Axial const& a, X const& n) {
  using namespace math;
  auto const nn = squared_norm(n);
  Axial result = a;
  if (!any_positive(nn)) return result;
  for (int k = 0; k < Axial::RowsAtCompileTime; ++k) {
    if constexpr (X::RowsAtCompileTime == 3)
      result[k] = select(nn > 0, dot(n, a) * n[k], a[k]);
    else
      result[k] = select(nn > 0, 0 * a[k], a[k]);
  }
  return result;
}

}  // namespace walls

/// The part of walls in AntisymmetricStressDivergence: $(1/\rho_i) \sum_d V_d (a_i + a_d) \times \nabla W_{id}$, where
/// a wall shows the mean of the material (`ShowsMeans`) or to each particle its own a_i, and at a slip wall no shear
/// along the wall.
template <class Rho, bool ShowsMeans>
struct AntisymmetricStressAtWall {
  static_assert(detail::explain_density<Rho>());
  Rho rho;  ///< of i
  using reads = Fields<>;
  using reads_i = Merge<Fields<AntisymmetricStress>, typename Rho::reads>;
  using reads_j =
      Merge<Fields<Volume, SlipNormal>, std::conditional_t<ShowsMeans, Fields<AntisymmetricStress>, Fields<>>>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto both = i[antisymmetric_stress];
    if constexpr (ShowsMeans)
      both += j[antisymmetric_stress];
    else
      both += i[antisymmetric_stress];
    sum[acceleration] +=
        (rho.inverse_of(i) * j[volume] * ij.slope()) * cross(walls::without_shear(both, j[slip_normal]), ij.x);
  }
};

}  // namespace scree
