// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../formulation/formulation.hpp"
#include "../pairs/for_each_particle.hpp"
#include "../passes/limit.hpp"
#include "../passes/pass.hpp"
#include "../rigid/contact_surface.hpp"
#include "../rigid/settings.hpp"
#include "../terms/gravity.hpp"
#include "settings.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// The contact of the rigid bodies of a solver.
namespace scree::detail {

/// Returns |g|, m/s^2; 0 if the physics has no gravity.
template <class Physics>
double strength_of_gravity(Physics const& physics) {
  if constexpr (requires { gravity_of(physics); })
    return std::abs(gravity_of(physics).magnitude);
  else
    return 0;
}
/// Returns the contact modulus of the physics, Pa; 0 if it has none.
template <class Physics>
double contact_modulus_of(Physics const& physics) {
  if constexpr (requires { physics.contact_modulus(); })
    return physics.contact_modulus();
  else if constexpr (requires { physics.mechanics; })
    return contact_modulus_of(physics.mechanics);
  else
    return 0;
}

/// The contact overlap of a particle, in spacings.
struct OverlapInSpacings {
  double spacing;
  using reads = Fields<ContactOverlap>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    return double(i[fields::contact_overlap]) / spacing;
  }
};

/// An update that adds the contact forces on wall particles to the forces of the material.
struct AddToWall {
  using reads = Fields<WallForce>;
  using writes = Fields<WallForce>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    out[wall_force] = i[wall_force] + total[contact_force];
  }
};

template <class P>
class BodyContact {
 public:
  static constexpr int dim = P::dim;
  using Basis = basis_of<P>;
  using real = typename P::real;
  using X = Vec<dim, real>;
  using Body = rigid_body_of<typename P::bodies>;
  using Walls = not_rigid_among<following_bodies<P>>;

  /// Finds the surfaces of all bodies and sets the parameters of the contact law.
  template <class Sys>
  void prepare(Sys& system, SolverSettings<P> const& settings) {
    using namespace fields;
    auto const& rigid = settings.rigid;
    settings_ = rigid.contact;
    spacing_ = settings.spacing;
    for_each_body(Walls{}, [&]<class Wall>() {
      auto& wall = system.template body<Wall>();
      find(system, wall, std::vector<int>(std::size_t(wall.size()), ContactLaw::of_wall));
    });
    auto& body = system.template body<Body>();
    auto const groups = body.to_host(group);
    auto const outermost = find(system, body, groups);
    double const modulus = settings_.modulus > 0 ? settings_.modulus : contact_modulus_of(settings.physics);
    acts_ = settings_.acts && modulus > 0;
    law_.spacing = spacing_;
    law_.stiffness = acts_ ? modulus * std::pow(spacing_, dim - 2) : 0;
    double const e = settings_.restitution;
    law_.mean = (1 + e * e) / 2, law_.swing = (1 - e * e) / 2;
    double const omega = set_frequencies(system.space(), rigid.bodies, body.to_host(rest_position), groups, outermost);
    longest_ = acts_ ? of_vibration / omega : TimeStepLimit::never;
    if (!acts_) return;
    double const g = strength_of_gravity(settings.physics);
    law_.damped_below = settings_.damped_below > 0 ? settings_.damped_below : 2 * g / omega + 1e-4 * omega * spacing_;
  }
  /// Rotates the surface normals of walls with the motion of the walls.
  template <class Sys>
  void turn_walls(Sys& system, typename P::motion const& motion, double time) const {
    for_each_body(Walls{}, [&]<class Wall>() {
      using Motion = body_motion<P, Wall>;
      if constexpr (!std::is_same_v<Motion, AtRest>)
        for_each_particle<Basis>("scree::turn_wall", system.template body<Wall>(),
                                 TurnFacing<Motion>{motion_of_body<Wall>(motion), time, spacing_});
    });
  }
  /// Returns a function of one particle that rotates the surface normals of rigid bodies with their motions.
  template <class Motions>
  TurnFacing<Motions> turning_with(Motions const& motions) const {
    return {motions, 0, spacing_};
  }
  /// Updates the overlaps and the contact forces.
  template <class Sys>
  void update(Sys& system) const {
    pair_pass_where<Body>("scree::rigid_touch", OnSurface{},
                          StickOrSlip{settings_.friction, law_.stiffness / 2, dashpots_}, over<Wall>(ContactSums{law_}))
        .run(system);
    if (acts_)
      pair_pass_where<Body>("scree::rigid_contact", InContact{}, StoreSums{}, over<Wall>(ContactForces{law_}))
          .run(system);
  }
  /// Adds the contact forces of the present state to the forces on walls that the diagnostics compute.
  template <class Sys>
  void add_to_walls(Sys& system) const {
    if (!acts_) return;
    for_each_body(Walls{}, [&]<class Each>() {
      if constexpr (OneOf<WallForce, fields_written_by<Each, diagnostic_passes_of<P>>>) {
        update(system);
        pair_pass_then<Each>("scree::contact_on_wall", AddToWall{}, over<Body>(ContactForces{law_})).run(system);
      }
    });
  }
  /// Updates the tangential displacement of friction with the function of an integrator for StretchEvolves; does
  /// nothing if this function does not write the displacement.
  template <class Sys, class Function>
  void advance(Sys& system, Function const& function) const {
    if constexpr (OneOf<ContactStretch, writes_of<Function>>)
      if (acts_)
        for_each_particle<Basis>("scree::contact_stretch", system.template body<Body>(),
                                 UpdateStretch<Function>{function});
  }
  /// Throws OutsideValidity if bodies overlap more than the settings allow.
  template <class Sys>
  void check(Sys const& system, long steps) const {
    auto const overlap = bound(
        "overlap of rigid bodies with each other or with walls over the spacing", OverlapInSpacings{spacing_},
        settings_.largest_overlap,
        acts_ ? "`modulus` of `rigid.contact` makes contact stiffer, and `largest_overlap` allows more; bodies that "
                "are made in contact must not overlap"
              : "contact does not act: set `modulus` of `rigid.contact`; `largest_overlap` allows more");
    limits_of(system.template whole<Body>(), Fields<>{}, Tuple<>(), steps, Tuple(overlap));
  }
  /// Returns the time step limit that resolves contact; there is no limit unless another surface is near. `change` is
  /// the time (s) in which this can change.
  template <class Sys>
  TimeStepLimit limit(Sys const& system, double change) const {
    bool near = false;
    if (acts_) {
      auto const body = system.template whole<Body>();
      near = body.joined(survey(body.here(), Fields<>{}, Magnitude<ContactNearness>{}).largest).first[0].value > 0;
    }
    return {"rigid contact", near ? longest_ : TimeStepLimit::never, near ? change : TimeStepLimit::never};
  }
  /// Whether contact forces act.
  bool acts() const { return acts_; }

 private:
  /// The longest time step times the largest angular frequency of a body on its contacts: 42 steps per oscillation.
  static constexpr double of_vibration = 0.15;
  /// Finds the surface of a body and stores its normals and owners. Returns which particles are the outermost.
  template <class Sys, class Any>
  static std::vector<bool> find(Sys const& system, Any& body, std::vector<int> const& owners) {
    using namespace fields;
    if (body.size() == 0) return {};
    auto const surface =
        surface_at_rest<Basis>(system.space(), system.ghosts(), std::pow(double(body.to_host(volume)[0]), 1.0 / dim),
                               body.to_host(rest_position), owners);
    body.from_host(rest_facing, surface.facing);
    body.from_host(facing, surface.facing);
    body.from_host(contact_owner, surface.owner);
    return surface.outermost;
  }
  /// Sets the friction dashpot of each body from the angular frequency of the body on its contacts. Returns the largest
  /// such frequency (rad/s), if half of the outermost particles of a body touch other bodies, which may move just as
  /// fast in the opposite direction.
  double set_frequencies(typename P::space const& space, std::vector<Rigid<dim>> const& bodies,
                         std::vector<X> const& at_rest, std::vector<int> const& groups,
                         std::vector<bool> const& outermost) {
    std::vector<double> squares(bodies.size(), 0), dashpots;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (!outermost[k]) continue;
      auto const number = std::size_t(groups[k]);
      auto const& properties = bodies[number].properties;
      double least = properties.inertia(0, 0);
      if constexpr (dim == 3) least = principal(properties.inertia).values.minCoeff();
      Vec<dim, double> const arm = at_rest[k].template cast<double>() - properties.centre;
      squares[number] += 1.5 * law_.stiffness / 2 * (1 / properties.mass + squared_norm(arm) / least);
    }
    for (double const square : squares) dashpots.push_back(square > 0 ? law_.stiffness / 2 / std::sqrt(square) : 0);
    dashpots_ = array_of<Basis>(space, dashpots);
    double const most = bodies.empty() ? 0 : *std::max_element(squares.begin(), squares.end());
    return std::sqrt(most * (bodies.size() > 1 ? 2 : 1));
  }

  RigidContact settings_;
  ContactLaw law_;
  bool acts_ = false;
  double spacing_ = 0, longest_ = TimeStepLimit::never;  // m, s
  Array<Basis, double> dashpots_;
};

}  // namespace scree::detail
