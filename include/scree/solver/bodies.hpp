// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

// The bodies of a simulation. A body is a class with a name that says what moves its particles:
//   struct Blade : WallBody { static constexpr std::string_view name = "blade"; };
namespace scree {

/// Base of a body whose fields the physics model advances.
struct MaterialBody {};
/// Base of a body that the prescribed motion moves.
struct WallBody {};

/// The bodies of a formulation that names no others. In passes they are roles: Material stands for the body that
/// evolves, and Wall for each body that follows a motion.
struct Material : MaterialBody {
  static constexpr std::string_view name = "material";
};
struct Wall : WallBody {
  static constexpr std::string_view name = "wall";
};

template <class B>
concept EvolvingBody = std::derived_from<B, MaterialBody>;
template <class B>
concept FollowingBody = std::derived_from<B, WallBody>;
template <class B>
concept BodyTag = (EvolvingBody<B> != FollowingBody<B>)&&requires {
  { B::name } -> std::convertible_to<std::string_view>;
};

/// A list of bodies.
template <BodyTag... Bs>
struct Bodies {
  static constexpr std::size_t count = sizeof...(Bs);
};

namespace detail {

/// Whether particles of a body are among those that a pass names: it names the body or its role.
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

template <class Body, class... Bs>
constexpr std::size_t index_among(Bodies<Bs...>) {
  std::size_t k = 0;
  (void)((covers<Body, Bs> || (++k, false)) || ...);
  return k;
}

}  // namespace detail

/// The bodies of a list that a pass names, by themselves or by their role.
template <class Named, class List>
using bodies_named = typename detail::find_bodies<Named, List>::type;

/// The place of a body in a list. Material and Wall also stand for the only body with their role.
template <BodyTag Body, class List>
constexpr std::size_t body_index() {
  constexpr std::size_t found = bodies_named<Body, List>::count;
  static_assert(found != 0, "this body is not among the `bodies` of the formulation");
  static_assert(found < 2, "several bodies follow a motion: name the one that is meant");
  return detail::index_among<Body>(List{});
}

/// One object of the same type for each body of a list.
template <class T, class List>
struct PerBody {
  std::array<T, List::count> all;
  template <BodyTag Body>
  T& of() {
    return all[body_index<Body, List>()];
  }
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
