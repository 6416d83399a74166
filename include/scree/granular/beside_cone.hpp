// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../laws/matsuoka_nakai.hpp"
#include "../passes/sums.hpp"
#include "strain.hpp"

#include <string>

// Detection of material in 3D that yields far from plane shear, where a circular cone does not have the strength of
// sand.
namespace scree {
namespace granular {

/// Computes three values of a particle: the load V p; the load if the particle is within 5 % of yield, otherwise 0; and
/// the second value times the relative difference between the strengths of Matsuoka & Nakai and of the cone at this
/// stress. In 2D all three are zero.
template <class Law>
struct LoadBesideCone {
  static constexpr int count = 3;
  using reads = Merge<Fields<Volume, Stress>, point_of<Law>>;
  Law law;
  template <class I>
  SCREE_FN Vec<3, double> operator()(I const& i) const {
    using namespace fields;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    if constexpr (Packed::RowsAtCompileTime == 6) {
      using Real = typename Packed::Scalar;
      StressTensor<Real> const sigma = unpacked(i[stress]), s = deviator_of(sigma);
      Real const p = pressure_of(sigma), strength = law.shear_strength(p, i);
      if (!(p > 0 && strength > 0)) return {0, 0, 0};
      double const load = double(i[volume]) * double(p), k = double(strength / p);
      if (!(equivalent_shear_stress(s) > Real(0.95) * strength)) return {load, 0, 0};
      double const ratio = MatsuokaNakai{}.ratio(k, double(cosine_of_lode_angle(s)));
      return {load, load, load * Kokkos::abs(ratio / Kokkos::min(k, 1.0) - 1)};
    } else {
      return {0, 0, 0};
    }
  }
};

}  // namespace granular

/// The difference between the strength of yielding material and the strength of sand, see beside_cone().
struct BesideCone {
  double yielding = 0;    ///< share of the load (volume times pressure) that is within 5 % of yield, 0 to 1
  double difference = 0;  ///< mean relative difference between the Matsuoka-Nakai and cone strengths
};
/// Returns the difference between the strength of yielding material in a body (WholeBody) and the strength of sand;
/// zeros in 2D. The sums are computed on the device.
template <detail::OnCircularCone Law, class Whole>
BesideCone beside_cone(Law const& law, Whole const& body) {
  auto const sums = sums_over(body, granular::LoadBesideCone<Law>{law}, "the load beside the cone");
  return {sums[0] > 0 ? sums[1] / sums[0] : 0, sums[1] > 0 ? sums[2] / sums[1] : 0};
}
/// Returns the warning about a law with a circular cone in a state in which sand has a different strength; empty for
/// other states.
[[gnu::cold]] inline std::string warning_beside_cone(BesideCone const& found) {
  if (!(found.yielding > 0.1 && found.difference > 0.1)) return "";
  return detail::formatted(
      "scree: warning: %.0f %% of the load is on material that yields far from plane shear, where the strength of sand "
      "differs by %.0f %% from that of the circular cone of the law, so that a round heap is too flat: the section "
      "MatsuokaNakai has the strength of sand (docs/choosing.md, friction)",
      100 * found.yielding, 100 * found.difference);
}

}  // namespace scree
