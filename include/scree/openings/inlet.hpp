// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../checks/start.hpp"
#include "../core/setting.hpp"
#include "../core/types.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace scree {

/// An inlet at which particles enter in layers, each layer one spacing behind the previous one, all with the same
/// velocity.
///
/// If the inlet pushes, the particles within one support upstream of the domain are held, that is, they keep their
/// velocity. Whenever the column has advanced by one spacing, a layer is created behind it and the foremost held layer
/// is released (after Lastiwka, Basa & Quinlan 2009, without extrapolation from the domain). If the inlet does not
/// push, layers are released where they are created, for instance as grains that fall into the domain.
template <int Dim>
struct Inlet {
  std::string name = "inlet";  ///< name in the ledger and in messages
  /// One layer of points (m) perpendicular to the velocity. If the inlet pushes, this is the layer next to the material
  /// at the start. The column extends behind this layer by one support, and so must the walls that guide the column.
  std::vector<Vec<Dim, double>> layer;
  Vec<Dim, double> velocity = Vec<Dim, double>::Zero();  ///< m/s
  bool pushes = true;
  /// The volume that enters per time (m^dim/s). The default, which is also the maximum, is the rate of full layers.
  /// Only for an inlet that does not push, and not for particles of a given volume.
  double rate = std::numeric_limits<double>::infinity();
  /// The duration of the inlet (s). Only for an inlet that does not push.
  double duration = std::numeric_limits<double>::infinity();
};

/// The column of particles behind an inlet. Layer k = 0, 1, ... is at `layer - k spacing + velocity time`. Everything
/// is computed from the time since the inlet was opened, so that rounding errors do not accumulate.
template <int Dim>
class InletColumn {
 public:
  using X = Vec<Dim, double>;

  /// Creates the column of an inlet for particles with a spacing (m) and a kernel with a support (m). Throws
  /// std::invalid_argument for settings that are out of range and for a layer that is not perpendicular to the
  /// velocity.
  InletColumn(Inlet<Dim> const& inlet, double spacing, double support) : inlet_(inlet), spacing_(spacing) {
    double const infinity = std::numeric_limits<double>::infinity(), speed = inlet.velocity.norm();
    require(!inlet.layer.empty(), "number of points of the layer", 0, "above 0");
    require(speed > 0 && std::isfinite(speed), "speed (m/s)", speed, "above 0");
    direction_ = inlet.velocity / speed;
    period_ = spacing / speed;
    layers_held_ = inlet.pushes ? long(std::ceil(support / spacing * (1 - 1e-12))) : 0;
    double low = infinity, high = -infinity;
    for (X const& x : inlet.layer) low = std::min(low, x.dot(direction_)), high = std::max(high, x.dot(direction_));
    require(high - low <= 0.5 * spacing, "extent of the layer along the velocity (m)", high - low,
            "at most half a spacing");
    middle_ = (low + high) / 2;
    long const count = long(inlet.layer.size());
    stride_ = count * 5 / 13 + 1;
    while (std::gcd(stride_, count) > 1) ++stride_;
    require(inlet.rate > 0, "rate (m^dim/s)", inlet.rate, "above 0");
    require(inlet.duration > 0, "duration (s)", inlet.duration, "above 0");
    if (std::isfinite(inlet.duration))
      require(!inlet.pushes, "duration (s)", inlet.duration,
              "left out, because the column of an inlet that pushes has no end");
    if (std::isinf(inlet.rate)) return;
    require(!inlet.pushes, "rate (m^dim/s)", inlet.rate, "left out, because the inlet pushes full layers");
    double const full = double(inlet.layer.size()) * std::pow(spacing, Dim) / period_;
    require(inlet.rate <= full * (1 + 1e-12), "rate (m^dim/s)", inlet.rate,
            ("at most that of full layers, " + detail::short_text(full)).c_str());
    share_ = std::min(1.0, inlet.rate / full);
  }

  /// Returns the time from one layer to the next (s).
  double period() const { return period_; }
  /// Returns the unit vector along the velocity.
  X const& direction() const { return direction_; }
  /// Returns the number of layers that have been created at a time (s) after the opening.
  long layers_at(double since) const {
    if (since < inlet_.duration) return std::max(layers_held_, 1L) + advanced(since);
    return std::max(1L, long(std::ceil(inlet_.duration / period_ * (1 - 1e-12))));
  }
  /// Returns the number of particles in the first `layers` layers.
  long particles_in(long layers) const { return whole(double(layers) * double(inlet_.layer.size()) * share_); }
  /// Returns the points (m) of a layer at a time (s) after the opening.
  std::vector<X> points(long layer, double since) const {
    X const shift = (inlet_.velocity.norm() * since - double(layer) * spacing_) * direction_;
    long const count = long(inlet_.layer.size());
    std::vector<X> points;
    for (long k = 0; k < count; ++k) {
      // Each layer begins at a different point, so that a low rate does not always leave out the same points.
      long const turn = (k + layer % count * stride_) % count;
      long const slot = layer * count + k;
      if (whole(double(slot + 1) * share_) > whole(double(slot) * share_))
        points.push_back(inlet_.layer[std::size_t(turn)] + shift);
    }
    return points;
  }
  /// Returns the coordinate (m) along the direction beyond which particles are no longer held.
  double held_up_to(double since) const {
    return middle_ + inlet_.velocity.norm() * since - double(advanced(since)) * spacing_ + spacing_ / 2;
  }

 private:
  void require(bool good, char const* what, double value, char const* allowed) const {
    if (!good) check_setting(false, (std::string(what) + " of inlet '" + inlet_.name + "'").c_str(), value, allowed);
  }
  /// Returns the number of whole particles, with a tolerance for rounding errors.
  static long whole(double particles) { return long(std::floor(particles * (1 + 1e-12))); }
  /// Returns the number of spacings by which the column has advanced.
  long advanced(double since) const {
    return long(std::floor(std::min(since, inlet_.duration) / period_ * (1 + 1e-12)));
  }

  Inlet<Dim> inlet_;
  double spacing_, period_ = 0, middle_ = 0, share_ = 1;
  X direction_;
  long layers_held_ = 0;
  long stride_ = 1;  // shift of the first point from layer to layer; coprime with the number of points
};

namespace detail {

/// Throws std::invalid_argument if the particles of an inlet would fill a volume that differs from their own. This is
/// the test of check_packing() for one layer in an endless column of layers. Layers of isolated points, 3 spacings or
/// more apart, are allowed.
template <int Dim>
[[gnu::cold]] void check_layer(Inlet<Dim> const& inlet, double spacing) {
  double const speed = inlet.velocity.norm();
  if (inlet.layer.empty() || !(speed > 0 && std::isfinite(speed))) return;  // InletColumn rejects it
  PlacedParticles layer, column;
  layer.add(inlet.layer, std::pow(spacing, Dim));
  for (int const behind : {0, 1, -1, 2, -2, 3, -3}) {  // packing_of() includes particles within 3 spacings
    auto points = inlet.layer;
    for (auto& x : points) x += behind * spacing / speed * inlet.velocity;
    column.add(points, std::pow(spacing, Dim));
  }
  Packing packing = packing_of(column, inlet.layer.size(), spacing, Dim, {});
  packing.nearest = packing_of(layer, inlet.layer.size(), spacing, Dim, {}).nearest;
  if (packing.full == 0 && packing.nearest >= 3) return;
  if (packing.may_start()) return;
  throw std::invalid_argument(formatted(
      "scree: the points of the layer of inlet '%s' must be settings.spacing, %.6g m, apart: its particles fill %.4g "
      "times the space between them (from 0.95 to 1.05 is allowed), and the nearest one is %.4g spacings away (from "
      "0.7 "
      "to 1.2; medians); for fewer particles set `rate`; if this is meant, set `start_checks = false`",
      inlet.name.c_str(), spacing, packing.density, packing.nearest));
}

/// Throws std::invalid_argument if an inlet is faster than `most` (m/s).
template <int Dim>
[[gnu::cold]] void check_speed(Inlet<Dim> const& inlet, double most) {
  double const speed = inlet.velocity.norm();
  check_setting(
      !(speed > most), ("speed (m/s) of inlet '" + inlet.name + "'").c_str(), speed,
      formatted("at most %.6g, half the speed of sound times `largest_mach`; a stiffer law has faster waves; if "
                "this is meant, set `start_checks = false`",
                most)
          .c_str());
}

/// Whether an inlet does not push and releases full layers, that is, its points are neighbours and nearly all of them
/// are used.
template <int Dim>
bool rains_in_full(Inlet<Dim> const& inlet, double spacing) {
  double const full = double(inlet.layer.size()) * inlet.velocity.norm() / spacing;  // particles per second
  bool const dense = std::count_if(inlet.layer.begin(), inlet.layer.end(), [&](auto const& point) {
                       return (point - inlet.layer.front()).norm() < 1.4 * spacing;
                     }) > 1;
  return dense && !inlet.pushes && inlet.rate > 0.9 * full * std::pow(spacing, Dim);
}
/// Whether a point (m) is within 1.4 spacings of the layer of an inlet.
template <int Dim>
bool is_beside(Inlet<Dim> const& inlet, Vec<Dim, double> const& x, double spacing) {
  return std::any_of(inlet.layer.begin(), inlet.layer.end(),
                     [&](auto const& point) { return (point - x).squaredNorm() < sq(1.4 * spacing); });
}
[[gnu::cold]] inline std::string warning_of_block(std::string const& inlet, double speed, double most) {
  return formatted(
      "scree: warning: inlet '%s' rains full layers beside rough walls, which stop them as a block: at more than %.4g "
      "m/s (a tenth of the speed of sound) the bed may stay too dense, and it rains at %.4g m/s; end the inlet a "
      "spacing before the walls, lower its speed or its `rate`, or take a stiffer law",
      inlet.c_str(), most, speed);
}

}  // namespace detail

}  // namespace scree
