// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <concepts>
#include <numbers>
#include <stdexcept>
#include <vector>

// The equation that all reference solvers in this folder solve. All quantities are non-dimensional: lengths are in bed
// heights H, times in periods T of the box. z points upwards, and gravity downwards; C is the volume fraction of small
// grains.
//
//   dC/dt = div(V F(C) e_z + D grad C),   F = A C (1 - C)(1 - kappa C)       Zhu, Peng & Wu (2024), (2.5), (2.6)
namespace shear_box::reference {

struct SegregationFlux {
  double amplitude = 1.0;  // A
  double kappa = 0.0;      // asymmetry, 0 <= kappa <= 1

  constexpr double operator()(double C) const { return amplitude * C * (1.0 - C) * (1.0 - kappa * C); }
};

inline constexpr SegregationFlux symmetric_flux{.amplitude = 1.0, .kappa = 0.0};
inline constexpr SegregationFlux asymmetric_flux{.amplitude = 1.6, .kappa = 0.89};

inline constexpr double maximum_shear = 1.0 / std::numbers::sqrt3;  // gamma0 = tan 30 degrees

struct Coefficients {
  double velocity;     // V T / H
  double diffusivity;  // D T / H^2

  constexpr double peclet() const { return velocity / diffusivity; }
};

/// Returns the coefficients from (5.2), which makes V and D non-dimensional with a length B: [V] = V T/B = 0.03 and [D]
/// = D T/B^2 = 1.01e-3.
constexpr Coefficients coefficients_of_length(double B) {
  return {.velocity = 3.0e-2 * B, .diffusivity = 1.01e-3 * B * B};
}

/// The coefficients with (a) B = H gamma0, as defined in the paper, and (b) B = H, which gives the mixing times quoted
/// in the paper.
inline constexpr Coefficients reading_a = coefficients_of_length(maximum_shear);
inline constexpr Coefficients reading_b = coefficients_of_length(1.0);

/// Whether a class is a closure: it gives V and D at the mean shear rate, their common factor rate(t), the integral
/// clock(t) of the rate, and its inverse time(clock). With the clock as time, V and D depend only on C, so the solvers
/// use the clock for their steps. Clock and time agree at every quarter period, where the two-dimensional solver ends
/// its steps.
template <class T>
concept SegregationClosure = requires(T const& closure, double x) {
  { closure.velocity(x) } -> std::convertible_to<double>;
  { closure.diffusivity(x) } -> std::convertible_to<double>;
  { closure.rate(x) } -> std::convertible_to<double>;
  { closure.clock(x) } -> std::convertible_to<double>;
  { closure.time(x) } -> std::convertible_to<double>;
};

struct ConstantClosure {
  Coefficients mean = reading_a;

  constexpr double velocity(double /*C*/) const { return mean.velocity; }
  constexpr double diffusivity(double /*C*/) const { return mean.diffusivity; }
  constexpr double rate(double /*t*/) const { return 1.0; }
  constexpr double clock(double t) const { return t; }
  constexpr double time(double clock) const { return clock; }
};

/// The closure (5.5): V = V0 (gdot/gdot_m) d_avg/d_bar, D = D0 (gdot/gdot_m) (d_avg/d_bar)^2, d_avg = d_S C + d_L (1 -
/// C). With gamma = gamma0 sin(2 pi t) the ratio gdot/gdot_m is (pi/2) |cos(2 pi t)|, for any gamma0.
struct ShearRateClosure {
  Coefficients mean = reading_a;
  double small_diameter = 4.0;  // the unit of the three diameters is arbitrary (here mm)
  double large_diameter = 8.0;
  double reference_diameter = 6.0;  // d_bar; 4, 6 and 8 in the paper

  constexpr double diameter_ratio(double C) const {
    return (small_diameter * C + large_diameter * (1.0 - C)) / reference_diameter;
  }
  constexpr double velocity(double C) const { return mean.velocity * diameter_ratio(C); }
  constexpr double diffusivity(double C) const { return mean.diffusivity * diameter_ratio(C) * diameter_ratio(C); }

  double rate(double t) const { return 0.5 * std::numbers::pi * std::abs(std::cos(2.0 * std::numbers::pi * t)); }
  // Returns the shear accumulated by time t over the shear accumulated in one period.
  double clock(double t) const {
    double const quarter = std::floor(4.0 * t);
    double const angle = 0.5 * std::numbers::pi * (4.0 * t - quarter);
    return 0.25 * (quarter + (slows_down(quarter) ? std::sin(angle) : 1.0 - std::cos(angle)));
  }
  double time(double clock) const {
    double const quarter = std::floor(4.0 * clock);
    double const sheared = 4.0 * clock - quarter;
    double const angle = slows_down(quarter) ? std::asin(sheared) : std::acos(1.0 - sheared);
    return 0.25 * (quarter + angle / (0.5 * std::numbers::pi));
  }

 private:
  static bool slows_down(double quarter) { return std::fmod(quarter, 2.0) == 0.0; }
};

template <SegregationClosure Closure = ConstantClosure>
struct Problem {
  SegregationFlux flux = symmetric_flux;
  Closure closure{};
  double shear_amplitude = maximum_shear;  // gamma0; only the two-dimensional solver uses it
  double width = 0.4;                      // width of the box; only the two-dimensional solver uses it

  constexpr double percolation(double C) const { return closure.velocity(C) * flux(C); }  // V F at the mean shear rate
  double shear(double t) const { return shear_amplitude * std::sin(2.0 * std::numbers::pi * t); }
};

/// Returns the mean initial concentration between two heights, with large grains below 1/2 and small grains above
/// (5.1).
constexpr double initial_mean(double bottom, double top) {
  double const small_part = top <= 0.5 ? 0.0 : top - (bottom > 0.5 ? bottom : 0.5);
  return small_part / (top - bottom);
}

inline int cells_across(double length, double spacing) {
  double const cells = length / spacing;
  if (!(spacing > 0.0) || std::abs(cells - std::round(cells)) > 1e-9 * cells)
    throw std::invalid_argument("shear box reference: spacing must divide the height and the width of the box");
  return static_cast<int>(std::round(cells));
}

inline void require_increasing(std::vector<double> const& times) {
  double before = 0.0;
  for (double time : times) {
    if (!(time >= before))
      throw std::invalid_argument("shear box reference: times must be increasing and not negative");
    before = time;
  }
}

}  // namespace shear_box::reference
