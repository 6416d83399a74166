// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/boundaries/adami.hpp>

namespace inclined_flow {

/// In addition to (4.3) of Zhu et al. (2024), extrapolates the shear stress into a floor under the last coordinate: in
/// uniform flow d(sigma_xz)/dz = -rho g_x, so that sigma_d,xz = <sigma_xz> - rho (g_x - a_w,x) <z_d - z_m>. Without it
/// the floor carries too little shear stress for the weight, and the lowest row of particles slips.
template <class Rho>
struct ContinueShear : scree::adami::ExtrapolateStress<Rho> {
  using base = scree::adami::ExtrapolateStress<Rho>;
  ContinueShear(Rho const& rho, scree::Gravity const& gravity) : base{rho, gravity} {}
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    base::operator()(wall, total, out);
    using vector = std::remove_cvref_t<decltype(wall[scree::acceleration])>;
    using Real = typename vector::Scalar;
    constexpr int dim = vector::RowsAtCompileTime, shear = dim == 2 ? 3 : 4;
    Real const w = total[scree::weight];
    if (!(w > 0)) return;
    Real const rho = scree::adami::mean_density(this->rho, total);
    vector const force = rho * (this->gravity.template vector<vector>() - wall[scree::acceleration]);
    out[scree::stress][shear] -= force[0] * total[scree::weighted_offset][dim - 1] / w;
  }
};

/// Walls of dummy particles for a rough floor under a slope.
struct SlopeWalls : scree::ExtrapolatedWalls<ContinueShear> {};

}  // namespace inclined_flow
