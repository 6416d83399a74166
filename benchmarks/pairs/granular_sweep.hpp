// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/kept.hpp"
#include "../support/timing.hpp"
#include "random_fields.hpp"
#include "sum_rows.hpp"

#include <scree/formulation/formulation.hpp>
#include <scree/granular/granular.hpp>

// The sweep that computes all rates of a granular material: velocity gradient, first moment, number density, stress
// divergence, artificial viscosity, and the law that computes rates from their sums.
namespace scree::bench {

struct GranularBodyModels : GranularModels {
  using volume_control = VolumeConsistency;
  using walls = AdamiWalls;
};
template <class P>
struct GranularBody : Formulation<P::dim, typename P::real> {
  using physics = Granular<GranularBodyModels>;
};

/// A body without walls and the passes of the physics.
template <class P>
struct GranularSweep {
  using Body = GranularBody<P>;
  using reads = Without<material_fields<Body>, Fields<Identity, Position, Volume>>;
  typename Body::physics physics;
  Resolution resolution;
  system_of<Body> system;
  double pairs;

  explicit GranularSweep(Cloud<P::dim> const& cloud)
      : resolution{.spacing = cloud.spacing, .smoothing_length = cloud.smoothing_length, .support = cloud.support},
        system(cloud.smoothing_length, {}),
        pairs(SelfSum<P>(cloud, {}).pairs) {
    physics.law = GranularModels::law{.elastic = {1e6, 0.3, 1500}, .grains = {1e-3}};
    populate(system.template body<Material>(), cloud, reads{});
    system.positions_changed();
  }
  /// The last of the passes; the pass of the walls comes before it.
  void run() {
    auto const passes = rate_passes(physics, resolution);
    std::get<std::tuple_size_v<decltype(passes)> - 1>(passes).run(system);
  }
};

template <class P>
int add_granular_rows() {
  double const smoothing = 1.5;
  for (int const particles : sizes<P>()) {
    auto const name = fmt::format("pairs/granular_sweep/{}/h:{}/particles:{}", basis_name<P>(), smoothing, particles);
    add_row(name, [=](benchmark::State& state) {
      auto& sweep = kept(name, [&] { return GranularSweep<P>(cloud_of<P::dim>(particles, smoothing)); });
      time(state, together, [&] { sweep.run(); });
      count_pairs(state, sweep.system.template body<Material>().size(), sweep.pairs);
    });
  }
  return 0;
}

}  // namespace scree::bench
