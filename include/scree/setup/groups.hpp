// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

/// Consecutive Identity numbers: from `first` up to, not including, `last`.
struct IdentityRange {
  int first = 0, last = 0;

  int size() const { return last - first; }
  SCREE_FN bool contains(int number) const { return number >= first && number < last; }
};

/// The particles of one body, collected in named groups. Groups are numbered from 0 in the order in which they are
/// added; a solver made from them gives each particle the number of its group (field `group`). Identity numbers count
/// the particles of a body in the order in which they are given, so a group is always a range of these numbers.
template <int Dim>
class Groups {
 public:
  /// Appends a group; it may be empty. Returns the collection, so that calls can be chained. Throws
  /// std::invalid_argument if there is a group of this name, and so do all functions that take the name of a group if
  /// there is none.
  Groups& add(std::string const& name, std::vector<Vec<Dim, double>> const& points) {
    for (auto const& each : groups_)
      if (each.name == name) throw std::invalid_argument("set-up: group '" + name + "' exists already; " + known());
    int const first = static_cast<int>(points_.size());
    points_.insert(points_.end(), points.begin(), points.end());
    groups_.push_back({name, {first, static_cast<int>(points_.size())}});
    return *this;
  }

  /// All particles, m, in the order of the groups.
  std::vector<Vec<Dim, double>> const& points() const { return points_; }
  IdentityRange range(std::string const& name) const { return groups_[place_of(name)].range; }
  /// Number of a group.
  int number(std::string const& name) const { return static_cast<int>(place_of(name)); }
  /// Number of groups.
  int count() const { return static_cast<int>(groups_.size()); }
  /// The number of the group of each particle.
  std::vector<int> numbers() const {
    std::vector<int> result;
    for (std::size_t k = 0; k < groups_.size(); ++k)
      result.insert(result.end(), static_cast<std::size_t>(groups_[k].range.size()), static_cast<int>(k));
    return result;
  }
  /// Name of the group of a particle.
  std::string const& name_of(int particle) const {
    for (auto const& each : groups_)
      if (each.range.contains(particle)) return each.name;
    throw std::out_of_range("set-up: no particle " + std::to_string(particle) + " among " +
                            std::to_string(points_.size()));
  }
  /// In the order in which they were added.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (auto const& each : groups_) result.push_back(each.name);
    return result;
  }

 private:
  struct Named {
    std::string name;
    IdentityRange range;
  };

  std::size_t place_of(std::string const& name) const {
    for (std::size_t k = 0; k < groups_.size(); ++k)
      if (groups_[k].name == name) return k;
    throw std::invalid_argument("set-up: no group '" + name + "'; " + known());
  }
  std::string known() const {
    std::string list;
    for (auto const& each : groups_) list += (list.empty() ? "'" : ", '") + each.name + "'";
    return "known groups: " + (list.empty() ? "none" : list);
  }

  std::vector<Named> groups_;
  std::vector<Vec<Dim, double>> points_;
};

}  // namespace scree
