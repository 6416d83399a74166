// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/pack.hpp"
#include "../passes/pass.hpp"
#include "../terms/antisymmetric_stress.hpp"
#include "adami.hpp"
#include "on_plate.hpp"
#include "slip_normal.hpp"

#include <tuple>
#include <type_traits>

// The antisymmetric stress (terms/antisymmetric_stress.hpp) of walls, computed in the same way as the symmetric part.
namespace scree {
namespace walls {

/// Computes the antisymmetric stress of a wall particle, the mean of the material in front of it.
struct MeanAntisymmetricStress {
  using reads = Fields<>;
  using writes = Fields<AntisymmetricStress>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    using A = std::remove_cvref_t<decltype(out[antisymmetric_stress])>;
    auto const w = total[weight];
    out[antisymmetric_stress] = w > 0 ? A(total[WeightedSum<AntisymmetricStress>{}] / w) : zero<A>();
  }
};

/// Returns the part of an antisymmetric tensor (axial vector a) that has no shear along a plane with the unit normal n:
/// in 3D the rotation about n, in 2D zero. If n is zero, returns the whole tensor.
template <class A, class X>
SCREE_FN A without_shear(A const& a, X const& n) {
  using namespace math;
  auto const nn = squared_norm(n);
  A result = a;
  if (!any_positive(nn)) return result;
  for (int k = 0; k < A::RowsAtCompileTime; ++k) {
    if constexpr (X::RowsAtCompileTime == 3)
      result[k] = select(nn > 0, dot(n, a) * n[k], a[k]);
    else
      result[k] = select(nn > 0, 0 * a[k], a[k]);
  }
  return result;
}

}  // namespace walls

/// The antisymmetric stress of a wall particle in the sum of a material particle: `mean`, the mean of the material;
/// `own`, the stress of the material particle itself; `own_on_plates`, its own stress on plates and the mean elsewhere.
enum class ShownByWall { mean, own, own_on_plates };

/// Pair term for the part of walls in AntisymmetricStressDivergence, $(1/\rho_i) \sum_d V_d (a_i + a_d) \times \nabla
/// W_{id}$, with a_d chosen by ShownByWall. At a slip wall the shear along the wall is removed.
template <class Rho, ShownByWall Shown>
struct AntisymmetricStressAtWall {
  static_assert(detail::explain_density<Rho>());
  static constexpr bool own = Shown == ShownByWall::own, plates = Shown == ShownByWall::own_on_plates;
  Rho rho;  ///< of i
  using reads = Fields<>;
  using reads_i = Merge<Fields<AntisymmetricStress>, typename Rho::reads>;
  using reads_j = Merge<Fields<Volume, SlipNormal>, std::conditional_t<own, Fields<>, Fields<AntisymmetricStress>>,
                        std::conditional_t<plates, Fields<OnPlate>, Fields<>>>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    auto shown = i[antisymmetric_stress];
    if constexpr (!own) shown = j[antisymmetric_stress];
    if constexpr (plates)
      for (int k = 0; k < decltype(shown)::RowsAtCompileTime; ++k)
        shown[k] = select(j[on_plate] > 0, i[antisymmetric_stress][k], shown[k]);
    sum[acceleration] += (rho.inverse_of(i) * j[volume] * ij.slope()) *
                         cross(walls::without_shear(i[antisymmetric_stress] + shown, j[slip_normal]), ij.x);
  }
};

}  // namespace scree
