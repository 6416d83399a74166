// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "moment.hpp"
#include "options.hpp"

#include <scree/segregation/schlick_closure.hpp>

#include <optional>

// The dimensionless numbers of segregation in a drum after Schlick et al. (2015), from the measured flow; and how fast
// the bed segregates. SI units; derivation: docs/theory/verification.md.
namespace drum {

/// V and D of a closure over the shear rate, at the mean concentration C0.
struct PerShearRate {
  double velocity = 0;     ///< m
  double diffusivity = 0;  ///< m^2
};
/// Empty where V and D are not in proportion to the shear rate, the flux is not C (1 - C), or there is a list of sizes.
inline std::optional<PerShearRate> per_shear_rate(Options const& o) {
  auto const& m = o.material;
  auto const& s = o.segregation;
  if (!o.species.empty() || s.flux != Flux::symmetric) return {};
  double const d = m.d_small * s.C0 + m.d_large * (1 - s.C0);
  if (s.closure == Closure::shear_rate) return PerShearRate{s.chi_V * d, s.chi_D * d * d};
  if (s.closure != Closure::schlick) return {};
  scree::SchlickClosure const by_ratio;
  return PerShearRate{by_ratio.S * m.d_small * std::log(m.d_large / m.d_small), by_ratio.A * d * d};
}

/// The flowing layer, and what follows from it. NaN where something is missing.
struct Scaling {
  double layer_depth = detail::missing();   ///< delta, m: where the velocity along the surface changes its sign
  double half_surface = detail::missing();  ///< L, m: half the length of the surface
  double epsilon = detail::missing();       ///< delta/L
  double lambda = detail::missing();  ///< segregation over advection, V L/(u delta) with V at the shear rate u/delta
  double peclet = detail::missing();  ///< advection over diffusion, u delta^2/(D L) with D at the shear rate u/delta
  double froude = detail::missing();  ///< omega^2 R/g
};
inline Scaling scaling(Options const& o, double bed_depth, double layer_depth) {
  double const R = o.geometry.radius, height = bed_depth - R, omega = angular_velocity(o);
  Scaling s{.layer_depth = layer_depth, .half_surface = std::sqrt(R * R - height * height)};
  s.epsilon = s.layer_depth / s.half_surface;
  s.froude = omega * omega * R / o.geometry.gravity;
  if (auto const rates = per_shear_rate(o)) {
    double const delta = s.layer_depth, L = s.half_surface;
    s.lambda = rates->velocity * L / (delta * delta);
    s.peclet = rates->diffusivity > 0 ? delta * delta * delta / (rates->diffusivity * L) : detail::missing();
  }
  return s;
}

/// A quantity that rises from 0 at time 0 as `last (1 - exp(-t/time))`.
struct Rise {
  double last = detail::missing();
  double time = detail::missing();   ///< s
  double error = detail::missing();  ///< root of the mean square of the deviation from the curve, over `last`
};
/// The curve with the least squares of the deviations from values at times (s); values that are NaN are left out. NaN
/// if fewer than three are left or none differs from 0.
inline Rise rise_of(std::vector<double> const& times, std::vector<double> const& values) {
  double end = 0, yy = 0;
  int count = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (std::isnan(values[k])) continue;
    end = std::max(end, times[k]), yy += values[k] * values[k], ++count;
  }
  if (count < 3 || !(end > 0) || !(yy > 0)) return {};
  // For a given time the best `last` is known; what it leaves of the squares is minimised over the logarithm of the
  // time.
  struct Left {
    double last, squares;
  };
  auto const left = [&](double log_time) {
    double gg = 0, gy = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (std::isnan(values[k])) continue;
      double const g = -std::expm1(-times[k] / std::exp(log_time));
      gg += g * g, gy += g * values[k];
    }
    return Left{gy / gg, yy - gy * gy / gg};
  };
  constexpr int scanned = 200;
  double const low = std::log(1e-4 * end), step = std::log(1e6) / scanned;
  int best = 1;
  for (int k = 1; k < scanned; ++k)
    if (left(low + k * step).squares < left(low + best * step).squares) best = k;
  double a = low + (best - 1) * step, b = low + (best + 1) * step;
  for (int k = 0; k < 60; ++k) {
    double const p = a + 0.382 * (b - a), q = a + 0.618 * (b - a);
    (left(p).squares < left(q).squares ? b : a) = left(p).squares < left(q).squares ? q : p;
  }
  auto const found = left((a + b) / 2);
  return {.last = found.last,
          .time = std::exp((a + b) / 2),
          .error = std::sqrt(std::max(0.0, found.squares) / count) / std::abs(found.last)};
}

/// How the degree of segregation rises, the root of the intensity of segregation: 0 mixed, 1 apart. The bed is mixed at
/// time 0.
inline Rise rise_of_segregation(std::vector<Moment> const& history) {
  std::vector<double> times, degrees;
  for (auto const& m : history) times.push_back(m.time), degrees.push_back(std::sqrt(m.intensity));
  return rise_of(times, degrees);
}

}  // namespace drum
