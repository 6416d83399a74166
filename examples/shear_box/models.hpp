// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"

#include <scree/scree.hpp>

// Functions that convert the options of a case to models and particles of the library, in SI units.
namespace shear_box {

inline scree::SegregationFlux flux(Options const& o) {
  return {.amplitude = o.flux_amplitude(), .asymmetry = o.flux_asymmetry()};
}
inline scree::TransportStep transport_step(Options const& o) {
  return {.diffusion = o.time.cfl_diffusion, .segregation = o.time.cfl_segregation};
}
inline scree::OscillatingShear motion(Options const& o) {
  return {.amplitude = o.geometry.upright ? 0 : gamma0(o),
          .period = o.geometry.period,
          .strain_per_step = o.time.strain_per_step};
}

/// Returns the closure of type C, so that a formulation can choose the closure by type.
template <class C>
C closure(Options const& o);
template <>
inline scree::ConstantClosure closure(Options const& o) {
  auto const [V, D] = coefficients(o);
  return {.velocity = V, .diffusivity = D};
}
/// Returns the closure with chi_V, chi_D of (5.6): if d_avg = d_bar, V and D averaged over a period equal V and D of
/// (5.2).
template <>
inline scree::ShearRateClosure closure(Options const& o) {
  auto const [V, D] = coefficients(o);
  double const mean_shear_rate = 4 * gamma0(o) / o.geometry.period, d = o.model.d_bar;
  return {.chi_V = V / (mean_shear_rate * d),
          .chi_D = D / (mean_shear_rate * d * d),
          .d_small = o.geometry.d_small,
          .d_large = o.geometry.d_large};
}

/// Returns the filled part of the box at rest. The first coordinate is along the motion, the last one upwards.
template <int Dim>
scree::Box<Dim> bed(Options const& o) {
  scree::Box<Dim> box{scree::Vec<Dim, double>::Zero(), scree::Vec<Dim, double>::Zero()};
  box.high[0] = o.geometry.width;
  if (Dim == 3) box.high[1] = spacing(o) * std::round(o.geometry.depth / spacing(o));
  box.high[Dim - 1] = o.geometry.height;
  return box;
}

inline bool is_periodic(Options const& o) {
  return o.numerics.dimension == 3 && o.numerics.depth_boundary == DepthBoundary::periodic;
}
template <int Dim>
std::vector<scree::Period> periods(Options const& o) {
  if (!is_periodic(o)) return {};
  return {{.axis = 1, .low = 0, .high = bed<Dim>(o).high[1]}};
}

/// Positions of the particles: `material` fills the bed; `cells` are the lattice positions of the material before any
/// jitter.
template <int Dim>
struct Points {
  std::vector<scree::Vec<Dim, double>> cells, material, wall;
};
/// Returns the positions of material and walls. The walls have as many rows as the support needs (at least three) and
/// rise 20 rows above the bed.
template <int Dim>
Points<Dim> points(Options const& o) {
  double const dr = spacing(o), rows = std::max(3.0, std::ceil(2 * o.numerics.smoothing)) * dr;
  auto const inner = bed<Dim>(o);
  Points<Dim> points{.cells = scree::fill_lattice(inner, dr), .material = {}, .wall = {}};
  points.material = points.cells;
  scree::jitter(points.material, o.numerics.jitter * dr, static_cast<unsigned>(o.numerics.seed));

  auto open = inner, outer = inner;
  open.high[Dim - 1] += 21 * dr;
  outer.high[Dim - 1] += 20 * dr;
  outer.low.array() -= rows;
  outer.high[0] += rows;
  if (Dim == 3) {
    double const depth_rows = is_periodic(o) ? 0 : rows;
    outer.low[1] = inner.low[1] - depth_rows;
    outer.high[1] = inner.high[1] + depth_rows;
    if (is_periodic(o)) open.low[1] -= dr, open.high[1] += dr;
  }
  points.wall = scree::fill_between(open, outer, dr);
  return points;
}

/// Returns the initial concentration of small grains at height z (5.1): 0 below H/2, 1 above, and the fraction above
/// H/2 for a cell that contains H/2.
inline double layered(double z, Options const& o) {
  double const low = z - spacing(o) / 2 - o.geometry.height / 2;
  double const share = std::round(1e9 * (low / spacing(o) + 1)) / 1e9;  // exactly 0 and 1 despite rounding
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace shear_box
