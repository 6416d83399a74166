// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/standard.hpp"
#include "../setup/groups.hpp"
#include "formulation.hpp"
#include "snapshot_of.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// The particles that a solver is made from: points, or named groups of points.
namespace scree::detail {

/// A body before the first step.
template <class X>
struct BodyAtStart {
  std::vector<X> points;                // m
  std::vector<int> groups = {};         // of each particle; empty for plain points
  std::vector<std::string> names = {};  // of the groups
};
template <class X>
BodyAtStart<X> at_start(std::vector<X> const& points) {
  return {points};
}
template <class X>
BodyAtStart<X> at_start(Groups<X::RowsAtCompileTime> const& groups) {
  BodyAtStart<X> body{{}, groups.numbers(), groups.names()};
  for (auto const& x : groups.points()) body.points.push_back(x.template cast<typename X::Scalar>());
  return body;
}

template <class T>
inline constexpr bool is_groups = false;
template <int Dim>
inline constexpr bool is_groups<Groups<Dim>> = true;

/// Gives a body its particles.
template <class Body, class X>
[[gnu::cold]] void place(Body& body, BodyAtStart<X> const& start, double spacing) {
  body.resize(static_cast<int>(start.points.size()));
  std::vector<int> numbers(start.points.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  body.from_host(position, start.points);
  body.from_host(identity, numbers);
  body.fill(volume, typename X::Scalar(std::pow(spacing, X::RowsAtCompileTime)));
  if constexpr (OneOf<RestPosition, typename Body::fields>) body.from_host(rest_position, start.points);
  if constexpr (OneOf<Group, typename Body::fields>)
    if (!start.groups.empty()) body.from_host(group, start.groups);
}

/// Throws std::invalid_argument if a motion of some groups does not know those of a body.
template <class X>
[[gnu::cold]] void check_groups(int known, BodyAtStart<X> const& start, char const* name_of_body) {
  if (start.points.empty()) return;
  if (start.groups.empty())
    throw std::invalid_argument(
        formatted("scree: the motion is by group, and the %s has none: make the solver from Groups, not from points",
                  name_of_body));
  for (int const number : start.groups)
    if (number >= known)
      throw std::invalid_argument(
          formatted("scree: group %d of the %s, '%s', has no motion: the motion is that of %d groups, counted from 0",
                    number, name_of_body, start.names[std::size_t(number)].c_str(), known));
}
/// The same for all bodies that the motion of a formulation moves.
template <class P, class X>
void check_groups([[maybe_unused]] typename P::motion const& motion,
                  [[maybe_unused]] PerBody<BodyAtStart<X>> const& start) {
  if constexpr (OneOf<Group, fields_to_move<P, Material>>) check_groups(motion.groups(), start.material, "material");
  if constexpr (OneOf<Group, fields_to_move<P, Wall>>) check_groups(motion.groups(), start.wall, "wall");
}

/// Throws std::runtime_error if the particles of a snapshot have other groups than those of a body, whose order may
/// differ if it is sorted.
template <class Body>
[[gnu::cold]] void require_same_groups(Snapshot const& snapshot, Body const& body, char const* name_of_body,
                                       bool sorted) {
  SnapshotArray const* const array = snapshot.find(name_of_body + std::string("/group"));
  if (array == nullptr) return;  // the signature differs, too
  auto there = values_of<int>(*array), here = body.to_host(group);
  if (sorted) std::sort(there.begin(), there.end()), std::sort(here.begin(), here.end());
  if (there != here)
    refuse(snapshot,
           formatted("does not fit this run: the motion is by group, and the groups of the %s differ", name_of_body));
}
/// The same for all bodies that the motion of a formulation moves.
template <class P, class OfMaterial, class OfWall>
void require_same_groups([[maybe_unused]] Snapshot const& snapshot, [[maybe_unused]] OfMaterial const& material,
                         [[maybe_unused]] OfWall const& wall) {
  if constexpr (OneOf<Group, fields_to_move<P, Material>>) require_same_groups(snapshot, material, "material", true);
  if constexpr (OneOf<Group, fields_to_move<P, Wall>>) require_same_groups(snapshot, wall, "wall", false);
}

}  // namespace scree::detail
