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

using SummedOfParticle = Fields<Position, WallForce, Group, ContactForce, ContactMoment>;
using SummedOfBody = Fields<RigidForce, RigidMoment, RigidContactForce, RigidContactMoment>;

template <int Dim>
struct RigidLoad {
  Vec<Dim, double> force, contact_force;
  Turn<Dim> moment, contact_moment;

  SCREE_FN RigidLoad& operator+=(RigidLoad const& other) {
    force += other.force, contact_force += other.contact_force;
    moment += other.moment, contact_moment += other.contact_moment;
    return *this;
  }
  SCREE_FN static RigidLoad none() {
    using X = Vec<Dim, double>;
    return {zero<X>(), zero<X>(), zero<Turn<Dim>>(), zero<Turn<Dim>>()};
  }
  static constexpr int count = 2 * (Dim + turns_in<Dim>);  // of numbers
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

/// The load of a particle on its body.
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
template <class P>
struct SumPortion {
  LoadOfParticle<P> of_particle;
  Span<int const> bounds;  // of the portions
  Span<RigidLoad<P::dim>> loads;
  SCREE_FN void operator()(int portion) const {
    auto sum = RigidLoad<P::dim>::none();
    for (int k = bounds(portion); k < bounds(portion + 1); ++k) sum += of_particle(k);
    loads(portion) = sum;
  }
};
template <class P>
struct SumOfBody {
  static constexpr int dim = P::dim;
  Span<int const> portions;  // the first of each body
  Span<RigidLoad<dim> const> loads;
  Columns<P, SummedOfBody> states;
  SCREE_FN void operator()(int body) const {
    using namespace fields;
    auto sum = RigidLoad<dim>::none();
    for (int k = portions(body); k < portions(body + 1); ++k) sum += loads(k);
    states[rigid_force](body) = sum.force;
    states[rigid_moment](body) = sum.moment;
    states[rigid_contact_force](body) = sum.contact_force;
    states[rigid_contact_moment](body) = sum.contact_moment;
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
  template <class Body, class States, class Parts>
  void run(Body const& body, States const& states, Parts const&) const {
    auto const& space = body.space();
    for_each_index(
        space, "scree::rigid_portions", 0, bounds_.size() - 1,
        SumPortion<P>{{body.select(SummedOfParticle{}), states.column(fields::rigid_centre)}, bounds_, loads_});
    for_each_index(space, "scree::rigid_forces", 0, states.size(),
                   SumOfBody<P>{portions_, loads_, states.select(SummedOfBody{})});
  }

 private:
  Array<P, int> bounds_, portions_;
  Array<P, RigidLoad<P::dim>> loads_;
};

}  // namespace scree::detail
