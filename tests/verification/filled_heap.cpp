// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "filled_heap.hpp"

#include <scree/segregation/conservative.hpp>

#include <catch2/catch_test_macros.hpp>

#include <utility>
#include <vector>

// Two sizes in the layer that flows down a bounded heap while it is filled, with the velocity of Fan et al. (2014),
// against finite volumes. Derivation and figures: docs/theory/verification.md.
namespace scree::test::filled_heap_tests {
using namespace fields;
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

/// Finite volumes of equal shares of small and large grains.
filled_heap::Volumes<2> volumes(Heap const& heap, int nx, int nz) {
  Mat<2, double> ratios = zero<Mat<2, double>>();
  ratios(0, 1) = 1, ratios(1, 0) = -1;
  return {heap, {0.5, 0.5}, ratios, nx, nz};
}
/// The comparison of the small grains.
struct Compared {
  double error, reference, spread;
};
Compared fill(Heap const& heap, int rows, double time, filled_heap::Volumes<2> const& fine,
              filled_heap::Volumes<2> const& coarse) {
  auto const found = filled_heap::fill(
      heap, ConservativeSegregation<Sheared>{.closure = {heap}}, rows, time, fine, coarse,
      [](auto& solver) { set_field(solver, concentration, [](auto const&) { return 0.5; }); },
      [](auto const& solver) {
        std::vector<Vec<2, double>> mixtures;
        for (double const C : concentrations_of(solver)) mixtures.emplace_back(C, 1 - C);
        return mixtures;
      });
  return {found.error[0], found.reference, found.spread[0]};
}

}  // namespace

TEST_CASE("two sizes in the layer on a heap that is filled are sorted as finite volumes say") {
  Heap const heap;
  double const time = 2;  // then the layer is steady up to x = 0.5
  auto finer = volumes(heap, 120, 60), coarser = volumes(heap, 60, 30);
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
    auto finer = volumes(heap, 160, 80), coarser = volumes(heap, 80, 40);
    finer.run(2), coarser.run(2);
    CHECK(fill(heap, 20, 2, finer, coarser).error < 0.02);
  }
}

}  // namespace scree::test::filled_heap_tests
