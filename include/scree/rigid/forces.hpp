// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/loop.hpp"
#include "../terms/wall_force.hpp"
#include "state.hpp"

#include <cmath>
#include <vector>

// Force and moment on rigid bodies: sums over their particles in a fixed order, so that runs repeat bit for bit on
// every backend. A body with n particles has about sqrt(n) portions; one thread sums the particles of a portion,
// another the portions of a body.
namespace scree::detail {

template <int Dim>
struct RigidLoad {
  Vec<Dim, double> force;
  Turn<Dim> moment;
};

template <class P>
struct SumPortion {
  static constexpr int dim = P::dim;
  Columns<P, Fields<Position, WallForce, Group>> particles;
  Column<P, RigidCentre> centres;
  Span<int const> bounds;  // of the portions
  Span<RigidLoad<dim>> loads;
  SCREE_FN void operator()(int portion) const {
    RigidLoad<dim> sum{zero<Vec<dim, double>>(), zero<Turn<dim>>()};
    for (int k = bounds(portion); k < bounds(portion + 1); ++k) {
      Vec<dim, double> const F = particles.load(wall_force, k).template cast<double>(),
                             x = particles.load(position, k).template cast<double>();
      sum.force += F;
      sum.moment += moment_of(Vec<dim, double>(x - value_of(centres(particles.load(group, k)))), F);
    }
    loads(portion) = sum;
  }
};
template <class P>
struct SumOfBody {
  static constexpr int dim = P::dim;
  Span<int const> portions;  // the first of each body
  Span<RigidLoad<dim> const> loads;
  Columns<P, Fields<RigidForce, RigidMoment>> states;
  SCREE_FN void operator()(int body) const {
    RigidLoad<dim> sum{zero<Vec<dim, double>>(), zero<Turn<dim>>()};
    for (int k = portions(body); k < portions(body + 1); ++k)
      sum.force += loads(k).force, sum.moment += loads(k).moment;
    states[rigid_force](body) = sum.force;
    states[rigid_moment](body) = sum.moment;
  }
};

/// The portions of particles that are summed, of bodies whose particles are next to each other.
template <class P>
class RigidSums {
 public:
  RigidSums() = default;
  RigidSums(typename P::space const& space, std::vector<int> const& groups, int bodies) {
    std::vector<int> bounds, portions;
    std::size_t k = 0;
    for (int body = 0; body < bodies; ++body) {
      portions.push_back(int(bounds.size()));
      std::size_t last = k;
      while (last < groups.size() && groups[last] == body) ++last;
      auto const length = std::size_t(std::ceil(std::sqrt(double(last - k))));
      for (; k < last; k = std::min(k + length, last)) bounds.push_back(int(k));
    }
    portions.push_back(int(bounds.size()));
    bounds.push_back(int(k));
    bounds_ = scree::array_of<P>(space, bounds), portions_ = scree::array_of<P>(space, portions);
    loads_ = Array<P, RigidLoad<P::dim>>(space, "scree::rigid_loads", bounds.size());
  }
  template <class Body, class States>
  void run(Body const& body, States const& states) const {
    auto const& space = body.space();
    for_each_index(
        space, "scree::rigid_portions", 0, bounds_.size() - 1,
        SumPortion<P>{body.select(Fields<Position, WallForce, Group>{}), states.column(rigid_centre), bounds_, loads_});
    for_each_index(space, "scree::rigid_forces", 0, states.size(),
                   SumOfBody<P>{portions_, loads_, states.select(Fields<RigidForce, RigidMoment>{})});
  }

 private:
  Array<P, int> bounds_, portions_;
  Array<P, RigidLoad<P::dim>> loads_;
};

}  // namespace scree::detail
