// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "lattice.hpp"
#include "volume.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

// Fillings with an exact volume: particles of fill_lattice(), each of which represents the same part of the volume of
// the shape.
namespace scree {

/// The particles of a filling and their volumes, for `solver.set(fields::volume, bed.volumes, [](double v) { return v;
/// })`.
template <int Dim>
struct MeasuredFill {
  std::vector<Vec<Dim, double>> points;  ///< m
  std::vector<double> volumes;           ///< m^Dim, all equal; together the volume of the shape
  double level = 0;                      ///< level of the surface, m
};

namespace detail {
template <Shape S>
MeasuredFill<S::dim> fill_below(S const& shape, VolumeBelow<S> const& volume_below, double level, double spacing,
                                std::optional<Vec<S::dim, double>> const& from) {
  static constexpr int dim = S::dim;
  check_setting(!std::isnan(level), "the level (m) of a filling", level, "a number");
  HalfSpace<dim> const below{.point = level * Vec<dim, double>::Unit(dim - 1),
                             .normal = Vec<dim, double>::Unit(dim - 1)};
  MeasuredFill<dim> result{.points = {}, .volumes = {}, .level = level};
  Vec<dim, double> const anchor = from.value_or(shape.bounds().low);
  result.points = level < shape.bounds().high[dim - 1] ? fill_lattice(shape & below, spacing, anchor)
                                                       : fill_lattice(shape, spacing, anchor);
  double const there = volume_below(level), by_number = double(result.points.size()) * math::power<dim>(spacing);
  if (!(by_number > 0.75 * there && by_number < 1.25 * there))
    throw std::invalid_argument(formatted(
        "set-up: %zu particles of %g m represent %.4g times the volume of the shape, %g m^%d: it is too small or too "
        "thin for this spacing; is it from a file, with the wrong scale?",
        result.points.size(), spacing, by_number / there, there, dim));
  result.volumes.assign(result.points.size(), there / double(result.points.size()));
  return result;
}
}  // namespace detail

/// Returns particles that fill a shape up to a level (m) of the last coordinate. `anchor` (m) is a corner of a cube of
/// the lattice, as in fill_lattice(), for example that of the walls; by default, the low corner of the bounds of the
/// shape. Throws std::invalid_argument as fill_lattice() does, if the level is not a number, and if the particles,
/// before the correction of their volumes, represent less than 3/4 or more than 5/4 of the volume of the shape below
/// the level.
template <Shape S>
MeasuredFill<S::dim> fill_up_to(S const& shape, double level, double spacing,
                                std::optional<Vec<S::dim, double>> const& anchor = {}) {
  return detail::fill_below(shape, VolumeBelow<S>(shape, spacing), level, spacing, anchor);
}
/// Returns particles that fill a shape up to a level (m), given its VolumeBelow, which takes long to compute for some
/// shapes.
template <Shape S>
MeasuredFill<S::dim> fill_up_to(S const& shape, VolumeBelow<S> const& volume_below, double level, double spacing,
                                std::optional<Vec<S::dim, double>> const& anchor = {}) {
  return detail::fill_below(shape, volume_below, level, spacing, anchor);
}
/// Returns particles that fill a whole shape, up to its top. Throws as fill_up_to() does.
template <Shape S>
MeasuredFill<S::dim> fill_measured(S const& shape, double spacing,
                                   std::optional<Vec<S::dim, double>> const& anchor = {}) {
  return fill_up_to(shape, shape.bounds().high[S::dim - 1], spacing, anchor);
}
/// Returns particles that fill a shape up to the level at which a material of the given density (kg/m^3) has the given
/// mass (kg, in the plane kg/m). Throws std::invalid_argument as fill_up_to() does, if the mass or the density is not
/// above 0, and if the shape has no space for this mass.
template <Shape S>
MeasuredFill<S::dim> fill_with_mass(S const& shape, double filled_mass, double bulk_density, double spacing,
                                    std::optional<Vec<S::dim, double>> const& anchor = {}) {
  check_setting(filled_mass > 0 && std::isfinite(filled_mass), "mass of a filling (kg)", filled_mass, "above 0");
  check_setting(bulk_density > 0 && std::isfinite(bulk_density), "density of a filling (kg/m^3)", bulk_density,
                "above 0");
  VolumeBelow<S> const below(shape, spacing);
  double const wanted = filled_mass / bulk_density, room = below.total();
  if (!(wanted <= room * (1 + 1e-12)))
    throw std::invalid_argument(detail::formatted("set-up: %g kg need a volume of %g m^%d, and the shape has %g: %g kg",
                                                  filled_mass, wanted, S::dim, room, room * bulk_density));
  auto result = detail::fill_below(shape, below, below.level_of(wanted), spacing, anchor);
  for (double& each : result.volumes) each = wanted / double(result.volumes.size());
  return result;
}

}  // namespace scree
