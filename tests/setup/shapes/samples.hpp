// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/setup/lattice.hpp>
#include <scree/setup/shapes.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

// Sample shapes, and a comparison of their signed distances with brute force.
namespace scree::test {

inline Box<2> const sheet{{-0.8, -0.5}, {0.7, 0.9}};
inline Ball<2> const disc{.centre = {0.3, -0.1}, .radius = 0.8};
inline HalfSpace<2> const below{.point = {0.1, 0.2}, .normal = {-0.6, 1.6}};
inline Box<3> const block{{-0.8, -0.5, -0.6}, {0.7, 0.9, 0.3}};
inline Ball<3> const sphere{.centre = {0.3, -0.1, 0.2}, .radius = 0.8};
inline Cylinder const drum{.axis = 1, .centre = {0.2, 7, -0.1}, .radius = 0.7, .from = -0.6, .to = 0.4};

inline bool in_sheet(Vec<2, double> const& x) { return x[0] > -0.8 && x[0] < 0.7 && x[1] > -0.5 && x[1] < 0.9; }
inline bool in_disc(Vec<2, double> const& x) { return sq(x[0] - 0.3) + sq(x[1] + 0.1) < 0.64; }
inline bool in_below(Vec<2, double> const& x) { return 1.6 * (x[1] - 0.2) < 0.6 * (x[0] - 0.1); }

template <int Dim>
Box<Dim> surroundings() {
  return {Vec<Dim, double>::Constant(-1.7), Vec<Dim, double>::Constant(1.7)};
}

/// Points at which signed distances are tested.
template <int Dim>
std::vector<Vec<Dim, double>> probes() {
  auto points =
      fill_lattice(Box<Dim>{Vec<Dim, double>::Constant(-1), Vec<Dim, double>::Constant(1)}, Dim == 2 ? 0.13 : 0.4);
  jitter(points, 0.1, 3);
  return points;
}

enum class Exact { inside, outside, everywhere, nowhere };

/// Compares with the distance to the nearest of many samples on the other side of the boundary, which is never less
/// than the true distance and exceeds it by at most the diagonal of a sample's cell.
template <Shape S, class Inside>
void check_distances(S const& shape, Inside const& inside, Exact exact) {
  static constexpr int dim = S::dim;
  double const edge = dim == 2 ? 0.01 : 0.05, diagonal = edge * std::sqrt(double(dim));
  std::vector<Vec<dim, double>> in, out;
  for (auto const& x : fill_lattice(surroundings<dim>(), edge)) (inside(x) ? in : out).push_back(x);
  for (auto const& x : probes<dim>()) {
    bool const is_inside = inside(x);
    double nearest = std::numeric_limits<double>::infinity();
    for (auto const& y : is_inside ? out : in) nearest = std::min(nearest, (x - y).norm());
    double const signed_distance = shape.signed_distance(x), distance = std::abs(signed_distance);
    CAPTURE(x.transpose(), signed_distance, nearest);
    CHECK(shape.contains(x) == is_inside);
    CHECK((signed_distance < 0) == is_inside);
    CHECK(distance <= nearest);
    bool const reached = exact == Exact::everywhere || exact == (is_inside ? Exact::inside : Exact::outside);
    if (reached) CHECK(distance > nearest - diagonal);
  }
}

}  // namespace scree::test
