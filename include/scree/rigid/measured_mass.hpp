// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../setup/cells.hpp"
#include "../setup/mesh/mesh.hpp"
#include "../setup/row_distance.hpp"
#include "../setup/shapes/shape.hpp"
#include "mass_properties.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

// Mass properties of bodies of uniform density, computed from a shape or from triangles.
namespace scree {

namespace detail {

/// Sums of the mass and of its first and second moments about a point.
template <int Dim>
struct MassSums {
  double mass = 0;
  Vec<Dim, double> first = Vec<Dim, double>::Zero();
  Mat<Dim, double> second = Mat<Dim, double>::Zero();

  MassProperties<Dim> about(Vec<Dim, double> const& point) const {
    Vec<Dim, double> const arm = first / mass;
    Mat<Dim, double> const S = second - mass * arm * arm.transpose();
    MassProperties<Dim> result{mass, point + arm, {}};
    if constexpr (Dim == 2)
      result.inertia(0, 0) = S.trace();
    else
      result.inertia = S.trace() * Mat<3, double>::Identity() - S;
    return result;
  }
};
inline void check_density_of_body(double rho) {
  check_setting(rho > 0 && std::isfinite(rho), "density of a rigid body (kg/m^3)", rho, "above 0");
}

}  // namespace detail

/// Returns the mass properties of a body of uniform density (kg/m^3) that fills a shape, from sums over cubes with an
/// edge of half a spacing (m). A cube at the boundary contributes the fraction 1/2 - d/e of its volume, see
/// VolumeBelow. The result is exact for axis-aligned blocks whose edges are multiples of the edge of the cubes, and
/// second-order accurate for smooth boundaries. Throws std::invalid_argument if density or spacing is not positive, or
/// if the shape has no volume or no finite bounds.
template <Shape S>
MassProperties<S::dim> mass_properties(S const& shape, double rho, double spacing) {
  static constexpr int dim = S::dim;
  using X = Vec<dim, double>;
  detail::check_density_of_body(rho);
  detail::check_spacing(spacing);
  check_shape(shape);
  detail::check_finite(shape.bounds());
  double const edge = spacing / 2, cube = math::power<dim>(edge);
  Box<dim> const region = detail::grown(shape.bounds(), edge);
  detail::Cells<dim> const cells(region, edge, shape.bounds().low);
  check_number(detail::number_between<dim>(cells.first, cells.last));
  X const middle = (region.low + region.high) / 2;
  detail::MassSums<dim> sums;
  detail::RowDistance<S> distance(shape, -edge / 2, edge / 2);
  detail::Index<dim> last = cells.last;
  for (auto& k : last) ++k;
  detail::visit_indices<dim>(cells.first, last, [&](detail::Index<dim> const& index) {
    X x;
    for (int axis = 0; axis < dim; ++axis)
      x[axis] = shape.bounds().low[axis] + edge * (double(index[std::size_t(axis)]) + 0.5);
    double const m = rho * cube * std::clamp(0.5 - distance(x) / edge, 0.0, 1.0);
    X const arm = x - middle;
    sums.mass += m;
    sums.first += m * arm;
    sums.second += m * (arm * arm.transpose() + edge * edge / 12 * Mat<dim, double>::Identity());
  });
  if (!(sums.mass > 0)) throw std::invalid_argument("scree: the shape of a rigid body has no volume");
  return sums.about(middle);
}

/// Returns the exact mass properties of a body of uniform density (kg/m^3) bounded by triangles, from sums over the
/// tetrahedra between the triangles and a point (Tonon 2004, J. Math. Stat. 1, 8-11). Throws std::invalid_argument if
/// the density is not positive, or if the mesh has holes or triangles that point inwards; such a mesh can be measured
/// as a shape.
inline MassProperties<3> mass_properties(Mesh const& mesh, double rho) {
  detail::check_density_of_body(rho);
  auto const& report = mesh.report();
  if (!report.encloses_exactly())
    throw std::invalid_argument(
        "scree: " + report.name +
        " has holes or triangles that point inwards: use mass_properties(mesh, density, spacing)");
  Vec<3, double> const middle = (report.bounds.low + report.bounds.high) / 2;
  detail::MassSums<3> sums;
  auto const& triangles = mesh.triangles();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Mat<3, double> corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = triangles.vertex(t, std::size_t(k)) - middle;
    double const m = rho * corners.determinant() / 6;
    Vec<3, double> const sum = corners.rowwise().sum();
    sums.mass += m;
    sums.first += m / 4 * sum;
    sums.second += m / 20 * (sum * sum.transpose() + corners * corners.transpose());
  }
  return sums.about(middle);
}

}  // namespace scree
