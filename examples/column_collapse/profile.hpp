// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace column_collapse {

/// Depth of a deposit over the distance from the axis, from the volume of the particles in slices two spacings wide:
/// half of a column in the plane, a quarter of one in 3D.
class Profile {
 public:
  /// Positions with a last coordinate that points upwards; spacing in m.
  template <class Positions>
  Profile(Positions const& positions, double spacing) : width_(2 * spacing) {
    constexpr int dim = std::remove_cvref_t<decltype(positions[0])>::RowsAtCompileTime;
    for (auto const& x : positions) {
      double const distance = dim == 2 ? std::abs(double(x[0])) : std::hypot(double(x[0]), double(x[1]));
      auto const slice = std::size_t(distance / width_);
      if (slice >= depth_.size()) depth_.resize(slice + 1, 0.0);
      double const area = dim == 2 ? width_ : std::numbers::pi / 2 * middle(slice) * width_;
      depth_[slice] += std::pow(spacing, dim) / area;
    }
  }

  std::size_t slices() const { return depth_.size(); }
  double middle(std::size_t slice) const { return (double(slice) + 0.5) * width_; }  // m
  double depth(std::size_t slice) const { return slice < depth_.size() ? depth_[slice] : 0; }

  /// Outermost distance at which the deposit is `deep` (m), between the middles of slices; 0 if there is none.
  double reach(double deep) const {
    for (std::size_t slice = depth_.size(); slice-- > 0;)
      if (depth(slice) >= deep)
        return middle(slice) + width_ * (depth(slice) - deep) / (depth(slice) - depth(slice + 1));
    return 0;
  }
  /// Depth near the axis, mean over three slices, m.
  double summit() const { return (depth(0) + depth(1) + depth(2)) / 3; }

 private:
  double width_;
  std::vector<double> depth_;
};

}  // namespace column_collapse
