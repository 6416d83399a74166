// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cells.hpp"
#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace scree {
namespace detail {

/// Returns the exact volume below a level of the last coordinate, m^dim, if it is known.
template <Shape S>
std::optional<double> exact_volume_below(S const& shape, double level) {
  if constexpr (requires { shape.exact_volume_below(level); })
    return shape.exact_volume_below(level);
  else
    return std::nullopt;
}
template <int Dim>
std::optional<double> exact_volume_below(Box<Dim> box, double level) {
  box.high[Dim - 1] = std::min(box.high[Dim - 1], level);
  return (box.high - box.low).cwiseMax(0.0).prod();
}
template <int Dim>
std::optional<double> exact_volume_below(Ball<Dim> const& ball, double level) {
  double const r = ball.radius, cap = std::clamp(level - (ball.centre[Dim - 1] - r), 0.0, 2 * r);
  if constexpr (Dim == 3)
    return std::numbers::pi * sq(cap) * (r - cap / 3);
  else
    return sq(r) * std::acos(std::clamp(1 - cap / r, -1.0, 1.0)) - (r - cap) * std::sqrt(cap * (2 * r - cap));
}
inline std::optional<double> exact_volume_below(Cylinder const& cylinder, double level) {
  double const from = cylinder.from, r = cylinder.radius;
  if (cylinder.axis == 2) return std::numbers::pi * sq(r) * std::clamp(level - from, 0.0, cylinder.to - from);
  Ball<2> const section{.centre = {0, cylinder.centre[2]}, .radius = r};
  return *exact_volume_below(section, level) * (cylinder.to - from);
}

}  // namespace detail

/// The volume of a shape below levels of the last coordinate, m^dim. It is exact for Box, Ball, Cylinder and shapes
/// with a member `exact_volume_below`; otherwise it is a sum over cubes with an edge e of half a spacing. A cube whose
/// centre has the signed distance d contributes the share 1/2 - d/e of its volume, limited to 0 to 1. The sum is exact
/// for flat surfaces along an axis and of second order in the spacing for smooth surfaces.
template <Shape S>
class VolumeBelow {
 public:
  /// Throws std::invalid_argument if the shape has no finite bounds or the spacing (m) is not positive.
  VolumeBelow(S const& shape, double spacing) : shape_(shape), bounds_(shape.bounds()) {
    check_shape(shape);
    detail::check_spacing(spacing);
    detail::check_finite(bounds_);
    if (!detail::exact_volume_below(shape, top())) sum_layers(spacing / 2);
  }

  double operator()(double level) const {
    if (layers_.empty()) return *detail::exact_volume_below(shape_, level);
    double const place = std::clamp((level - bottom_) / edge_, 0.0, double(layers_.size() - 1));
    auto const k = std::min(static_cast<std::size_t>(place), layers_.size() - 2);
    return layers_[k] + (place - double(k)) * (layers_[k + 1] - layers_[k]);
  }
  /// Returns the volume of the whole shape, m^3 (m^2 in 2D).
  double total() const { return (*this)(top()); }
  /// Returns the level (m) below which the shape has the volume `wanted`, to rounding; the top of the shape if it has
  /// less.
  double level_of(double wanted) const {
    double low = bounds_.low[S::dim - 1], high = top();
    for (int k = 0; k < 200 && low < high; ++k) {
      double const middle = low + (high - low) / 2;
      if (middle == low || middle == high) break;
      ((*this)(middle) < wanted ? low : high) = middle;
    }
    return high;
  }

 private:
  double top() const { return bounds_.high[S::dim - 1]; }
  /// Computes the volume below the bottom of each layer of cubes and below the top of the last one. The layers extend
  /// one cube beyond the bounds of the shape.
  void sum_layers(double edge) {
    static constexpr auto up = static_cast<std::size_t>(S::dim - 1);
    Box<S::dim> const region = detail::grown(bounds_, edge);
    detail::Cells<S::dim> const cells(region, edge, region.low);
    check_number(detail::number_between<S::dim>(cells.first, cells.last));
    edge_ = edge, bottom_ = region.low[S::dim - 1];
    layers_.assign(static_cast<std::size_t>(cells.last[up] - cells.first[up]) + 2, 0.0);
    detail::Index<S::dim> last = cells.last;
    for (auto& k : last) ++k;
    detail::visit_layers<S::dim, detail::is_costly<S>>(
        cells.first, last, [&](detail::Index<S::dim> const& from, detail::Index<S::dim> const& to) {
          detail::RowDistance<S> distance(shape_, -edge / 2, edge / 2);
          double layer = 0;
          detail::visit_indices<S::dim>(from, to, [&](detail::Index<S::dim> const& index) {
            Vec<S::dim, double> x;
            for (int axis = 0; axis < S::dim; ++axis)
              x[axis] = region.low[axis] + edge * (double(index[static_cast<std::size_t>(axis)]) + 0.5);
            layer += math::power<S::dim>(edge) * std::clamp(0.5 - distance(x) / edge, 0.0, 1.0);
          });
          layers_[static_cast<std::size_t>(from[up] - cells.first[up]) + 1] = layer;
        });
    for (std::size_t k = 1; k < layers_.size(); ++k) layers_[k] += layers_[k - 1];
  }

  S shape_;
  Box<S::dim> bounds_;
  std::vector<double> layers_;
  double edge_ = 0, bottom_ = 0;
};

/// Returns the volume of a shape, m^dim, as VolumeBelow computes it with this spacing (m).
template <Shape S>
double volume_of(S const& shape, double spacing) {
  return VolumeBelow<S>(shape, spacing).total();
}

}  // namespace scree
