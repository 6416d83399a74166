// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/member.hpp"
#include "../core/tuple.hpp"
#include "../passes/pass.hpp"
#include "../passes/resolution.hpp"
#include "../terms/artificial_stress.hpp"
#include "../terms/carried_momentum.hpp"
#include "../terms/gravity.hpp"

#include <cmath>
#include <tuple>
#include <type_traits>

// Forces on a material in addition to stress, viscosity and gravity, for the list `forces` of GranularModels.
namespace scree {

/// A force is a struct with one or more of these members:
///   passes(rho, resolution)        tuple of passes that run before the sums over neighbours
///   terms<Body>(rho, resolution)   tuple of pair terms over the particles of a body, each of which adds to
///                                  `acceleration`; walls are read through their lens
///   acceleration(i)                the acceleration, m/s^2, from the fields of the particle that are named in `reads`
/// and optionally
///   with_sound_speed(c)            the same force with a parameter set from the speed of sound c of the law, unless
///                                  the parameter was given; c is in m/s, and 0 for laws whose stiffness depends on the
///                                  state
/// Here rho is the density, see terms/density.hpp.
namespace granular {

/// Returns a force with its parameters set from the speed of sound c (m/s), if the force has such parameters.
template <class Force>
Force given_sound_speed(Force const& force, [[maybe_unused]] double c) {
  if constexpr (requires { force.with_sound_speed(c); })
    return force.with_sound_speed(c);
  else
    return force;
}
/// Returns the passes of a force that run before the sum of the accelerations; none if the force has no member
/// `passes`.
template <class Force, class Rho>
auto passes_of_force(Force const& force, Rho const& rho, Resolution const& resolution) {
  constexpr bool gives = requires { force.passes(rho, resolution); };
  static_assert(gives || !detail::HasMemberPasses<Force>,
                "`passes` of this force cannot be called: it must be a function passes(rho, resolution) const");
  if constexpr (gives)
    return force.passes(rho, resolution);
  else
    return detail::Tuple<>();
}
/// Fails a static assertion unless the terms of a force fit; the message is the same for all bodies.
template <class Force, bool Fit>
constexpr void explain_terms_of() {
  static_assert(Fit,
                "`terms` of this force cannot be called: it must be a function terms<Body>(rho, resolution) const for "
                "both bodies and any density, which returns a tuple of terms");
}
/// Returns the terms of a force in the sum over the particles of a body; none if the force has no member `terms`.
template <BodyTag Body, class Force, class Rho>
auto terms_of_force(Force const& force, Rho const& rho, Resolution const& resolution) {
  constexpr bool gives = requires { force.template terms<Body>(rho, resolution); };
  explain_terms_of<Force, gives || !detail::HasMemberTerms<Force>>();
  if constexpr (gives)
    return force.template terms<Body>(rho, resolution);
  else
    return detail::Tuple<>();
}
/// Whether a type is a tuple, as `forces` of the models must be.
template <class Forces>
inline constexpr bool are_forces = false;
template <class... Forces>
inline constexpr bool are_forces<std::tuple<Forces...>> = true;

/// Whether a force adds terms to the sum over neighbours.
template <class Force>
concept HasTerms = requires(Force const& force, UniformDensity const& rho) {
  force.template terms<Material>(rho, Resolution{});
};

/// Selects the type of motion_forces.
template <class Forces, bool SpeciesHaveDensities>
struct MotionForces {
  using type = Forces;
};
template <class... Forces>
struct MotionForces<std::tuple<Forces...>, true> {
  using type = std::tuple<Forces..., AccelerationByCarriedMomentum>;
};
/// The forces of the models, and in addition the momentum carried by species if the species have different densities.
template <class Forces, bool SpeciesHaveDensities>
using motion_forces = typename MotionForces<Forces, SpeciesHaveDensities>::type;

/// Computes the acceleration of one particle.
template <class Forces>
struct Motion;
template <class... Forces>
struct Motion<std::tuple<Forces...>> : Forces... {
  Gravity gravity;
  using reads = Merge<reads_of<Forces>...>;
  using writes = Fields<Acceleration>;

  /// Takes gravity and the forces whose accelerations are added.
  Motion(Gravity const& g, std::tuple<Forces...> const& forces) : Forces(std::get<Forces>(forces))..., gravity(g) {}

  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(total[acceleration])>;
    vector a = total[acceleration] + gravity.vector<vector>();
    (add<Forces>(i, a), ...);
    out[acceleration] = a;
  }

 private:
  template <class Force, class I, class X>
  SCREE_FN void add(I const& i, X& a) const {
    constexpr bool pushes = requires(Force const& force) { a += force.acceleration(i); };
    static_assert(pushes || HasTerms<Force>,
                  "this force adds nothing: it needs acceleration(i), or terms<Body>(rho, resolution)");
    static_assert(pushes || !detail::HasMemberAcceleration<Force>,
                  "`acceleration` of this force cannot be called: it must be a function acceleration(i) const, which "
                  "returns a vector");
    if constexpr (pushes) a += static_cast<Force const&>(*this).acceleration(i);
  }
};

}  // namespace granular

/// Repulsion of close neighbours under tension, which prevents the tensile instability of cohesive materials, see
/// terms/artificial_stress.hpp.
struct TensileRepulsion {
  double epsilon = 0.3;

  static constexpr auto parameters() {
    return std::array{parameter("epsilon", &TensileRepulsion::epsilon, "1", "artificial stress over the tension",
                                allowed::at_least(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "TensileRepulsion"); }
  /// Returns the pass that computes the artificial stress of each particle.
  template <class Rho>
  auto passes(Rho const& rho, Resolution const&) const {
    return std::tuple(point_pass<Material>("scree::artificial_stress", ArtificialStressOf<Rho>{rho, epsilon}));
  }
  /// Returns the divergence of the artificial stress in sums over the material, and nothing in sums over walls.
  template <BodyTag Body, class Rho>
  auto terms(Rho const& rho, Resolution const& resolution) const {
    if constexpr (std::is_same_v<Body, Material>)
      return std::tuple(ArtificialStressDivergence<Rho>{rho, resolution.spacing});
    else
      return std::tuple<>();
  }
};

}  // namespace scree
