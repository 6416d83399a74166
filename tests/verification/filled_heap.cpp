// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "filled_heap.hpp"

#include <scree/openings/regions.hpp>
#include <scree/segregation/conservative.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// Two sizes in the layer that flows down a bounded heap while it is filled, with the velocity of Fan et al. (2014),
// against finite volumes. Derivation and figures: docs/theory/verification.md.
namespace scree::test::filled_heap_tests {
using namespace fields;
using filled_heap::Filling;
using filled_heap::Heap;
namespace {

struct Sheared {
  Heap heap;
  using reads = Fields<Position>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    double const x = i[position][0] / heap.aspect, z = i[position][1];
    out[segregation_velocity] = heap.speed(x, z);
    out[diffusivity] = heap.diffusivity(x);
  }
};

/// The concentration in the heap by finite volumes over 0 < x < 1, -1 < z < 0: fluxes of Lax and Friedrichs between
/// values that are linear in each cell (minmod), steps of Heun. The grains that are fed are mixed; below, only the flow
/// carries grains along.
class Volumes {
 public:
  Volumes(Heap const& heap, int nx, int nz) : heap_(heap), nx_(nx), nz_(nz), C_(std::size_t(nx * nz), 0.5) {}
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
  double at(double x, double z) const {
    double const i = std::clamp(x * nx_ - 0.5, 0.0, nx_ - 1.0), j = std::clamp((z + 1) * nz_ - 0.5, 0.0, nz_ - 1.0);
    int const i0 = std::min(int(i), nx_ - 2), j0 = std::min(int(j), nz_ - 2);
    double const p = i - i0, q = j - j0;
    return (1 - p) * ((1 - q) * C(i0, j0) + q * C(i0, j0 + 1)) + p * ((1 - q) * C(i0 + 1, j0) + q * C(i0 + 1, j0 + 1));
  }

 private:
  double C(int i, int j) const { return C_[std::size_t(i * nz_ + j)]; }
  static double minmod(double a, double b) { return a * b <= 0 ? 0 : std::abs(a) < std::abs(b) ? a : b; }
  std::vector<double> rates() const {
    double const dx = 1.0 / nx_, dz = 1.0 / nz_;
    std::vector<double> found(C_.size());
    auto const add = [&](int i, int j, double in) { found[std::size_t(i * nz_ + j)] += in; };
    for (int j = 0; j < nz_; ++j) {
      double const z = (j + 0.5) * dz - 1;
      for (int i = 0; i <= nx_; ++i) {  // the left face of cell i
        double flux = heap_.u(i * dx, z);
        if (i == 0) {
          flux *= 0.5;
        } else if (i < nx_) {
          double const slope = i == 1 ? 0 : minmod(C(i - 1, j) - C(i - 2, j), C(i, j) - C(i - 1, j));
          flux = flux * (C(i - 1, j) + slope / 2) - (C(i, j) - C(i - 1, j)) / (heap_.peclet * dx * sq(heap_.aspect));
        } else {
          flux = 0;
        }
        if (i > 0) add(i - 1, j, -flux / dx);
        if (i < nx_) add(i, j, flux / dx);
      }
    }
    for (int i = 0; i < nx_; ++i) {
      double const x = (i + 0.5) * dx;
      auto const slope = [&](int j) {
        return j == 0 || j == nz_ - 1 ? 0 : minmod(C(i, j) - C(i, j - 1), C(i, j + 1) - C(i, j));
      };
      add(i, 0, heap_.w(x, -1) * C(i, 0) / dz);  // downwards out of the lowest cell
      for (int j = 1; j < nz_; ++j) {            // the lower face of cell j, upwards
        double const z = j * dz - 1, w = heap_.w(x, z), V = heap_.speed(x, z);
        double const below = C(i, j - 1) + slope(j - 1) / 2, above = C(i, j) - slope(j) / 2;
        auto const f = [&](double c) { return w * c - V * c * (1 - c); };
        double const flux = (f(below) + f(above) - (std::abs(w) + V) * (above - below)) / 2 -
                            (C(i, j) - C(i, j - 1)) / (heap_.peclet * dz);
        add(i, j - 1, -flux / dz), add(i, j, flux / dz);
      }
    }
    return found;
  }

  Heap heap_;
  int nx_, nz_;
  double time_ = 0;
  std::vector<double> C_;
};

/// The comparison with finite volumes, where particles are compressed by at most a factor of two.
struct Compared {
  double error = 0;      ///< mean of |C - that of finite volumes| over particles with 0.05 < x < 0.5
  double reference = 0;  ///< the same of finite volumes and those with half as many cells
  double spread = 0;     ///< of C there
  int particles = 0;
};
Compared fill(Heap const& heap, int rows, double time, Volumes const& fine, Volumes const& coarse) {
  using P = Formulated<Policy<2, double, Kokkos::DefaultExecutionSpace>, ConservativeSegregation<Sheared>, Filling>;
  double const dr = 1.0 / rows, far = heap.aspect * (heap.u(0, 0) * time + 0.3);
  // Particles that are at x > 0 or come there in the time.
  std::vector<Vec<2, double>> points;
  for (auto const& x : fill_lattice(Box<2>{{-far, -1}, {0.6 * heap.aspect, 0}}, dr))
    if (x[0] > -heap.aspect * (heap.u(0, x[1]) * time + 0.3)) points.push_back(x);
  // Nothing rearranges particles that a given motion presses together and draws apart: supports are wide enough for a
  // factor of two.
  Solver<P> solver({.spacing = dr, .smoothing = 2.5, .physics = {.closure = {heap}}, .motion = {heap}}, points);
  set_field(solver, concentration, [](auto const&) { return 0.5; });
  solver.drain({.name = "deposit", .reach = dr / 10}, Beyond<2>{{0, -1}, {0, -1}});
  solver.drain({.name = "end"}, Beyond<2>{{0.6 * heap.aspect, 0}, {1, 0}});  // where particles come together
  solver.run(time);
  auto const x = solver.material().to_host(position);
  auto const C = concentrations_of(solver);
  Compared found;
  double least = 1, most = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const along = x[i][0] / heap.aspect;
    if (along < 0.05 || along > 0.5) continue;
    double const expected = fine.at(along, x[i][1]);
    found.error += std::abs(C[i] - expected), found.reference += std::abs(coarse.at(along, x[i][1]) - expected);
    least = std::min(least, C[i]), most = std::max(most, C[i]), ++found.particles;
  }
  found.error /= found.particles, found.reference /= found.particles, found.spread = most - least;
  UNSCOPED_INFO("Lambda " << heap.lambda << ", Pe " << heap.peclet << ", " << rows << " rows: error " << found.error
                          << ", finite volumes " << found.reference << ", spread " << found.spread << " of "
                          << found.particles << " particles");
  return found;
}

}  // namespace

TEST_CASE("two sizes in the layer on a heap that is filled are sorted as finite volumes say") {
  Heap const heap;
  double const time = 2;  // then the layer is steady up to x = 0.5
  Volumes finer(heap, 120, 60), coarser(heap, 60, 30);
  finer.run(time), coarser.run(time);
  auto const coarse = fill(heap, 10, time, finer, coarser), fine = fill(heap, 20, time, finer, coarser);
  CHECK(fine.reference < 4e-3);
  CHECK(fine.spread > 0.5);
  CHECK(fine.error < 0.01);
  CHECK(fine.error < 0.6 * coarse.error);
}
TEST_CASE("two sizes on a heap that is filled in several regimes are sorted as finite volumes say", "[.long]") {
  for (auto const& [lambda, peclet] : {std::pair{0.2, 10.0}, {0.4, 40.0}, {0.78, 20.0}, {1.0, 40.0}}) {
    Heap const heap{.lambda = lambda, .peclet = peclet};
    Volumes finer(heap, 160, 80), coarser(heap, 80, 40);
    finer.run(2), coarser.run(2);
    CHECK(fill(heap, 20, 2, finer, coarser).error < 0.02);
  }
}

}  // namespace scree::test::filled_heap_tests
