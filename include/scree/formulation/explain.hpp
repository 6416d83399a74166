// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/limit.hpp"
#include "../system/searches.hpp"
#include "formulation.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

// Compile-time messages for mistakes in a formulation. Each check runs only if the earlier ones have passed, so that
// each mistake gives one message.
namespace scree::detail {

/// Whether a class has the choices of a formulation that are values or types; HasTemplates checks the templates.
template <class P>
concept HasChoices = requires {
  P::dim;
  typename P::real;
  typename P::space;
  typename P::kernel;
  typename P::integrator;
  typename P::bodies;
  typename P::motion;
  typename P::diagnostics;
  typename P::carries;
};
template <class P>
concept HasTemplates = requires {
  typename P::template search<basis_of<P>>;
  typename P::template ghosts<basis_of<P>>;
};
template <class List>
inline constexpr bool has_tags = false;
template <class... Bs>
inline constexpr bool has_tags<Bodies<Bs...>> = (BodyTag<Bs> && ...);
template <class P>
constexpr bool explain_choices() {
  constexpr bool has_choices = HasChoices<P>;  // a list of missing members would not help
  static_assert(has_choices,
                "a solver is made from a formulation, a class that derives from scree::Formulation<dim> and names its "
                "`physics`: this class is none");
  if constexpr (has_choices) {
    static_assert(HasTemplates<P>,
                  "`search` and `ghosts` of a formulation are templates: template <class P> using "
                  "search = CellList<P>");
    static_assert(is_list_of_bodies<typename P::bodies>,
                  "`bodies` of a formulation is a list: using bodies = Bodies<Material, Wall>");
    constexpr bool has_bodies = !is_list_of_bodies<typename P::bodies> || has_tags<typename P::bodies>;
    static_assert(
        has_bodies,
        "a body derives from MaterialBody, WallBody or RigidBody and has a `static constexpr std::string_view "
        "name`");
    static_assert(is_list_of_fields<typename P::carries>,
                  "`carries` of a formulation is a list: using carries = Fields<Held>");
    return (P::dim == 2 || P::dim == 3) && std::is_floating_point_v<typename P::real> && HasTemplates<P> &&
           has_tags<typename P::bodies> && is_list_of_fields<typename P::carries>;
  }
  return false;
}

/// Whether a type given as physics by mistake looks like a law; the two concepts below detect models and integrators.
template <class T>
concept LooksLikeLaw = requires {
  typename T::reads;
  typename T::history;
};
template <class T>
concept LooksLikeModels = requires {
  typename T::law;
  typename T::volume_control;
};
template <class T>
concept LooksLikeIntegrator = requires {
  typename T::template fields<Fields<>>;
};
template <class Physics>
inline constexpr bool are_of_bodies = false;
template <class... Parts>
inline constexpr bool are_of_bodies<PhysicsOfBodies<Parts...>> = true;
template <class Physics>
constexpr bool explain_physics() {
  if constexpr (IsRefused<Physics>) {
    return false;
  } else if constexpr (GivesPasses<Physics> || HasStages<Physics>) {
    static_assert(is_list_of_fields<typename Physics::evolves>,
                  "`evolves` of `physics` is a list: using evolves = Fields<Velocity>");
    return is_list_of_fields<typename Physics::evolves>;
  } else {
    constexpr bool is_law = LooksLikeLaw<Physics>, is_models = LooksLikeModels<Physics>,
                   is_integrator = LooksLikeIntegrator<Physics>;
    static_assert(!is_law,
                  "a law is no `physics`: name it as `law` in a class of models, struct Models : scree::GranularModels "
                  "{ using law = ...; }, and write using physics = scree::Granular<Models>");
    static_assert(!is_models, "a class of models is no `physics`: write using physics = scree::Granular<Models>");
    static_assert(!is_integrator, "an integrator is no `physics`: write using integrator = ...");
    if constexpr (!is_law && !is_models && !is_integrator)
      static_assert(HasPasses<Physics>,
                    "`physics` needs a list `evolves` and a function `passes(resolution)` or `stages(resolution)`");
    return false;
  }
}
/// Reports optional functions of a physics model that cannot be called as intended; they would otherwise be ignored.
template <class Physics>
constexpr bool explain_options() {
  static_assert(GivesFilters<Physics> || !(HasMemberFilters<Physics> || HasMemberFilterPeriod<Physics>),
                "filters of `physics` are two functions: filters(resolution) const, which returns a tuple of passes, "
                "and filter_period() const");
  static_assert(GivesValidity<Physics> || !HasMemberValidity<Physics>,
                "`validity` of `physics` must be a function validity(resolution) const, which returns a tuple of "
                "bounds");
  static_assert(GivesProjections<Physics> || !HasMemberProjections<Physics>,
                "`projections` of `physics` must be a function projections(resolution) const, which returns a tuple of "
                "passes");
  return true;
}
/// A check with one message for each mistake in the models of PhysicsOfBodies, defined in physics_of_bodies.hpp.
template <class Physics>
struct ExplainModels;
template <class Physics>
constexpr bool explain_models() {
  if constexpr (are_of_bodies<Physics>)
    return ExplainModels<Physics>::explain();
  else
    return explain_physics<Physics>();
}
template <class P>
constexpr bool explain_stages() {
  if constexpr (Staggered<typename P::integrator>) {
    static_assert(HasStages<typename P::physics>,
                  "this integrator is staggered: it needs a function `stages(resolution)` of the physics, which says "
                  "which passes give the rates of which fields");
    if constexpr (HasStages<typename P::physics>) {
      constexpr bool are_complete = stages_are_complete<typename P::physics>();
      static_assert(are_complete, "`stages` must evolve what the list `evolves` names");
      return are_complete;
    }
    return false;
  }
  return true;
}
template <class P>
constexpr bool explain_parts() {
  static_assert(TimeIntegrator<typename P::integrator, typename P::physics::evolves>,
                "`integrator` is not a TimeIntegrator: it needs fields<Evolved>, a list with the evolved fields, and "
                "static double advance(solver, longest)");
  static_assert(DiagnosticPasses<typename P::diagnostics, typename P::physics>,
                "`diagnostics` needs a function passes(resolution) const or passes(resolution, physics) const, which "
                "returns a tuple of passes");
  constexpr bool has_kernel = SmoothingKernel<typename P::kernel>;
  static_assert(has_kernel, "`kernel` is not a SmoothingKernel: it needs support, w(q), dw_over_q(q) and sigma<Dim>()");
  return TimeIntegrator<typename P::integrator, typename P::physics::evolves> &&
         DiagnosticPasses<typename P::diagnostics, typename P::physics> && has_kernel;
}

template <class List>
inline constexpr bool names_differ = false;
template <class... Bs>
inline constexpr bool names_differ<Bodies<Bs...>> = [] {
  std::array<std::string_view, sizeof...(Bs)> const names{Bs::name...};
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (names[a] == names[b]) return false;
  return true;
}();
template <class List, class Motion>
inline constexpr bool has_bodies_of = true;
template <class List, class... Parts>
inline constexpr bool has_bodies_of<List, MotionOfBodies<Parts...>> = (is_listed<typename Parts::body, List> && ...);
template <class List, class Motion>
inline constexpr bool moves_rigid = false;
template <class List, class... Parts>
inline constexpr bool moves_rigid<List, MotionOfBodies<Parts...>> = (RigidTag<typename Parts::body> || ...);
/// Whether a physics model advances each body of a list: a single body, or the bodies of PhysicsOfBodies.
template <class Physics, class Evolving>
inline constexpr bool has_model_of_each = Evolving::count < 2;
template <class... Parts, class... Bs>
inline constexpr bool has_model_of_each<PhysicsOfBodies<Parts...>, Bodies<Bs...>> =
    sizeof...(Parts) == sizeof...(Bs) && (is_listed<Bs, Bodies<typename Parts::body...>> && ...);
/// Reports each choice that requires a single evolving body.
template <class P>
constexpr bool explain_several() {
  constexpr bool rigid = several_evolve<P> && has_rigid_bodies<typename P::bodies>,
                 divides = several_evolve<P> && DividesCase<typename P::template ghosts<basis_of<P>>>;
  static_assert(!rigid, "a formulation with a body that derives from RigidBody has one body that evolves");
  static_assert(!divides, "a formulation whose case may have several ranks has one body that evolves");
  return !rigid && !divides;
}
template <class P>
constexpr bool explain_bodies() {
  using List = typename P::bodies;
  using Motion = typename P::motion;
  constexpr bool evolves = evolving_bodies<P>::count > 0, differ = names_differ<List>,
                 has_models = has_model_of_each<typename P::physics, evolving_bodies<P>>,
                 one_may = explain_several<P>(), has_moved = has_bodies_of<List, Motion>,
                 one_is_rigid = rigid_among<List>::count < 2;
  static_assert(evolves, "`bodies` of this formulation needs a body that derives from MaterialBody");
  static_assert(
      has_models,
      "where several bodies evolve, `physics` has a model for each of them, and for no other: using physics = "
      "PhysicsOfBodies<EvolvedBy<Body, Model>, ...> (formulation/physics_of_bodies.hpp)");
  static_assert(differ, "two bodies of this formulation have the same name");
  static_assert(has_moved, "MotionOfBodies lists a body that is not among the `bodies` of the formulation");
  static_assert(!moves_rigid<List, Motion>,
                "MotionOfBodies lists a rigid body, which moves by the forces on it: give components of its motion in "
                "`rigid` of the settings");
  static_assert(one_is_rigid,
                "name one body that derives from RigidBody: each group of its particles is a rigid body of its own");
  return evolves && has_models && one_may && differ && has_moved && !moves_rigid<List, Motion> && one_is_rigid;
}

/// Whether a motion has another dimension than the formulation, so that its functions would not compile.
template <class M, int Dim>
inline constexpr bool has_another_dimension = false;
template <class M, int Dim>
requires requires { M::dim; }
inline constexpr bool has_another_dimension<M, Dim> = M::dim != Dim;
template <class P>
constexpr bool explain_motion() {
  constexpr bool in_another = has_another_dimension<typename P::motion, P::dim>;
  static_assert(!in_another, "`motion` has another dimension than the formulation");
  if constexpr (!in_another) {
    constexpr bool moves = all_move<P, typename P::bodies>;
    static_assert(moves,
                  "`motion` is not a PrescribedMotion: it needs displaced(x, from, to), velocity(x, time), "
                  "acceleration(x, time) and "
                  "time_step(), or, by group, of(group), groups() and time_step()");
    return moves;
  }
  return false;
}

template <class Written, class... Entries>
constexpr bool all_may_change(Fields<Entries...>) {
  return ((HasRate<Entries> || OneOf<Entries, Written>)&&...);
}
template <class P>
constexpr bool explain_evolves() {
  constexpr bool may_change = []<class... Bs>(Bodies<Bs...>) {
    return (all_may_change<written_fields<P, Bs>>(evolves_of<P, Bs>{}) && ...);
  }(evolving_bodies<P>{});
  static_assert(may_change, "`evolves` names a field without a rate that no pass writes: it would never change");
  return may_change;
}

template <class P>
constexpr bool explain_measures() {
  constexpr bool are_numbers = []<class... Bs>(Bodies<Bs...>) {
    return (limits_measure_numbers<basis_of<P>, physics_of<P, Bs>> && ...);
  }(evolving_bodies<P>{});
  static_assert(are_numbers, "the function of a limit of `physics` needs operator()(i) const, which returns a number");
  return are_numbers;
}

/// Checks a formulation at compile time, with one message for each missing part.
template <class P>
constexpr bool explain_formulation() {
  if constexpr (!explain_choices<P>()) {
    return false;
  } else if constexpr (!NamesPhysics<P>) {
    static_assert(NamesPhysics<P>, "this formulation names no `physics`: what should evolve?");
    return false;
  } else if constexpr (!explain_search<typename P::template search<basis_of<P>>, basis_of<P>>()) {
    return false;
  } else if constexpr (!explain_models<typename P::physics>()) {
    return false;
  } else if constexpr (!explain_stages<P>() || !explain_options<typename P::physics>() || !explain_parts<P>()) {
    return false;
  } else if constexpr (!explain_bodies<P>()) {
    return false;
  } else if constexpr (!explain_motion<P>()) {
    return false;
  } else {
    return ValidFormulation<P> && explain_evolves<P>() && explain_measures<P>();
  }
}

}  // namespace scree::detail
