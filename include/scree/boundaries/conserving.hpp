// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "adami.hpp"
#include "mirror_lens.hpp"

#include <tuple>
#include <type_traits>

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
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& wall, J const& m, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const slip = m[velocity] - wall[velocity] + wall[velocity_gradient] * ij.x;
    sum[slip_gradient] += outer(m[volume] * slip, ij.gradW());
  }
};

/// The mirrored velocity of adami::ExtrapolateVelocity, for the viscosity, and the gradient of u': that sum over the
/// sum of V W. It is none where the wall is a mirror.
template <class Mirrors>
struct VelocityAndGradient {
  using reads = Merge<adami::ExtrapolateVelocity::reads, reads_of<Mirrors>>;
  using writes = Fields<DummyVelocity, SlipGradient>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    adami::ExtrapolateVelocity{}(wall, total, out);
    out[slip_gradient] = zero<std::remove_cvref_t<decltype(out[slip_gradient])>>();
    auto const w = total[weight];
    if (w > 0 && !(Mirrors{}(wall) > 0)) out[slip_gradient] = total[slip_gradient] / w;
  }
};

/// `image()` where `mirrors` is positive, otherwise `mean`: small vectors or matrices of numbers or of packs.
template <class Real, class Image, class X>
SCREE_FN X where_positive(Real const& mirrors, Image const& image, X mean) {
  using namespace math;
  if constexpr (std::is_floating_point_v<Real>) {
    if (mirrors > 0) mean = image();
  } else {
    X const other = image();
    for (int k = 0; k < X::SizeAtCompileTime; ++k)
      mean.data()[k] = select(mirrors > 0, other.data()[k], mean.data()[k]);
  }
  return mean;
}

/// The sum over the wall in the velocity gradient: $\sum_d V_d [(u_w(x_d) - u_i) \otimes \nabla W_{id} + W_{id} G_d]$
/// with the slip gradient G. Where the wall is a mirror, in place of the last term the same pair in the mirror, $-R (u'
/// \otimes \nabla W_{id}) R$ with u' = u_i - u_w(x_i), R = 1 - 2 n n^T at a slip wall and R = 1 elsewhere.
template <class Mirrors>
struct WallStrain {
  using reads = Fields<>;
  using reads_i = Fields<Velocity>;
  using reads_j = Merge<Fields<Volume, Velocity, VelocityGradient, SlipNormal, SlipGradient>, reads_of<Mirrors>>;
  using adds = Fields<VelocityGradient>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const difference = j[velocity] - i[velocity];
    auto const gradW = ij.gradW();
    auto const pair = outer(difference, gradW), mean = ij.W() * j[slip_gradient];
    auto const image = [&] {
      auto const slip = difference + j[velocity_gradient] * ij.x;
      auto const in_mirror = [&](auto const& x) { return x - 2 * dot(j[slip_normal], x) * j[slip_normal]; };
      return outer(in_mirror(slip), in_mirror(gradW));
    };
    sum[velocity_gradient] += j[volume] * (pair + where_positive(Mirrors{}(j), image, mean));
  }
};

/// A lens: where `Mirrors`, a function of a wall particle, is positive, it shows the material its mirror image,
/// elsewhere means of the material.
template <class Rho, class Mirrors>
struct Lens {
  MirrorLens<Rho> mirror;
  bool operator==(Lens const&) const = default;
  static constexpr bool takes_packs = true;
  using provides = Fields<Velocity, Stress>;
  using reads = Merge<reads_of<MirrorLens<Rho>>, reads_of<Mirrors>, Fields<DummyVelocity, Stress>>;
  using reads_i = reads_i_of<MirrorLens<Rho>>;

  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const& i, J const& j) const {
    using namespace fields;
    return where_positive(
        Mirrors{}(j), [&] { return mirror(velocity, i, j); }, j[dummy_velocity]);
  }
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using namespace fields;
    return where_positive(
        Mirrors{}(j), [&] { return mirror(stress, i, j); }, j[stress]);
  }
};

/// ConservingWalls that are mirrors where `Mirrors` says so.
template <class Mirrors>
struct Walls : ExtrapolatedWalls<adami::ExtrapolateStress> {
  auto velocity_passes() const {
    return std::tuple(
        pair_pass_then<Wall>("scree::wall_velocity", VelocityAndGradient<Mirrors>{},
                             over<Material>(adami::Weights{}, adami::Weighted<Velocity>{}, SlipGradientSum{})));
  }
  template <class Rho>
  Lens<Rho, Mirrors> lens(Rho const& rho, Gravity const& gravity) const {
    return {{rho, gravity}};
  }
  WallStrain<Mirrors> strain_term() const { return {}; }
};

/// Positive at walls with a `slip_normal`.
struct SlipWalls {
  using reads = Fields<SlipNormal>;
  template <class J>
  SCREE_FN auto operator()(J const& j) const {
    return squared_norm(j[fields::slip_normal]);
  }
};

}  // namespace conserving

/// Walls of dummy particles that show the mean stress of the material in front of them, as AdamiWalls, and keep its
/// energy. The force of a wall on i is $\sum_d V_d \langle\sigma\rangle_d \nabla W_{id}$; its work is taken from the
/// elastic energy if the velocity gradient at k has $\sum_d V_d [(u_w(x_d) - u_k) \otimes \nabla W_{kd} + W_{kd} G_d]$
/// with $G_d = \sum_m V_m u'_m \otimes \nabla_d W_{dm}/\sum_m V_m W_{dm}$ in place of the difference from a mirrored
/// velocity. It is exact for velocities that grow linearly from the wall. Walls with a `slip_normal` are mirrors: a
/// pair and its mirror image are strained alike. Energy is kept with PlainStrain, the default; CorrectedStrain takes
/// the mirrored velocities of AdamiWalls.
struct ConservingWalls : conserving::Walls<conserving::SlipWalls> {};

}  // namespace scree
