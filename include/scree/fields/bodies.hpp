// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

// The bodies of a simulation. A body is a class with a name and a base class that determines how its particles move:
//   struct Blade : WallBody { static constexpr std::string_view name = "blade"; };
namespace scree {

/// The base class of a body whose fields the physics model advances.
struct MaterialBody {};
/// The base class of a body that moves with the prescribed motion.
struct WallBody {};
/// The base class of a body whose groups are rigid bodies, which move under the forces that act on them. Passes treat
/// its particles as wall particles.
struct RigidBody : WallBody {};

/// The evolving body of a formulation that names no bodies of its own. In passes, Material is a role that stands for
/// the body that evolves; if several bodies evolve, it stands for the body whose physics model runs.
struct Material : MaterialBody {
  static constexpr std::string_view name = "material";
};
/// The wall particles of a formulation that names no bodies of its own; they move with the prescribed motion. In
/// passes, Wall is a role that stands for each body that follows a motion.
struct Wall : WallBody {
  static constexpr std::string_view name = "wall";
};

/// The states of the rigid bodies of a formulation, with one particle per rigid body at its centre of mass. No role in
/// a pass includes RigidStates.
struct RigidStates {
  static constexpr std::string_view name = "rigid bodies";
};

/// Whether the physics model advances the fields of a body.
template <class B>
concept EvolvingBody = std::derived_from<B, MaterialBody>;
/// Whether a body moves with a prescribed motion or as rigid bodies.
template <class B>
concept FollowingBody = std::derived_from<B, WallBody>;
/// Whether the groups of a body are rigid bodies.
template <class B>
concept RigidTag = std::derived_from<B, RigidBody>;
/// Whether a type is a body of particles or RigidStates.
template <class B>
concept BodyTag = (EvolvingBody<B> != FollowingBody<B> || std::same_as<B, RigidStates>)&&requires {
  { B::name } -> std::convertible_to<std::string_view>;
};

/// A list of bodies.
template <class... Bs>
struct Bodies {
  static constexpr std::size_t count = sizeof...(Bs);  ///< the number of bodies
};

namespace detail {

/// Whether a pass that names `Named` includes the particles of a body, because `Named` is the body or its role.
template <class Named, class Body>
inline constexpr bool covers = std::is_same_v<Named, Body> || (std::is_same_v<Named, Material> && EvolvingBody<Body>) ||
                               (std::is_same_v<Named, Wall> && FollowingBody<Body>);

template <class... Lists>
struct joined_bodies;
template <>
struct joined_bodies<> {
  using type = Bodies<>;
};
template <class... As>
struct joined_bodies<Bodies<As...>> {
  using type = Bodies<As...>;
};
template <class... As, class... Bs, class... Lists>
struct joined_bodies<Bodies<As...>, Bodies<Bs...>, Lists...> {
  using type = typename joined_bodies<Bodies<As..., Bs...>, Lists...>::type;
};

template <class Named, class List>
struct find_bodies;
template <class Named, class... Bs>
struct find_bodies<Named, Bodies<Bs...>> {
  using type = typename joined_bodies<std::conditional_t<covers<Named, Bs>, Bodies<Bs>, Bodies<>>...>::type;
};

template <class T>
inline constexpr bool is_list_of_bodies = false;
template <class... Bs>
inline constexpr bool is_list_of_bodies<Bodies<Bs...>> = true;

/// Whether a list contains a body itself, not only a body with the same role.
template <class Body, class List>
inline constexpr bool is_listed = false;
template <class Body, class... Bs>
inline constexpr bool is_listed<Body, Bodies<Bs...>> = (std::is_same_v<Body, Bs> || ...);

template <class Body, class... Bs>
constexpr std::size_t index_among(Bodies<Bs...>) {
  constexpr bool exact = is_listed<Body, Bodies<Bs...>>;
  std::size_t k = 0;
  (void)(((exact ? std::is_same_v<Body, Bs> : covers<Body, Bs>) || (++k, false)) || ...);
  return k;
}

template <bool Rigid, class... Bs>
auto with_rigid(Bodies<Bs...>) ->
    typename joined_bodies<std::conditional_t<RigidTag<Bs> == Rigid, Bodies<Bs>, Bodies<>>...>::type;
/// The rigid bodies of a list.
template <class List>
using rigid_among = decltype(with_rigid<true>(List{}));
template <class List>
using not_rigid_among = decltype(with_rigid<false>(List{}));
template <class List>
inline constexpr bool has_rigid_bodies = rigid_among<List>::count > 0;

template <class List>
struct first_body;
template <class First, class... Others>
struct first_body<Bodies<First, Others...>> {
  using type = First;
};
template <class List>
using rigid_body_of = typename first_body<rigid_among<List>>::type;

}  // namespace detail

/// The bodies of a list that a pass names, either directly or by their role.
template <class Named, class List>
using bodies_named = typename detail::find_bodies<Named, List>::type;

/// Returns the index of a body in a list. Material and Wall also refer to a body with the respective role if it is the
/// only one.
template <BodyTag Body, class List>
constexpr std::size_t body_index() {
  constexpr std::size_t found = detail::is_listed<Body, List> ? 1 : bodies_named<Body, List>::count;
  static_assert(found != 0, "this body is not among the `bodies` of the formulation");
  static_assert(found < 2, "several bodies have this role: name the one that is meant");
  if constexpr (found == 0)
    return 0;
  else
    return detail::index_among<Body>(List{});
}

/// One object of the same type for each body of a list.
template <class T, class List>
struct PerBody {
  std::array<T, List::count> all;
  /// Returns the object of a body.
  template <BodyTag Body>
  T& of() {
    return all[body_index<Body, List>()];
  }
  /// Returns the object of a body.
  template <BodyTag Body>
  T const& of() const {
    return all[body_index<Body, List>()];
  }
};

namespace detail {
/// Calls visit.template operator()<Body>() for each body of a list, in order.
template <class... Bs, class Visit>
void for_each_body(Bodies<Bs...>, Visit const& visit) {
  (visit.template operator()<Bs>(), ...);
}
}  // namespace detail

}  // namespace scree
