// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "points.hpp"
#include "two_bodies.hpp"

#include <scree/neighbours/cell_list.hpp>
#include <scree/neighbours/verlet_list.hpp>
#include <scree/passes/run_passes.hpp>
#include <scree/terms/kernel_sums.hpp>

#include <cmath>
#include <cstring>

// A small run by hand, for tests of snapshots: particles that repel each other, flow past slower ones, and cross
// periods. Any change of the order of summation shows in the last digits.
namespace scree::test {

struct PushApart {
  using reads = Fields<Volume>;
  using adds = Fields<Acceleration>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[acceleration] += -j[volume] * ij.gradW();
  }
};
template <class Real>
struct MoveOn {
  using reads = Fields<Position, Velocity, Acceleration>;
  using writes = Fields<Position, Velocity, Previous<Velocity>>;
  Real dt;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[Previous<Velocity>{}] = i[velocity];
    out[velocity] = i[velocity] + dt * i[acceleration];
    out[position] = i[position] + dt * out[velocity];
  }
};
template <class Real>
struct MoveSlowly {
  using reads = Fields<Position, KernelGradient<Material>>;
  using writes = Fields<Position>;
  Real dt;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[position] = i[position] - Real(1e-3) * dt * i[kernel_gradient<Material>];
  }
};

template <class P, template <class...> class Search>
using MovingSystem =
    TwoBodies<P, Search<P>,
              Fields<Identity, Position, Velocity, Previous<Velocity>, Acceleration, Volume, KernelSum<Material>,
                     KernelGradient<Material>, KernelSum<Wall>, KernelGradient<Wall>>,
              Fields<Identity, Position, Volume, KernelSum<Material>, KernelGradient<Material>>>;

/// The particles at the start, 256 in 2D and 512 in 3D, and 20 slow ones; positions of both bodies in the unit box.
template <class P, template <class...> class Search>
MovingSystem<P, Search> moving_system(bool periodic, double smoothing = 1.44) {
  using namespace fields;
  using real = typename P::real;
  double const spacing = P::dim == 2 ? 0.0625 : 0.125;
  std::vector<Period> periods;
  for (int axis = 0; periodic && axis < P::dim; ++axis) periods.push_back({axis, 0, 1});
  MovingSystem<P, Search> system(smoothing * spacing, periods);
  auto const fill_body = [&](auto& body, Points<P::dim> const& points) {
    body.resize(static_cast<int>(points.size()));
    body.from_host(position, cast<real>(points));
    std::vector<int> numbers;
    for (std::size_t k = 0; k < points.size(); ++k) numbers.push_back(static_cast<int>(7 * k + 3));
    body.from_host(identity, numbers);
    body.fill(volume, real(std::pow(spacing, P::dim)));
  };
  auto& material = system.template body<Material>();
  fill_body(material, lattice<P::dim>(spacing, 0.3, 1));
  fill_body(system.template body<Wall>(), random_points<P::dim>(20, 0.2, 0.8, 2));
  material.from_host(velocity, cast<real>(random_points<P::dim>(material.size(), -0.3, 0.3, 3)));
  system.positions_changed();
  return system;
}

/// Steps of 0.003 s.
template <class Sys>
void advance(Sys& system, int steps) {
  using P = typename Sys::policy;
  using real = typename P::real;
  auto const sums =
      std::tuple(pair_pass<Material>("acceleration", over<Material>(PushApart{}), over<Wall>(PushApart{})),
                 pair_pass<Material>("sums", over<Material>(KernelSums<Material>{}), over<Wall>(KernelSums<Wall>{})),
                 pair_pass<Wall>("sums of walls", over<Material>(KernelSums<Material>{})));
  for (int k = 0; k < steps; ++k) {
    system.begin_step();
    run_passes(system, sums);
    for_each_particle<P>("move on", system.template body<Material>(), MoveOn<real>{real(0.003)});
    for_each_particle<P>("move slowly", system.template body<Wall>(), MoveSlowly<real>{real(0.003)});
    system.positions_changed();
  }
}

}  // namespace scree::test
