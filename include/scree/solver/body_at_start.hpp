// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/groups.hpp"
#include "../fields/standard.hpp"
#include "../formulation/formulation.hpp"
#include "../snapshots/snapshot_of.hpp"

#include <string_view>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// The particles that a solver is made from: points, or named groups of points.
namespace scree {
/// The particles of a body: points, a share of points (fields/shared_points.hpp) or named groups (fields/groups.hpp),
/// kept by reference.
template <BodyTag Body, class Points>
struct ParticlesOf {
  Points const& points;
};
/// Returns the given points as the particles of a body, for the constructor of a solver.
template <BodyTag Body, class Points>
ParticlesOf<Body, Points> particles_of(Points const& points) {
  return {points};
}
}  // namespace scree

namespace scree::detail {

/// The particles of a body before the first step.
template <class X>
struct BodyAtStart {
  std::vector<X> points;                // m
  std::vector<int> groups = {};         // group of each particle; empty for plain points
  std::vector<std::string> names = {};  // names of the groups
  bool is_share = false;                // whether other ranks have other particles
  std::vector<RangeHere> ranges = {};   // ranges of identities, in the order of the points; empty: from 0
};
/// Whether a body can be made from points of a type; X is the point type of the formulation.
template <class Points, class X>
inline constexpr bool fits = false;
template <class X>
inline constexpr bool fits<std::vector<X>, X> = true;
template <class X>
inline constexpr bool fits<Groups<X::RowsAtCompileTime>, X> = true;
template <class X>
inline constexpr bool fits<SharedPoints<X::RowsAtCompileTime>, X> = true;
template <class Points>
inline constexpr bool are_groups = false;
template <int Dim>
inline constexpr bool are_groups<Groups<Dim>> = true;
template <int Dim>
inline constexpr bool are_groups<SharedPoints<Dim>> = true;
template <class Points>
inline constexpr bool are_points = false;
template <int Dim, class Real>
inline constexpr bool are_points<std::vector<Vec<Dim, Real>>> = true;
/// Reports at compile time points that do not fit the formulation.
template <class Points, class X>
constexpr bool explain_points() {
  constexpr bool right = fits<Points, X> || std::is_convertible_v<Points const&, std::vector<X>>;
  static_assert(right || !are_points<Points>,
                "the points have another dimension or precision than the formulation: for Formulation<2, float> give "
                "cast<float>(points)");
  static_assert(right || !are_groups<Points>,
                "the groups have another dimension than the formulation: for Formulation<3> give Groups<3>");
  static_assert(right || are_points<Points> || are_groups<Points>,
                "particles are std::vector<Vec<dim, real>>, or Groups<dim>, or SharedPoints<dim> of the formulation");
  return right;
}
/// The last parameter of a function, which callers omit: at each call, the compiler reports what is wrong with the
/// points.
template <class X, class A, class B = std::vector<X>>
struct PointsFit : std::bool_constant<explain_points<A, X>() && explain_points<B, X>()> {};

template <class X>
std::vector<X> in_precision_of(std::vector<Vec<X::RowsAtCompileTime, double>> const& points) {
  std::vector<X> result;
  result.reserve(points.size());
  for (auto const& x : points) result.push_back(x.template cast<typename X::Scalar>());
  return result;
}
template <class X>
BodyAtStart<X> at_start(std::vector<X> const& points) {
  return {points};
}
template <class X>
BodyAtStart<X> at_start(Groups<X::RowsAtCompileTime> const& groups) {
  return {in_precision_of<X>(groups.points()), groups.numbers(), groups.names(), groups.are_shares(),
          groups.ranges_here()};
}

template <class X>
BodyAtStart<X> at_start(SharedPoints<X::RowsAtCompileTime> const& share) {
  share.check();
  check_number(double(share.all));
  int const first = static_cast<int>(share.first), count = static_cast<int>(share.points.size());
  return {in_precision_of<X>(share.points), {}, {}, true, {{{first, first + count}, {0, static_cast<int>(share.all)}}}};
}

/// Stores the given particles of a body in `all`. Throws std::invalid_argument if the particles of a body are given
/// twice, or if they are given for a role that no body or several bodies have.
template <class List, class X, class Tag, class Points>
[[gnu::cold]] void give(PerBody<BodyAtStart<X>, List>& all, ParticlesOf<Tag, Points> const& given) {
  if constexpr (explain_points<Points, X>()) {
    auto start = at_start<X>(given.points);
    if constexpr (is_listed<Tag, List> || bodies_named<Tag, List>::count == 1) {
      if (!all.template of<Tag>().points.empty())
        throw std::invalid_argument("scree: the particles of a body are given twice: " + std::string(Tag::name));
      all.template of<Tag>() = std::move(start);
    } else if (!start.points.empty()) {
      throw std::invalid_argument("scree: this formulation has " + std::to_string(bodies_named<Tag, List>::count) +
                                  " bodies that are a " + std::string(Tag::name) +
                                  ": name each with particles_of<Body>(points)");
    }
  }
}
/// Returns the particles of all bodies of a list; a body that is not given has none.
template <class List, class X, class... Tags, class... Points>
[[gnu::cold]] PerBody<BodyAtStart<X>, List> starts(ParticlesOf<Tags, Points> const&... given) {
  PerBody<BodyAtStart<X>, List> all;
  (give<List>(all, given), ...);
  return all;
}

template <class T>
inline constexpr bool are_of_body = false;
template <class Body, class Points>
inline constexpr bool are_of_body<ParticlesOf<Body, Points>> = true;
/// Whether two arguments are the particles of the material and of the walls, without the names of their bodies.
template <class A, class B>
inline constexpr bool are_particles = !are_of_body<A> && !are_of_body<B>;

/// Returns the identities of a number of particles: those of the ranges, in order, or counted from 0 if there are no
/// ranges.
[[gnu::cold]] std::vector<int> identities_at_start(std::size_t particles, std::vector<RangeHere> const& ranges);

/// Gives a body its particles.
template <class Body, class X>
[[gnu::cold]] void place(Body& body, BodyAtStart<X> const& start, double spacing) {
  using namespace fields;
  body.resize(static_cast<int>(start.points.size()));
  body.from_host(position, start.points);
  body.from_host(identity, identities_at_start(start.points.size(), start.ranges));
  body.fill(volume, typename X::Scalar(std::pow(spacing, X::RowsAtCompileTime)));
  if constexpr (OneOf<RestPosition, typename Body::fields>) body.from_host(rest_position, start.points);
  if constexpr (OneOf<Group, typename Body::fields>)
    if (!start.groups.empty()) body.from_host(group, start.groups);
}

/// Throws std::invalid_argument if a body has no groups, or groups that the motion does not have.
template <class X>
[[gnu::cold]] void check_groups(int known, BodyAtStart<X> const& start, std::string const& name_of_body) {
  if (start.points.empty()) return;
  if (start.groups.empty())
    throw std::invalid_argument(
        formatted("scree: the motion is by group, and the %s has none: make the solver from Groups, not from points",
                  name_of_body.c_str()));
  for (int const number : start.groups)
    if (number >= known)
      throw std::invalid_argument(
          formatted("scree: group %d of the %s, '%s', has no motion: the motion is that of %d groups, counted from 0",
                    number, name_of_body.c_str(), start.names[std::size_t(number)].c_str(), known));
}
/// Runs check_groups() for all bodies that the motion of a formulation moves by group.
template <class P, class X>
void check_groups([[maybe_unused]] typename P::motion const& motion,
                  PerBody<BodyAtStart<X>, typename P::bodies> const& start) {
  for_each_body(typename P::bodies{}, [&]<class Body>() {
    if constexpr (OneOf<Group, fields_to_move<P, Body>> && !RigidTag<Body>)
      check_groups(motion_of_body<Body>(motion).groups(), start.template of<Body>(), std::string(Body::name));
  });
}

/// Throws std::runtime_error if the particles of a snapshot have other groups than the particles of a body (`here`). If
/// `sorted` is true, the order of the particles may differ.
[[gnu::cold]] void require_same_groups(Snapshot const& snapshot, std::vector<int> here, std::string const& name_of_body,
                                       bool sorted);
/// Runs require_same_groups() for all bodies that move by group, rigid bodies included.
template <class P, class Sys>
void require_same_groups_in(Snapshot const& snapshot, Sys const& system) {
  for_each_body(typename P::bodies{}, [&]<class Body>() {
    if constexpr (OneOf<Group, fields_to_move<P, Body>>)
      require_same_groups(snapshot, system.template whole<Body>().values(fields::group), std::string(Body::name),
                          EvolvingBody<Body>);
  });
}

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "body_at_start.ipp"
#endif
