// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../support/by_hand/lists.hpp"

// The motion pass written by hand for one case: velocity gradient, stress divergence, artificial viscosity and
// diffusion in one function, with everything that is the same for all pairs computed beforehand.
namespace by_hand {

/// Constants that are the same for all pairs; Wendland's C2 kernel.
template <class Real>
struct Constants {
  Real squared_radius, half_inverse_h;
  Real slope_factor;   ///< of (dW/dr)/r = slope_factor (1 - q/2)^3
  Real inverse_rho;    ///< 1/density
  Real speed_times_h;  ///< of the artificial viscosity
  Real softening;      ///< (h/10)^2
};

/// Quads of a particle in memory, and the particle in registers. Only the components of the stress in the plane: 11,
/// 22, 12; in 3D 11, 22, 33, 12, 13, 23.
template <int Dim>
inline constexpr int quads = Dim == 2 ? 3 : 4;
template <int Dim, class Real>
struct Particle {
  static constexpr int stresses = Dim == 2 ? 3 : 6;
  Real x[Dim], u[Dim], s[stresses], V, C, D;
};
/// load(k) gives the k-th quad of the particle; the first holds the position and is loaded already.
template <int Dim, class Real, class Load>
KOKKOS_INLINE_FUNCTION Particle<Dim, Real> unpack(Quad<Real> const& a, Load const& load) {
  Quad<Real> const b = load(1), c = load(2);
  if constexpr (Dim == 2) {
    return {{a.v[0], a.v[1]}, {b.v[0], b.v[1]}, {c.v[0], c.v[1], c.v[2]}, a.v[2], a.v[3], b.v[2]};
  } else {
    Quad<Real> const d = load(3);
    return {{a.v[0], a.v[1], a.v[2]},
            {b.v[0], b.v[1], b.v[2]},
            {c.v[0], c.v[1], c.v[2], d.v[0], d.v[1], d.v[2]},
            a.v[3],
            b.v[3],
            c.v[3]};
  }
}

/// Sums of one particle: the velocity gradient by rows, the acceleration, div(D grad C).
template <int Dim, class Real>
struct Sums {
  static constexpr int count = Dim * Dim + Dim + 1;
  Real v[count] = {};
};

// On a GPU in single precision the hardware instructions, accurate to about two units in the last place.
KOKKOS_INLINE_FUNCTION double root(double x) { return Kokkos::sqrt(x); }
KOKKOS_INLINE_FUNCTION double reciprocal(double x) { return 1 / x; }
#ifdef __CUDA_ARCH__
KOKKOS_INLINE_FUNCTION float root(float x) { return x * rsqrtf(x); }
KOKKOS_INLINE_FUNCTION float reciprocal(float x) { return __fdividef(1, x); }
#else
KOKKOS_INLINE_FUNCTION float root(float x) { return Kokkos::sqrt(x); }
KOKKOS_INLINE_FUNCTION float reciprocal(float x) { return 1 / x; }
#endif

template <int Dim, class Real>
KOKKOS_INLINE_FUNCTION void interact(Particle<Dim, Real> const& i, Particle<Dim, Real> const& j, Real const* x,
                                     Real squared, Constants<Real> const& is, Sums<Dim, Real>& sum) {
  Real const t = 1 - root(squared) * is.half_inverse_h, w = j.V * is.slope_factor * t * t * t;
  Real u[Dim], S[Particle<Dim, Real>::stresses], approach = 0;
  for (int a = 0; a < Dim; ++a) {
    u[a] = i.u[a] - j.u[a];
    approach += u[a] * x[a];
  }
  for (int k = 0; k < Particle<Dim, Real>::stresses; ++k) S[k] = i.s[k] + j.s[k];
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < Dim; ++b) sum.v[a * Dim + b] -= w * u[a] * x[b];

  Real const radial = w * reciprocal(squared + is.softening);
  Real const repulsion = approach < 0 ? radial * is.speed_times_h * approach : Real(0), pull = w * is.inverse_rho;
  Real* const force = sum.v + Dim * Dim;
  if constexpr (Dim == 2) {
    force[0] += pull * (S[0] * x[0] + S[2] * x[1]) + repulsion * x[0];
    force[1] += pull * (S[2] * x[0] + S[1] * x[1]) + repulsion * x[1];
  } else {
    force[0] += pull * (S[0] * x[0] + S[3] * x[1] + S[4] * x[2]) + repulsion * x[0];
    force[1] += pull * (S[3] * x[0] + S[1] * x[1] + S[5] * x[2]) + repulsion * x[1];
    force[2] += pull * (S[4] * x[0] + S[5] * x[1] + S[2] * x[2]) + repulsion * x[2];
  }
  sum.v[Dim * Dim + Dim] += radial * squared * (i.D + j.D) * (i.C - j.C);
}

/// Processes a candidate: its position first, the rest only if it is within the support. load(k) gives its k-th quad.
template <int Dim, class Real, class Load>
KOKKOS_INLINE_FUNCTION void consider(Particle<Dim, Real> const& i, Load const& load, Constants<Real> const& is,
                                     Sums<Dim, Real>& sum) {
  Quad<Real> const first = load(0);
  Real x[Dim], squared = 0;
  for (int a = 0; a < Dim; ++a) {
    x[a] = i.x[a] - first.v[a];
    squared += x[a] * x[a];
  }
  if (squared < is.squared_radius) interact(i, unpack<Dim, Real>(first, load), x, squared, is, sum);
}

}  // namespace by_hand
