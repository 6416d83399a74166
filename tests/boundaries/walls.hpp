// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/boundaries/adami.hpp>
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>
#include <scree/passes/fuse.hpp>
#include <scree/terms/gravity.hpp>

#include <support/formulations.hpp>

// The wall as seen by the material, for tests of wall schemes: the passes of the scheme, and sums over the wall through
// its lens.
namespace scree::test {

constexpr double wall_density = 1500, wall_gravity = 9.81;

/// A scheme for walls as diagnostics of a formulation in which nothing evolves; material particles get sum_j V_j W_ij
/// (u_j, sigma_j, x_i - x_j) over the wall.
template <class Walls>
struct WallSums {
  Walls walls = {};
  Gravity gravity = {.magnitude = wall_gravity};
  auto passes(Resolution const&) const {
    auto const lens = walls.lens(UniformDensity{wall_density}, gravity);
    return std::tuple_cat(
        fused(std::tuple_cat(walls.velocity_passes(), walls.stress_passes(UniformDensity{wall_density}, gravity))),
        std::tuple(pair_pass<Material>(
            "scree::test::walls",
            over_through<Wall>(lens, adami::Weights{}, adami::Weighted<Velocity>{}, adami::Weighted<Stress>{}))));
  }
};
template <class Q, class Walls, class Motion>
using WallFormulation = Formulated<Q, NothingEvolves, Motion, WallSums<Walls>>;

/// A bed with a wall below and on all sides, at time zero of a motion.
template <class Q, class Walls, class Motion>
Solver<WallFormulation<Q, Walls, Motion>> walled_bed(Motion const& motion = {}) {
  constexpr int dim = Q::dim;
  Vec<dim, double> size = Vec<dim, double>::Constant(0.6);
  auto solver = solver_of<WallFormulation<Q, Walls, Motion>>(open_bed<dim>(size, 0.1), 0.1, {}, motion);
  return solver;
}

/// Means over the wall as seen by one particle of the material.
template <class P>
struct SeenOfWall {
  double weight;
  Vec<P::dim, double> x;  ///< m, of the wall
  Vec<P::dim, double> u;  ///< m/s
  Vec<symmetric3_size<P::dim>, double> sigma;
};
/// For all particles of the material with the wall in their support.
template <class S, class P = typename S::policy>
std::vector<SeenOfWall<P>> seen_of_wall(S& solver) {
  using namespace fields;
  solver.update_diagnostics();
  auto const& body = solver.material();
  auto const x = body.to_host(position), offset = body.to_host(weighted_offset);
  auto const u = body.to_host(WeightedSum<Velocity>{});
  auto const sigma = body.to_host(WeightedSum<Stress>{});
  auto const w = body.to_host(weight);
  std::vector<SeenOfWall<P>> seen;
  for (std::size_t i = 0; i < x.size(); ++i) {
    // A sum of a few units in the last place of that over a full support is rounding, not a wall.
    if (!(w[i] > 1e-3)) continue;
    seen.push_back({double(w[i]), ((x[i] - offset[i] / w[i]).template cast<double>()),
                    (u[i] / w[i]).template cast<double>(), (sigma[i] / w[i]).template cast<double>()});
  }
  return seen;
}

/// Largest value of a function over all `Seen`; infinite if there are none or a value is NaN.
template <class Seen, class Function>
double worst_of(Seen const& seen, Function const& error) {
  std::vector<double> all;
  for (auto const& one : seen) all.push_back(error(one));
  return all.empty() ? std::numeric_limits<double>::infinity() : largest_of(all);
}

/// Geostatic stress under a surface at z = 0.6, sides at K0 times the vertical stress.
template <int Dim>
Vec<symmetric3_size<Dim>, double> geostatic(double z, double g = wall_gravity, double K0 = 0.5) {
  Vec<symmetric3_size<Dim>, double> sigma = Vec<symmetric3_size<Dim>, double>::Zero();
  double const vertical = -wall_density * g * (0.6 - z);
  for (int a = 0; a < 3; ++a) sigma[a] = K0 * vertical;
  sigma[Dim - 1] = vertical;
  return sigma;
}

/// The stress component along gravity, Pa.
template <int Dim, class Sigma>
double vertical_error(Vec<Dim, double> const& x, Sigma const& sigma) {
  return std::abs(sigma[Dim - 1] - geostatic<Dim>(x[Dim - 1])[Dim - 1]);
}
template <class S>
void set_geostatic(S& solver, double g = wall_gravity, double K0 = 0.5) {
  using P = typename S::policy;
  solver.set(fields::stress, [g, K0](auto const& x) {
    return geostatic<P::dim>(double(x[P::dim - 1]), g, K0).template cast<typename P::real>().eval();
  });
}

/// Angular velocity times x, for a rotation about the origin.
template <int Dim>
Vec<Dim, double> turning(double rate, Vec<Dim, double> const& x) {
  return Rotation{.rate = rate}.velocity(x, 0);
}

using OnHost2 = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

}  // namespace scree::test
