// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/laws/elastic.hpp>
#include <scree/laws/volume_memory.hpp>
#include <scree/terms/velocity_gradient.hpp>

#include <cmath>

// One point of a material under a prescribed velocity gradient: no particles, no solver.
namespace scree::test {

/// The fields that laws read at a point, and their internal variables.
template <class Real = double>
struct Point {
  Real gamma_dot = 0, C = 0, gap = 0;
  SCREE_FN Real operator[](ShearRate) const { return gamma_dot; }
  SCREE_FN Real operator[](Concentration) const { return C; }
  SCREE_FN Real operator[](Opening) const { return gap; }
  SCREE_FN Real& operator[](Opening) { return gap; }
};

/// Advances the stress as `Granular` does with the midpoint scheme: rates of the state, half a step, admissible; rates
/// of that, a whole step, admissible. The stress is kept packed, in plane strain for Dim = 2 (x, up).
template <class Law, int Dim = 2>
struct Element {
  using Gradient = Mat<Dim, double>;
  Law law;
  Vec<symmetric3_size<Dim>, double> sigma = Vec<symmetric3_size<Dim>, double>::Zero();
  Point<> point = {};

  double p() const { return pressure_of(unpacked(sigma)); }
  double tau() const { return equivalent_shear_stress(deviator_of(unpacked(sigma))); }
  void set_pressure(double value) { sigma = packed<Dim>(Mat<3, double>(-value * Mat<3, double>::Identity())); }

  /// `gradient` is a function of the time since the call (s).
  template <class GradientAt>
  void follow(GradientAt const& gradient, double duration, int steps) {
    double const dt = duration / steps;
    for (int n = 0; n < steps; ++n) step(gradient(n * dt), gradient((n + 0.5) * dt), dt);
  }
  void shear_on(Gradient const& L, double duration, int steps) {
    follow([&](double) { return L; }, duration, steps);
  }

 private:
  void step(Gradient const& now, Gradient const& midway, double dt) {
    auto const before = sigma;
    double const gap = point.gap;
    update(before + dt / 2 * rate(now), gap);
    update(before + dt * rate(midway), gap);
  }
  Vec<symmetric3_size<Dim>, double> rate(Gradient const& L) {
    point.gamma_dot = shear_rate_of(L);
    return packed<Dim>(law.stress_rate(unpacked(sigma), in_three_dimensions(L), point));
  }
  void update(Vec<symmetric3_size<Dim>, double> const& trial, double gap) {
    point.gap = gap;
    Point<> const old = point;
    sigma = packed<Dim>(law.admissible(unpacked(trial), old, point));
  }
};

/// du_0/dx_last = rate: simple shear in the first direction.
template <int Dim = 2>
Mat<Dim, double> simple_shear(double rate) {
  Mat<Dim, double> L = Mat<Dim, double>::Zero();
  L(0, Dim - 1) = rate;
  return L;
}
/// An elastic material with a compression wave speed of 10 m/s.
inline Elastic soft() { return {.young = 111430, .poisson = 0.3, .rest_density = 1500}; }

inline double relative(double value, double expected) { return std::abs(value / expected - 1); }

}  // namespace scree::test
