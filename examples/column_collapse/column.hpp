// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/granular.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

// A column of grains that is released: half of it in the plane, a quarter of a cylinder in 3D. Smooth walls represent
// the symmetry, the floor is rough.
namespace column_collapse {

using Physics = scree::Granular<>;

template <int Dim, class Real = double>
struct Formulation : scree::Formulation<Dim, Real> {
  using physics = Physics;
};

struct Column {
  double aspect = 2;        ///< a = H0/L0
  double width = 0.05;      ///< L0: half the width, or the radius, m
  double spacing = 0.0025;  ///< of particles, m
  double reach = 5;         ///< of the floor, in L0
  double gravity = 9.81;    ///< m/s^2
  double height() const { return aspect * width; }
  double fall_time() const { return std::sqrt(height() / gravity); }  ///< sqrt(H0/g), s
};

/// mu for a measured friction k_mu of plane shear (the tangent of an angle).
inline double mu_for(double k) { return 3 * k / std::sqrt(9 - 12 * k * k); }

/// Beads as in Zhu et al. (2024), Table 1, with a stiffness that lets the foot of the column compress by one percent:
/// the wave speed is 12 sqrt(g H0). `friction_at_rest` is k_mu.
inline scree::MuOfI<> beads(Column const& column, double mu_s, double mu_d) {
  double const nu = 0.3, rho = 1500, c = 12 * std::sqrt(column.gravity * column.height());
  double const young = rho * c * c * (1 + nu) * (1 - 2 * nu) / (1 - nu);
  return {.elastic = {young, nu, rho}, .grains = {0.5e-3}, .mu_s = mu_s, .mu_d = mu_d};
}

template <int Dim>
std::vector<scree::Vec<Dim, double>> grains(Column const& column) {
  scree::Box<Dim> corner{scree::Vec<Dim, double>::Zero(), scree::Vec<Dim, double>::Constant(column.width)};
  corner.high[Dim - 1] = column.height();
  if constexpr (Dim == 2) {
    return scree::fill(corner, column.spacing);
  } else {
    scree::Cylinder const cylinder{2, scree::Vec<3, double>::Zero(), column.width, 0, column.height()};
    return scree::points_within(scree::fill(corner, column.spacing), cylinder);
  }
}

/// Floor and planes of symmetry, three rows each; the planes rise above the column, the floor extends beyond the
/// run-out.
template <int Dim>
std::vector<scree::Vec<Dim, double>> walls(Column const& column) {
  double const dr = column.spacing, thick = 3 * dr, far = column.reach * column.width;
  auto const all = scree::Vec<Dim, double>::Constant(1);
  scree::Box<Dim> floor{-thick * all, far * all};
  floor.high[Dim - 1] = 0;
  auto points = scree::fill(floor, dr);
  for (int axis = 0; axis < Dim - 1; ++axis) {
    scree::Box<Dim> plane{-thick * all, far * all};
    plane.low[Dim - 1] = 0;
    plane.high[Dim - 1] = column.height() + 6 * dr;
    plane.high[axis] = 0;
    if (axis == 1) plane.low[0] = 0;  // the corner belongs to the first plane
    auto const more = scree::fill(plane, dr);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

/// Planes of symmetry are slip walls, the floor is not.
template <int Dim, class X>
X slip_normal_at(X const& x) {
  X n = X::Zero();
  if (x[Dim - 1] < 0) return n;
  for (int axis = 0; axis < Dim - 1; ++axis)
    if (x[axis] < 0) n[axis] = 1;
  return n.squaredNorm() > 0 ? X(n.normalized()) : n;
}

template <class P>
scree::Solver<P> at_rest(Column const& column, typename P::physics const& physics) {
  using real = typename P::real;
  using vector = scree::Vec<P::dim, real>;
  auto const wall = scree::cast<real>(walls<P::dim>(column));
  scree::Solver<P> solver({.spacing = column.spacing, .physics = physics}, scree::cast<real>(grains<P::dim>(column)),
                          wall);
  scree::Geostatic const bed{column.height(), physics.law.density(), column.gravity, 1};
  solver.set(scree::stress,
             [&](vector const& x) { return scree::packed<P::dim>(scree::Mat<3, real>(bed(x).template cast<real>())); });
  solver.template set<scree::Wall>(scree::slip_normal, wall, [](vector const& x) { return slip_normal_at<P::dim>(x); });
  return solver;
}

}  // namespace column_collapse
