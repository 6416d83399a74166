// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/available_memory.hpp"
#include "../core/compiled.hpp"
#include "../core/types.hpp"
#include "shared_points.hpp"

#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace scree {

/// A range of consecutive Identity numbers, from `first` up to but not including `last`.
struct IdentityRange {
  int first = 0, last = 0;  ///< the first number, and one past the last

  /// Returns the number of Identity numbers in the range.
  int size() const { return last - first; }
  /// Whether the range contains a number.
  SCREE_FN bool contains(int number) const { return number >= first && number < last; }
};

/// The ranges of Identity numbers of a body or of a group at the start of a case, on this rank and on all ranks
/// together.
struct RangeHere {
  IdentityRange here, all;  ///< the range on this rank, and the range on all ranks
};

/// The particles of one body, collected in named groups. Groups are numbered from 0 in the order in which they are
/// added; a solver made from the groups stores the group number of each particle (field `group`). Identity numbers
/// count the particles of a body in the order in which they are given, so that each group is a range of Identity
/// numbers. If each rank of a case has shares of the groups, numbers and ranges count the particles of the whole case.
template <int Dim>
class Groups {
 public:
  /// Appends a group, which may be empty. Returns the collection, so that calls can be chained. Throws
  /// std::invalid_argument if the name is empty, if a group of this name exists, or if other groups are shares. Other
  /// functions that take the name of a group throw std::invalid_argument if there is no such group.
  Groups& add(std::string const& name, std::vector<Vec<Dim, double>> const& points) {
    return add(name, points, 0, static_cast<long>(points.size()), points.empty() ? Given::empty : Given::whole);
  }
  /// Appends a group for which this rank gives only its share of the points. Throws std::invalid_argument if other
  /// groups are given whole.
  Groups& add(std::string const& name, std::same_as<SharedPoints<Dim>> auto const& share) {
    share.check();
    return add(name, share.points, share.first, share.all, Given::shares);
  }
  // For any other argument, a compile-time message explains which points a group takes.
  template <class Points>
  requires(!std::is_convertible_v<Points const&, std::vector<Vec<Dim, double>> const&> &&
           !std::same_as<Points, SharedPoints<Dim>>) Groups& add(std::string const&, Points const&) {
    static_assert(sizeof(Points) == 0,
                  "a group takes points of its dimension in double precision, std::vector<Vec<Dim, double>> or "
                  "SharedPoints<Dim>, whatever the precision of the formulation");
    return *this;
  }

  /// Returns the positions (m) of all particles that were given on this rank, in the order of the groups.
  std::vector<Vec<Dim, double>> const& points() const { return points_; }
  /// Returns the number of particles of all groups, including the shares of other ranks.
  long size() const { return groups_.empty() ? 0 : groups_.back().range.all.last; }
  /// Whether each rank gives only its shares of the groups.
  bool are_shares() const { return given_ == Given::shares; }
  /// Returns the ranges of the particles of each group, on this rank and on all ranks.
  std::vector<RangeHere> ranges_here() const {
    std::vector<RangeHere> all;
    for (auto const& each : groups_) all.push_back(each.range);
    return all;
  }
  /// Returns the Identity numbers of the particles of a group on all ranks.
  IdentityRange range(std::string const& name) const { return groups_[place_of(name)].range.all; }
  /// Returns the number of a group.
  int number(std::string const& name) const { return static_cast<int>(place_of(name)); }
  /// Returns the number of groups.
  int count() const { return static_cast<int>(groups_.size()); }
  /// Returns the group number of each particle that was given on this rank.
  std::vector<int> numbers() const { return numbers(&RangeHere::here); }
  /// Returns the group number of each particle of the whole case.
  std::vector<int> numbers_of_all() const { return numbers(&RangeHere::all); }
  /// Returns the name of the group to which the particle with a given Identity belongs. Throws std::out_of_range if the
  /// particle is in no group.
  std::string const& name_of(int particle) const {
    for (auto const& each : groups_)
      if (each.range.all.contains(particle)) return each.name;
    throw std::out_of_range("set-up: no particle " + std::to_string(particle) + " among " + std::to_string(size()));
  }
  /// Returns the names of the groups, in the order in which they were added.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (auto const& each : groups_) result.push_back(each.name);
    return result;
  }

 private:
  struct Named {
    std::string name;
    RangeHere range;
  };
  enum class Given { empty, whole, shares };

  Groups& add(std::string const& name, std::vector<Vec<Dim, double>> const& points, long first, long all, Given given);
  std::vector<int> numbers(IdentityRange RangeHere::*which) const;
  std::size_t place_of(std::string const& name) const;
  std::string known() const;

  std::vector<Named> groups_;
  std::vector<Vec<Dim, double>> points_;
  Given given_ = Given::empty;
};

template <int Dim>
Groups<Dim>& Groups<Dim>::add(std::string const& name, std::vector<Vec<Dim, double>> const& points, long first,
                              long all, Given given) {
  if (name.empty()) throw std::invalid_argument("set-up: the name of a group must not be empty");
  for (auto const& each : groups_)
    if (each.name == name) throw std::invalid_argument("set-up: group '" + name + "' exists already; " + known());
  if (given != Given::empty && given_ != Given::empty && given != given_)
    throw std::invalid_argument("set-up: group '" + name + "' is given " +
                                (given == Given::whole ? "whole and others in shares" : "in shares and others whole") +
                                ": share_of(points, share) makes a share of whole points");
  if (given != Given::empty) given_ = given;
  check_number(double(size()) + double(all));
  int const start = static_cast<int>(size()), here = start + static_cast<int>(first);
  points_.insert(points_.end(), points.begin(), points.end());
  groups_.push_back({name, {{here, here + static_cast<int>(points.size())}, {start, start + static_cast<int>(all)}}});
  return *this;
}

template <int Dim>
std::vector<int> Groups<Dim>::numbers(IdentityRange RangeHere::*which) const {
  std::vector<int> result;
  for (std::size_t k = 0; k < groups_.size(); ++k)
    result.insert(result.end(), static_cast<std::size_t>((groups_[k].range.*which).size()), static_cast<int>(k));
  return result;
}

template <int Dim>
std::size_t Groups<Dim>::place_of(std::string const& name) const {
  for (std::size_t k = 0; k < groups_.size(); ++k)
    if (groups_[k].name == name) return k;
  throw std::invalid_argument("set-up: no group '" + name + "'; " + known());
}

template <int Dim>
std::string Groups<Dim>::known() const {
  std::string list;
  for (auto const& each : groups_) list += (list.empty() ? "'" : ", '") + each.name + "'";
  return "known groups: " + (list.empty() ? "none" : list);
}

}  // namespace scree

#ifdef SCREE_COMPILED
SCREE_INSTANCE class scree::Groups<2>;
SCREE_INSTANCE class scree::Groups<3>;
#endif
