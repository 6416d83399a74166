// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/core/types.hpp>

// The flow in the layer of a bounded heap that is filled, after Fan et al. (2014). Derivation:
// docs/theory/verification.md.
namespace scree::test::filled_heap {

/// Lengths in the depth of the layer, times in delta L/(2 q) with the volume q that is fed per time and width. x is the
/// way from the feed over the length L, z the height over the surface over the depth delta; particles are at x times
/// `aspect`.
struct Heap {
  double lambda = 0.5;  ///< S L/delta^2
  double peclet = 20;   ///< 2 q delta/(D L)
  double aspect = 4;    ///< L/delta
  double k = 2.3;       ///< of u in proportion to (1 - x) exp(k z)

  SCREE_FN double a() const { return 0.5 / (1 - Kokkos::exp(-k)); }
  SCREE_FN double u(double x, double z) const { return a() * k * (1 - (x > 0 ? x : 0)) * Kokkos::exp(k * z); }
  SCREE_FN double w(double x, double z) const { return x > 0 ? a() * (Kokkos::exp(k * z) - 1) : 0; }
  /// S times the shear rate, in these units.
  SCREE_FN double speed(double x, double z) const {
    return x > 0 ? lambda * a() * sq(k) * (1 - x) * Kokkos::exp(k * z) : 0;
  }
  SCREE_FN double diffusivity(double x) const { return x > 0 ? 1 / peclet : 0; }
};

/// The velocity of Heap, and upstream of the feed that of the feed, without vertical motion.
struct Filling {
  Heap heap;
  SCREE_FN Vec<2, double> displaced(Vec<2, double> const& p, double from, double to) const {
    double const k = heap.k, A = heap.aspect;
    double x = p[0] / A, t = to - from;
    if (x < 0) {
      double const u = heap.u(0, p[1]);
      if (x + u * t < 0) return {A * (x + u * t), p[1]};
      t += x / u, x = 0;
    }
    // exp(-k z) - 1 grows as exp(a k t), and d ln(1 - x)/dt = -a k exp(k z).
    double const before = Kokkos::exp(-k * p[1]) - 1, after = before * Kokkos::exp(heap.a() * k * t);
    double const left = (1 - x) * Kokkos::exp(-heap.a() * k * t) * (1 + after) / (1 + before);
    return {A * (1 - left), -Kokkos::log(1 + after) / k};
  }
  SCREE_FN Vec<2, double> velocity(Vec<2, double> const& p, double) const {
    double const x = p[0] / heap.aspect;
    return {heap.aspect * heap.u(x, p[1]), heap.w(x, p[1])};
  }
  SCREE_FN Vec<2, double> acceleration(Vec<2, double> const& p, double) const {
    double const x = p[0] / heap.aspect, k = heap.k, up = Kokkos::exp(k * p[1]);
    if (x <= 0) return {0, 0};
    return {-heap.aspect * (1 - x) * sq(heap.a() * k) * up, sq(heap.a()) * k * up * (up - 1)};
  }
  SCREE_FN Mat<2, double> velocity_gradient(Vec<2, double> const& p, double) const {
    double const x = p[0] / heap.aspect, k = heap.k, rate = heap.a() * k * Kokkos::exp(k * p[1]);
    Mat<2, double> L;
    L(0, 0) = x > 0 ? -rate : 0, L(0, 1) = heap.aspect * k * heap.u(x, p[1]);
    L(1, 0) = 0, L(1, 1) = x > 0 ? rate : 0;
    return L;
  }
  double time_step() const { return 0.02; }
};

}  // namespace scree::test::filled_heap
