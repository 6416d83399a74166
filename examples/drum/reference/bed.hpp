// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "lists.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grains {

/// Mean and largest overlap, over the diameter of the smaller grain, and the number of contacts of a grain.
struct Overlaps {
  double mean = 0, largest = 0, contacts = 0;
};

class Bed {
 public:
  Bed(Settings settings, std::vector<Grain> const& grains);

  /// Advances by a number of steps.
  void advance(long steps);
  void set_rotation(double rotation) { settings_.rotation = rotation; }

  /// In the order in which they were given.
  std::vector<Grain> grains() const;
  Overlaps overlaps() const;
  double kinetic_energy() const;  ///< of the grains that move, all replicas, J

  Settings const& settings() const { return settings_; }
  double time() const { return double(steps_) * settings_.step; }
  long steps() const { return steps_; }
  long rebuilds() const { return rebuilds_; }
  /// Looks at the lists that found a grain further from its place in them than half the skin.
  long late_rebuilds() const { return late_; }
  int mobile() const { return mobile_; }
  int size() const { return size_; }
  /// The first grain of each kind, and their number.
  std::array<int, max_kinds + 1> const& first() const { return first_; }
  State const& state() const { return now_; }
  Units const& units() const { return units_; }

 private:
  void rebuild();
  double farthest(double ahead) const;  // largest displacement since the last rebuild, so many seconds ahead

  Settings settings_;
  Law law_;
  Units units_;
  int size_ = 0, mobile_ = 0, kinds_ = 0;
  std::array<int, max_kinds + 1> first_ = {};
  State now_, other_;
  Lists lists_;
  long steps_ = 0, rebuilds_ = 0, late_ = 0;
  double angle_ = 0;
};

}  // namespace grains

#include "bed.ipp"
