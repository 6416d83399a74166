// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "filled_heap.hpp"

#include <scree/openings/regions.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// Three sizes in the layer that flows down a bounded heap while it is filled, with the velocity of Fan et al. (2014),
// against finite volumes. Derivation and figures: docs/theory/verification.md.
namespace scree::test::filled_heap_of_species_tests {
using namespace fields;
using filled_heap::Filling;
using filled_heap::Heap;
namespace {

constexpr int N = 3;
using Mixture = Vec<N, double>;
using Matrix = Mat<N, double>;

/// Diameters over that of the smallest.
Mixture const diameters = {1, 1.6, 2.4};
Mixture const fed = {0.3, 0.4, 0.3};

/// min(d_k, d_l) ln(d_l/d_k) over that of the smallest and the largest: Lambda of each pair over that of these two. It
/// is no difference of two values, as the speeds of three species with other laws are.
Matrix speeds() {
  Matrix S;
  for (int k = 0; k < N; ++k)
    for (int l = 0; l < N; ++l) S(k, l) = std::min(diameters[k], diameters[l]) * std::log(diameters[l] / diameters[k]);
  return S / S(0, N - 1);
}

/// The closure in the flow of the heap: S_kl of Heap::speed() for the smallest and the largest.
struct Sheared {
  Heap heap;
  Matrix ratios;
  static constexpr int species = N;
  using reads = Fields<Position>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    double const x = i[position][0] / heap.aspect, z = i[position][1];
    auto& S = out[segregation_velocities<N>];
    for_each_pair_of_species<N>(
        [&](auto k, auto l, auto pair) { S[pair] = heap.speed(x, z) * ratios(int(k), int(l)); });
    out[diffusivity] = heap.diffusivity(x);
  }
};

/// The concentrations in the heap by finite volumes over 0 < x < 1, -1 < z < 0: fluxes of Lax and Friedrichs between
/// values that are linear in each cell (minmod), steps of Heun. A mixture is fed; below, only the flow carries grains
/// along.
class Volumes {
 public:
  Volumes(Heap const& heap, int nx, int nz)
      : heap_(heap), ratios_(speeds()), nx_(nx), nz_(nz), C_(std::size_t(nx * nz), fed) {}
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
        Mixture flux = heap_.u(i * dx, z) * fed;
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
  Matrix ratios_;
  int nx_, nz_;
  double time_ = 0;
  std::vector<Mixture> C_;
};

/// The comparison with finite volumes, where particles are compressed by at most a factor of two.
struct Compared {
  Mixture error = Mixture::Zero();   ///< mean of |C_k - that of finite volumes| over particles with 0.05 < x < 0.5
  Mixture spread = Mixture::Zero();  ///< of C_k there
  double reference = 0;              ///< the largest error of finite volumes with half as many cells
  double sum = 0;                    ///< largest |sum C_k - 1|
};
Compared fill(Heap const& heap, int rows, double time, Volumes const& fine, Volumes const& coarse) {
  using P = Formulated<Policy<2, double, Kokkos::DefaultExecutionSpace>, SpeciesSegregation<Sheared>, Filling>;
  double const dr = 1.0 / rows, far = heap.aspect * (heap.u(0, 0) * time + 0.3);
  // Particles that are at x > 0 or come there in the time.
  std::vector<Vec<2, double>> points;
  for (auto const& x : fill_lattice(Box<2>{{-far, -1}, {0.6 * heap.aspect, 0}}, dr))
    if (x[0] > -heap.aspect * (heap.u(0, x[1]) * time + 0.3)) points.push_back(x);
  // Nothing rearranges particles that a given motion presses together and draws apart: supports are wide enough for a
  // factor of two.
  Solver<P> solver({.spacing = dr, .smoothing = 2.5, .physics = {.closure = {heap, speeds()}}, .motion = {heap}},
                   points);
  solver.set(concentrations<N>, [](auto const&) { return fed; });
  solver.drain({.name = "deposit", .reach = dr / 10}, Beyond<2>{{0, -1}, {0, -1}});
  solver.drain({.name = "end"}, Beyond<2>{{0.6 * heap.aspect, 0}, {1, 0}});  // where particles come together
  solver.run(time);
  auto const x = solver.material().to_host(position);
  auto const C = solver.material().to_host(concentrations<N>);
  Compared found;
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
  UNSCOPED_INFO(rows << " rows: errors " << found.error.transpose() << ", finite volumes " << found.reference
                     << ", spreads " << found.spread.transpose() << " of " << particles << " particles, sum off 1 by "
                     << found.sum);
  return found;
}

}  // namespace

TEST_CASE("three sizes in the layer on a heap that is filled are sorted as finite volumes say") {
  Heap const heap;
  double const time = 2;  // then the layer is steady up to x = 0.5
  Volumes finer(heap, 120, 60), coarser(heap, 60, 30);
  finer.run(time), coarser.run(time);
  auto const coarse = fill(heap, 10, time, finer, coarser), fine = fill(heap, 20, time, finer, coarser);
  CHECK(fine.reference < 4e-3);
  CHECK(fine.spread[0] > 0.4);
  CHECK(fine.spread[2] > 0.4);
  CHECK(fine.error.maxCoeff() < 0.01);
  CHECK(fine.error.maxCoeff() < 0.6 * coarse.error.maxCoeff());
  CHECK(fine.sum < 1e-13);
}

}  // namespace scree::test::filled_heap_of_species_tests
