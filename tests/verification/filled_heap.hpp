// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/openings/regions.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// The flow in the layer of a bounded heap that is filled, after Fan et al. (2014), finite volumes in it, and the
// comparison of particles with them. Derivation: docs/theory/verification.md.
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

/// The concentrations in the heap by finite volumes over 0 < x < 1, -1 < z < 0: fluxes of Lax and Friedrichs between
/// values that are linear in each cell (minmod), steps of Heun. A mixture is fed; below, only the flow carries grains
/// along.
template <int N>
class Volumes {
 public:
  using Mixture = Vec<N, double>;
  /// `ratios` times Heap::speed() is S_kl.
  Volumes(Heap const& heap, Mixture const& fed, Mat<N, double> const& ratios, int nx, int nz)
      : heap_(heap), fed_(fed), ratios_(ratios), nx_(nx), nz_(nz), C_(std::size_t(nx * nz), fed) {}
  void run(double until) {
    double const dx = 1.0 / nx_, dz = 1.0 / nz_;
    double const dt = std::min({0.3 * dx / heap_.u(0, 0), 0.3 * dz / (heap_.speed(1e-9, 0) + 0.5),
                                0.2 * heap_.peclet * std::min(dz * dz, sq(heap_.aspect * dx))});
    while (time_ < until * (1 - 1e-12)) {
      double const step = std::min(dt, until - time_);
      auto const start = C_;
      auto const first = rates();
      for (std::size_t i = 0; i < C_.size(); ++i) C_[i] += step * first[i];
      auto const second = rates();
      for (std::size_t i = 0; i < C_.size(); ++i) C_[i] = start[i] + step / 2 * (first[i] + second[i]);
      time_ += step;
    }
  }
  /// Linear between the middles of cells.
  Mixture at(double x, double z) const {
    double const i = std::clamp(x * nx_ - 0.5, 0.0, nx_ - 1.0), j = std::clamp((z + 1) * nz_ - 0.5, 0.0, nz_ - 1.0);
    int const i0 = std::min(int(i), nx_ - 2), j0 = std::min(int(j), nz_ - 2);
    double const p = i - i0, q = j - j0;
    return (1 - p) * ((1 - q) * C(i0, j0) + q * C(i0, j0 + 1)) + p * ((1 - q) * C(i0 + 1, j0) + q * C(i0 + 1, j0 + 1));
  }

 private:
  Mixture C(int i, int j) const { return C_[std::size_t(i * nz_ + j)]; }
  static Mixture minmod(Mixture const& a, Mixture const& b) {
    Mixture least;
    for (int k = 0; k < N; ++k) least[k] = a[k] * b[k] <= 0 ? 0 : std::abs(a[k]) < std::abs(b[k]) ? a[k] : b[k];
    return least;
  }
  std::vector<Mixture> rates() const {
    double const dx = 1.0 / nx_, dz = 1.0 / nz_;
    std::vector<Mixture> found(C_.size(), Mixture::Zero());
    auto const add = [&](int i, int j, Mixture const& in) { found[std::size_t(i * nz_ + j)] += in; };
    for (int j = 0; j < nz_; ++j) {
      double const z = (j + 0.5) * dz - 1;
      for (int i = 0; i < nx_; ++i) {  // the left face of cell i; nothing goes through x = 1
        Mixture flux = heap_.u(i * dx, z) * fed_;
        if (i > 0) {
          Mixture slope = Mixture::Zero();
          if (i > 1) slope = minmod(C(i - 1, j) - C(i - 2, j), C(i, j) - C(i - 1, j));
          flux = heap_.u(i * dx, z) * (C(i - 1, j) + slope / 2) -
                 (C(i, j) - C(i - 1, j)) / (heap_.peclet * dx * sq(heap_.aspect));
          add(i - 1, j, -flux / dx);
        }
        add(i, j, flux / dx);
      }
    }
    for (int i = 0; i < nx_; ++i) {
      double const x = (i + 0.5) * dx;
      auto const slope = [&](int j) -> Mixture {
        if (j == 0 || j == nz_ - 1) return Mixture::Zero();
        return minmod(C(i, j) - C(i, j - 1), C(i, j + 1) - C(i, j));
      };
      add(i, 0, heap_.w(x, -1) * C(i, 0) / dz);  // downwards out of the lowest cell
      for (int j = 1; j < nz_; ++j) {            // the lower face of cell j, upwards
        double const z = j * dz - 1, w = heap_.w(x, z), V = heap_.speed(x, z);
        Mixture const below = C(i, j - 1) + slope(j - 1) / 2, above = C(i, j) - slope(j) / 2;
        auto const f = [&](Mixture const& c) -> Mixture { return w * c - V * c.cwiseProduct(ratios_ * c); };
        Mixture const flux = (f(below) + f(above) - (std::abs(w) + V) * (above - below)) / 2 -
                             (C(i, j) - C(i, j - 1)) / (heap_.peclet * dz);
        add(i, j - 1, -flux / dz), add(i, j, flux / dz);
      }
    }
    return found;
  }

  Heap heap_;
  Mixture fed_;
  Mat<N, double> ratios_;
  int nx_, nz_;
  double time_ = 0;
  std::vector<Mixture> C_;
};

/// The comparison with finite volumes, where particles are compressed by at most a factor of two.
template <int N>
struct Compared {
  using Mixture = Vec<N, double>;
  Mixture error = Mixture::Zero();   ///< mean of |C_k - that of finite volumes| over particles with 0.05 < x < 0.5
  Mixture spread = Mixture::Zero();  ///< of C_k there
  double reference = 0;              ///< the largest error of finite volumes with half as many cells
  double sum = 0;                    ///< largest |sum C_k - 1|
};
/// Runs a solver with a closure and compares it. `start` sets its concentrations, `mixtures` returns them.
template <int N, class Segregation, class Start, class Mixtures>
Compared<N> fill(Heap const& heap, Segregation const& segregation, int rows, double time, Volumes<N> const& fine,
                 Volumes<N> const& coarse, Start const& start, Mixtures const& mixtures) {
  using namespace fields;
  using Mixture = Vec<N, double>;
  using P = Formulated<Policy<2, double, Kokkos::DefaultExecutionSpace>, Segregation, Filling>;
  double const dr = 1.0 / rows, far = heap.aspect * (heap.u(0, 0) * time + 0.3);
  // Particles that are at x > 0 or come there in the time.
  std::vector<Vec<2, double>> points;
  for (auto const& x : fill_lattice(Box<2>{{-far, -1}, {0.6 * heap.aspect, 0}}, dr))
    if (x[0] > -heap.aspect * (heap.u(0, x[1]) * time + 0.3)) points.push_back(x);
  // Nothing rearranges particles that a given motion presses together and draws apart: supports are wide enough for a
  // factor of two.
  Solver<P> solver({.spacing = dr, .smoothing = 2.5, .physics = segregation, .motion = {heap}}, points);
  start(solver);
  solver.drain({.name = "deposit", .reach = dr / 10}, Beyond<2>{{0, -1}, {0, -1}});
  solver.drain({.name = "end"}, Beyond<2>{{0.6 * heap.aspect, 0}, {1, 0}});  // where particles come together
  solver.run(time);
  auto const x = solver.material().to_host(position);
  std::vector<Mixture> const C = mixtures(solver);
  Compared<N> found;
  Mixture least = Mixture::Ones(), most = Mixture::Zero(), reference = Mixture::Zero();
  int particles = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const along = x[i][0] / heap.aspect;
    if (along < 0.05 || along > 0.5) continue;
    Mixture const expected = fine.at(along, x[i][1]);
    found.error += (C[i] - expected).cwiseAbs();
    reference += (coarse.at(along, x[i][1]) - expected).cwiseAbs();
    found.sum = std::max(found.sum, std::abs(C[i].sum() - 1));
    least = least.cwiseMin(C[i]), most = most.cwiseMax(C[i]), ++particles;
  }
  found.error /= particles, found.reference = reference.maxCoeff() / particles, found.spread = most - least;
  UNSCOPED_INFO("Lambda " << heap.lambda << ", Pe " << heap.peclet << ", " << rows << " rows: errors "
                          << found.error.transpose() << ", finite volumes " << found.reference << ", spreads "
                          << found.spread.transpose() << " of " << particles << " particles, sum off 1 by "
                          << found.sum);
  return found;
}

}  // namespace scree::test::filled_heap
