// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/loop.hpp"
#include "../fields/whole_body.hpp"
#include "../terms/wall_force.hpp"
#include "state.hpp"

#include <vector>

// Force and moment on rigid bodies: sums over their particles in a fixed order, so that runs are reproducible bit for
// bit on every backend.
namespace scree::detail {

using SummedOfParticle = Fields<Position, WallForce, Group, ContactForce, ContactMoment>;
using SummedOfBody = Fields<RigidForce, RigidMoment, RigidContactForce, RigidContactMoment>;

template <int Dim>
struct RigidLoad {
  Vec<Dim, double> force = zero<Vec<Dim, double>>(), contact_force = zero<Vec<Dim, double>>();
  Turn<Dim> moment = zero<Turn<Dim>>(), contact_moment = zero<Turn<Dim>>();

  SCREE_FN RigidLoad& operator+=(RigidLoad const& other) {
    force += other.force, contact_force += other.contact_force;
    moment += other.moment, contact_moment += other.contact_moment;
    return *this;
  }
  static constexpr int count = 2 * (Dim + turns_in<Dim>);  ///< number of components
  SCREE_FN void write(double* to) const {
    for (int a = 0; a < Dim; ++a) *to++ = force[a], *to++ = contact_force[a];
    for (int a = 0; a < turns_in<Dim>; ++a) *to++ = moment[a], *to++ = contact_moment[a];
  }
  static RigidLoad of(double const* from) {
    RigidLoad load;
    for (int a = 0; a < Dim; ++a) load.force[a] = *from++, load.contact_force[a] = *from++;
    for (int a = 0; a < turns_in<Dim>; ++a) load.moment[a] = *from++, load.contact_moment[a] = *from++;
    return load;
  }
};

/// Computes the force and moment that a particle exerts on its body.
template <class P>
struct LoadOfParticle {
  static constexpr int dim = P::dim;
  Columns<P, SummedOfParticle> particles;
  Column<P, RigidCentre> centres;
  SCREE_FN RigidLoad<dim> operator()(int k) const {
    using namespace fields;
    Vec<dim, double> const F = particles.load(wall_force, k).template cast<double>(),
                           C = particles.load(contact_force, k).template cast<double>(),
                           x = particles.load(position, k).template cast<double>(),
                           arm = x - value_of(centres(particles.load(group, k)));
    Turn<dim> const M = particles.load(contact_moment, k).template cast<double>();
    return {F, C, moment_of(arm, F), Turn<dim>(moment_of(arm, C) + M)};
  }
};
/// Stores the load of each body in its state.
template <class P>
struct StoreLoad {
  Columns<P, SummedOfBody> states;
  SCREE_FN void operator()(int body, RigidLoad<P::dim> const& load) const {
    using namespace fields;
    states[rigid_force](body) = load.force;
    states[rigid_moment](body) = load.moment;
    states[rigid_contact_force](body) = load.contact_force;
    states[rigid_contact_moment](body) = load.contact_moment;
  }
};
template <class P>
struct LoadOfBody {
  using value_type = RigidLoad<P::dim>;
  LoadOfParticle<P> of_particle;
  StoreLoad<P> store;
  SCREE_FN value_type operator()(int particle) const { return of_particle(particle); }
};

/// Sums the loads of rigid bodies; the particles of each body must be contiguous.
template <class P>
class RigidSums {
 public:
  RigidSums() = default;
  RigidSums(typename P::space const& space, std::vector<int> const& groups, int bodies) {
    std::vector<int> bounds(1, 0);
    for (int body = 0; body < bodies; ++body) {
      std::size_t last = std::size_t(bounds.back());
      while (last < groups.size() && groups[last] == body) ++last;
      bounds.push_back(int(last));
    }
    bounds_ = array_of<P>(space, bounds);
  }
  template <class... Of, class States>
  void run(WholeBody<Of...> const& whole, States const& states) const {
    auto const& body = whole.here();
    sum_ranges(body.space(), "scree::rigid_forces", Span<int const>(bounds_),
               LoadOfBody<P>{{body.select(SummedOfParticle{}), states.column(fields::rigid_centre)},
                             {states.select(SummedOfBody{})}});
  }

 private:
  Array<P, int> bounds_;  // particle ranges of the bodies
};

}  // namespace scree::detail

namespace Kokkos {
template <int Dim>
struct reduction_identity<scree::detail::RigidLoad<Dim>> {
  KOKKOS_FUNCTION static scree::detail::RigidLoad<Dim> sum() { return {}; }
};
}  // namespace Kokkos
