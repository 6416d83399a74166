// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "mid_chord.hpp"

// C over the distance from the axis; rotation alone would not change it.
namespace drum {

struct Ring {
  double particles = 0, radius = 0, C = 0, number_density = 0;
};

/// Rings a twentieth of the radius wide, at least one spacing; sums of one state or several.
class Rings {
 public:
  void add(State const& state, Drum const& drum) {
    double const width = std::max(drum.radius / 20, drum.spacing);
    for (std::size_t i : middle(state, drum)) {
      double const radius = std::hypot(state.x[i], state.z[i]);
      auto const ring = static_cast<std::size_t>(radius / width);
      if (ring >= sums_.size()) sums_.resize(ring + 1);
      Ring& sum = sums_[ring];
      sum.particles += 1, sum.radius += radius, sum.C += state.C[i], sum.number_density += state.number_density[i];
    }
  }
  void add(Rings const& other) {
    sums_.resize(std::max(sums_.size(), other.sums_.size()));
    for (std::size_t k = 0; k < other.sums_.size(); ++k) {
      sums_[k].particles += other.sums_[k].particles, sums_[k].radius += other.sums_[k].radius;
      sums_[k].C += other.sums_[k].C, sums_[k].number_density += other.sums_[k].number_density;
    }
  }
  /// Without empty rings, outwards.
  std::vector<Ring> mean() const {
    std::vector<Ring> result;
    for (Ring ring : sums_) {
      if (ring.particles == 0) continue;
      ring.radius /= ring.particles, ring.C /= ring.particles, ring.number_density /= ring.particles;
      result.push_back(ring);
    }
    return result;
  }

  /// Calls a function with each of the sums, see pack().
  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor.size(sums_);
    for (Ring& sum : sums_)
      for (double* value : {&sum.particles, &sum.radius, &sum.C, &sum.number_density}) visitor(*value);
  }

 private:
  std::vector<Ring> sums_;
};

}  // namespace drum
