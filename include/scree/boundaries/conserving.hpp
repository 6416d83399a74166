// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "adami.hpp"
#include "mirror_lens.hpp"

#include <tuple>

// Walls that show means of the stress, like those of adami.hpp, and keep the energy of the material: the strain rates
// next to them are the adjoint of their forces.
namespace scree {

/// $\langle \partial u'/\partial x\rangle$ in a wall, of the velocity u' relative to the wall.
struct SlipGradient : Tensor<"slip gradient", "1/s"> {};

namespace fields {
inline constexpr SlipGradient slip_gradient{};
}  // namespace fields

namespace conserving {

/// $\sum_m V_m u'_m \otimes \nabla_d W_{dm}$ over the material, with u' = u_m - u_w(x_m).
struct SlipGradientSum {
  using reads = Fields<>;
  using reads_i = Fields<Velocity, VelocityGradient>;
  using reads_j = Fields<Volume, Velocity>;
  using adds = Fields<SlipGradient>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& wall, J const& m, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const slip = m[velocity] - wall[velocity] + wall[velocity_gradient] * ij.x;
    sum[slip_gradient] += outer(m[volume] * slip, ij.gradW());
  }
};

/// The mirrored velocity of adami::ExtrapolateVelocity, for the viscosity, and the gradient of u': that sum over the
/// sum of V W. It is none at a slip wall.
struct VelocityAndGradient {
  using reads = adami::ExtrapolateVelocity::reads;
  using writes = Fields<DummyVelocity, SlipGradient>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    adami::ExtrapolateVelocity{}(wall, total, out);
    auto const w = total[weight];
    bool const holds = w > 0 && !(squared_norm(wall[slip_normal]) > 0);
    out[slip_gradient] = zero<std::remove_cvref_t<decltype(out[slip_gradient])>>();
    if (holds) out[slip_gradient] = total[slip_gradient] / w;
  }
};

/// Adds $\sum_d V_d W_{id} G_d$ to the velocity gradient, with the slip gradient G of walls.
struct SlipStrain {
  using reads = Fields<>;
  using reads_j = Fields<Volume, SlipGradient>;
  using adds = Fields<VelocityGradient>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[velocity_gradient] += j[volume] * ij.W() * j[slip_gradient];
  }
};

/// At slip walls a mirror, which keeps energy by itself; at others the mean stress and `Shown`, a velocity.
template <class Rho, class Shown>
struct Lens {
  MirrorLens<Rho> mirror;
  bool operator==(Lens const&) const = default;
  using provides = Fields<Velocity, Stress>;
  using reads = Merge<reads_of<MirrorLens<Rho>>, Fields<Shown, Stress>>;
  using reads_i = reads_i_of<MirrorLens<Rho>>;

  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const& i, J const& j) const {
    using vector = std::remove_cvref_t<decltype(j[fields::velocity])>;
    return slips(j) ? vector(mirror(fields::velocity, i, j)) : vector(j[Shown{}]);
  }
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using Packed = std::remove_cvref_t<decltype(j[fields::stress])>;
    return slips(j) ? Packed(mirror(fields::stress, i, j)) : Packed(j[fields::stress]);
  }

 private:
  template <class J>
  SCREE_FN static bool slips(J const& j) {
    return squared_norm(j[fields::slip_normal]) > 0;
  }
};

}  // namespace conserving

/// AdamiWalls that keep the energy of the material. The stress of a wall particle is the mean of the material, so its
/// force on i is $\sum_d V_d \langle\sigma\rangle_d \nabla W_{id}$; its work is taken from the elastic energy if the
/// velocity gradient at k has $\sum_d V_d [(u_w(x_d) - u_k) \otimes \nabla W_{kd} + W_{kd} G_d]$ with $G_d = \sum_m V_m
/// u'_m \otimes \nabla_d W_{dm}/\sum_m V_m W_{dm}$ in place of the difference from a mirrored velocity. It is exact for
/// velocities that grow linearly from the wall. Energy is kept with PlainStrain, the default, not with CorrectedStrain.
/// Walls with a `slip_normal` are mirrors.
struct ConservingWalls : ExtrapolatedWalls<adami::ExtrapolateStress> {
  auto velocity_passes() const {
    return std::tuple(pair_pass_then<Wall>(
        "scree::wall_velocity", conserving::VelocityAndGradient{},
        over<Material>(adami::Weights{}, adami::Weighted<Velocity>{}, conserving::SlipGradientSum{})));
  }
  template <class Rho>
  conserving::Lens<Rho, DummyVelocity> lens(Rho const& rho, Gravity const& gravity) const {
    return {{rho, gravity}};
  }
  /// The lens for strain rates.
  template <class Rho>
  conserving::Lens<Rho, Velocity> strain_lens(Rho const& rho, Gravity const& gravity) const {
    return {{rho, gravity}};
  }
  /// Terms over the wall that strain rates have in addition.
  std::tuple<conserving::SlipStrain> strain_terms() const { return {}; }
};

}  // namespace scree
