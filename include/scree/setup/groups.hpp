// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

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

/// The particles of one body, collected in named groups. Identity numbers count the particles of a body in the order in
/// which they are given, so a group is always a range of these numbers.
template <int Dim>
class Groups {
 public:
  /// Appends a group; it may be empty. Returns the collection, so that calls can be chained.
  Groups& add(std::string const& name, std::vector<Vec<Dim, double>> const& points) {
    for (auto const& group : groups_)
      if (group.name == name) throw std::invalid_argument("set-up: group '" + name + "' exists already; " + known());
    int const first = static_cast<int>(points_.size());
    points_.insert(points_.end(), points.begin(), points.end());
    groups_.push_back({name, {first, static_cast<int>(points_.size())}});
    return *this;
  }

  /// All particles, m, in the order of the groups.
  std::vector<Vec<Dim, double>> const& points() const { return points_; }
  IdentityRange range(std::string const& name) const {
    for (auto const& group : groups_)
      if (group.name == name) return group.range;
    throw std::invalid_argument("set-up: no group '" + name + "'; " + known());
  }
  /// Name of the group of a particle.
  std::string const& name_of(int number) const {
    for (auto const& group : groups_)
      if (group.range.contains(number)) return group.name;
    throw std::out_of_range("set-up: no particle " + std::to_string(number) + " among " +
                            std::to_string(points_.size()));
  }
  /// In the order in which they were added.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (auto const& group : groups_) result.push_back(group.name);
    return result;
  }

 private:
  struct Group {
    std::string name;
    IdentityRange range;
  };

  std::string known() const {
    std::string list;
    for (auto const& group : groups_) list += (list.empty() ? "'" : ", '") + group.name + "'";
    return "known groups: " + (list.empty() ? "none" : list);
  }

  std::vector<Group> groups_;
  std::vector<Vec<Dim, double>> points_;
};

}  // namespace scree
