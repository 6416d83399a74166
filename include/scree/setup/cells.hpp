// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/available_memory.hpp"
#include "../core/in_layers.hpp"
#include "../fields/shared_points.hpp"
#include "row_distance.hpp"
#include "shapes/shape.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Parts shared by the lattices of the set-up.
namespace scree::detail {

/// A tolerance in units of the spacing, so that rounding errors do not decide whether lattice positions on a boundary
/// are inside.
inline constexpr double tie = 1e-9;

void check_spacing(double spacing);
void check_rows(int rows);
template <int Dim>
void check_finite(Box<Dim> const& box) {
  if (!box.low.allFinite() || !box.high.allFinite())
    throw std::invalid_argument("set-up: a shape without finite bounds cannot be filled; intersect it with a Box");
}

/// Throws std::invalid_argument with the message that a shape with these extents (m) has no room for a particle.
[[noreturn]] void refuse_empty(char const* shape, std::initializer_list<double> extents, double spacing);
/// Throws std::invalid_argument if no point was placed in a shape that has a name; combinations of shapes have none.
template <Shape S>
void check_not_empty(S const& shape, double spacing, double points) {
  if constexpr (requires { S::name; }) {
    if (points > 0) return;
    auto const bounds = shape.bounds();
    auto const extent = [&](int axis) { return bounds.high[axis] - bounds.low[axis]; };
    if constexpr (S::dim == 2)
      refuse_empty(S::name, {extent(0), extent(1)}, spacing);
    else
      refuse_empty(S::name, {extent(0), extent(1), extent(2)}, spacing);
  }
}

/// Whether a particle at x belongs to the shape; one on the boundary does not.
template <Shape S>
bool stands_inside(S const& shape, Vec<S::dim, double> const& x, double spacing) {
  return shape.signed_distance(x) < -tie * spacing;
}

template <int Dim>
using Index = std::array<long, static_cast<std::size_t>(Dim)>;

/// Calls visit(index) for every index from `first` up to, but not including, `last`; the first axis runs fastest.
template <int Dim, class F>
void visit_indices(Index<Dim> const& first, Index<Dim> const& last, F const& visit) {
  for (std::size_t axis = 0; axis < first.size(); ++axis)
    if (first[axis] >= last[axis]) return;
  Index<Dim> index = first;
  while (index.back() < last.back()) {
    visit(index);
    ++index[0];
    for (std::size_t axis = 0; axis + 1 < index.size() && index[axis] == last[axis]; ++axis) {
      index[axis] = first[axis];
      ++index[axis + 1];
    }
  }
}

/// Calls visit(from, to) with the range of indices of each layer along the last axis. With `Shared`, the threads of the
/// host share the layers.
template <int Dim, bool Shared, class F>
void visit_layers(Index<Dim> const& first, Index<Dim> const& last, F const& visit) {
  auto const visit_layer = [&](long layer) {
    Index<Dim> from = first, to = last;
    from.back() += layer, to.back() = from.back() + 1;
    visit(from, to);
  };
  long const layers = last.back() - first.back();
  if constexpr (Shared)
    for_each_layer(layers, visit_layer);
  else
    for (long layer = 0; layer < layers; ++layer) visit_layer(layer);
}

/// Returns the number of indices that visit_indices() visits.
template <int Dim>
double number_between(Index<Dim> const& first, Index<Dim> const& last) {
  double number = 1;
  for (std::size_t axis = 0; axis < first.size(); ++axis)
    number *= std::max(0.0, double(last[axis]) - double(first[axis]));
  return number;
}
/// Returns a length in spacings, rounded to a whole number. Throws std::invalid_argument if it is too large to count.
long rounded_count(double spacings);
/// Calls place(index, x) for each index, and returns the points x of the calls that return true. The threads of the
/// host share the layers of indices, and each layer has its own copy of `place`.
template <int Dim, class Place>
std::vector<Vec<Dim, double>> points_in_layers(Index<Dim> const& first, Index<Dim> const& last, Place const& place) {
  std::vector<std::vector<Vec<Dim, double>>> layers(std::size_t(std::max(last.back() - first.back(), 0L)));
  visit_layers<Dim, true>(first, last, [&](Index<Dim> const& from, Index<Dim> const& to) {
    Place here = place;
    Vec<Dim, double> x;
    auto& points = layers[static_cast<std::size_t>(from.back() - first.back())];
    visit_indices<Dim>(from, to, [&](Index<Dim> const& index) {
      if (here(index, x)) points.push_back(x);
    });
  });
  std::vector<Vec<Dim, double>> all;
  std::size_t number = 0;
  for (auto const& points : layers) number += points.size();
  all.reserve(number);
  for (auto const& points : layers) all.insert(all.end(), points.begin(), points.end());
  return all;
}
/// Returns the points that `place` accepts in a range of indices. The points are counted before they are created,
/// unless there is enough memory for all indices and a growing vector. If there is enough memory and `Shared` is true,
/// the threads of the host share the layers of indices.
template <int Dim, bool Shared = false, class Place>
std::vector<Vec<Dim, double>> points_at(Index<Dim> const& first, Index<Dim> const& last, Place place) {
  using vector = Vec<Dim, double>;
  std::vector<vector> points;
  vector x;
  double const indices = number_between<Dim>(first, last);
  check_number(indices);
  if (3 * indices * sizeof(vector) > available_memory()) {
    double kept = 0;
    visit_indices<Dim>(first, last, [&](Index<Dim> const& index) { kept += place(index, x); });
    check_memory(kept, sizeof(vector));
    points.reserve(static_cast<std::size_t>(kept));
  } else if constexpr (Shared) {
    return points_in_layers<Dim>(first, last, place);
  }
  visit_indices<Dim>(first, last, [&](Index<Dim> const& index) {
    if (place(index, x)) points.push_back(x);
  });
  return points;
}

/// Returns a share of the points that `place` accepts, in the order of points_at(). All points are counted first;
/// memory is needed only for the share.
template <int Dim, bool Shared = false, class Place>
SharedPoints<Dim> share_at(Index<Dim> const& first, Index<Dim> const& last, Place const& place,
                           ShareOfRank const& share) {
  share.check();
  check_number(number_between<Dim>(first, last));
  auto const layer_of = [&](Index<Dim> const& index) { return std::size_t(index.back() - first.back()); };
  auto const visit_points = [&](Index<Dim> const& from, Index<Dim> const& to, auto const& visit) {
    Place here = place;
    Vec<Dim, double> x;
    visit_indices<Dim>(from, to, [&](Index<Dim> const& index) {
      if (here(index, x)) visit(x);
    });
  };
  std::vector<long> starts(std::size_t(std::max(last.back() - first.back(), 0L)) + 1, 0);  // points before each layer
  visit_layers<Dim, Shared>(first, last, [&](Index<Dim> const& from, Index<Dim> const& to) {
    long count = 0;
    visit_points(from, to, [&](auto const&) { ++count; });
    starts[layer_of(from) + 1] = count;
  });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  SharedPoints<Dim> mine{{}, share.first_of(starts.back()), starts.back()};
  long const end = share.end_of(mine.all);
  check_memory(double(end - mine.first), sizeof(Vec<Dim, double>));
  mine.points.resize(std::size_t(end - mine.first));
  visit_layers<Dim, Shared>(first, last, [&](Index<Dim> const& from, Index<Dim> const& to) {
    long number = starts[layer_of(from)];
    if (number >= end || starts[layer_of(from) + 1] <= mine.first) return;
    visit_points(from, to, [&](auto const& x) {
      if (number >= mine.first && number < end) mine.points[std::size_t(number - mine.first)] = x;
      ++number;
    });
  });
  return mine;
}

/// Cubes of a Cartesian lattice whose centres are inside a box. Their number along each axis is rounded. The anchor is
/// a corner of the cube with index zero.
template <int Dim>
struct Cells {
  Vec<Dim, double> anchor;
  double spacing;
  Index<Dim> first, last;

  Cells(Box<Dim> const& box, double edge, Vec<Dim, double> const& corner) : anchor(corner), spacing(edge) {
    check_spacing(edge);
    check_finite(box);
    check_finite(Box<Dim>{corner, corner});
    for (int axis = 0; axis < Dim; ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      first[k] = rounded_count((box.low[axis] - corner[axis]) / edge);
      last[k] = rounded_count((box.high[axis] - corner[axis]) / edge);
    }
  }

  bool contains(Index<Dim> const& index) const {
    for (std::size_t k = 0; k < index.size(); ++k)
      if (index[k] < first[k] || index[k] >= last[k]) return false;
    return true;
  }
  /// Returns the centres of the cubes for which keep(index, centre) is true. With `Shared`, the threads of the host
  /// share the layers of cubes, and each layer has its own copy of `keep`.
  template <bool Shared = false, class Keep>
  std::vector<Vec<Dim, double>> centres(Keep keep) const {
    return points_at<Dim, Shared>(first, last, placing(std::move(keep)));
  }
  /// Returns a share of the centres of the cubes for which keep(index, centre) is true.
  template <bool Shared = false, class Keep>
  SharedPoints<Dim> centres(Keep keep, ShareOfRank const& share) const {
    return share_at<Dim, Shared>(first, last, placing(std::move(keep)), share);
  }

 private:
  template <class Keep>
  auto placing(Keep keep) const {
    return [this, keep = std::move(keep)](Index<Dim> const& index, Vec<Dim, double>& x) mutable {
      for (int axis = 0; axis < Dim; ++axis)
        x[axis] = anchor[axis] + spacing * (double(index[static_cast<std::size_t>(axis)]) + 0.5);
      return bool(keep(index, x));
    };
  }
};

/// The cells that the material of a shape fills: those whose centres are inside the shape.
template <Shape S>
class Filled {
 public:
  Filled(S const& shape, Box<S::dim> const&, double edge, Vec<S::dim, double> const&)
      : limit_(-tie * edge), distance_(shape, limit_, limit_) {}
  bool operator()(Index<S::dim> const&, Vec<S::dim, double> const& x) { return distance_(x) < limit_; }

 private:
  double limit_;
  RowDistance<S> distance_;
};
/// The cells that fill a box. Their number along each axis is rounded, which decides whether cells on the sides are
/// filled.
template <int Dim>
struct Filled<Box<Dim>> {
  Cells<Dim> cells;
  Filled(Box<Dim> const& box, Box<Dim> const& region, double edge, Vec<Dim, double> const& corner)
      : cells(overlap(box, region), edge, corner) {}
  bool operator()(Index<Dim> const& index, Vec<Dim, double> const&) const { return cells.contains(index); }
};

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "cells.ipp"
#endif
