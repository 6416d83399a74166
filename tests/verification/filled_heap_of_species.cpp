// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "filled_heap.hpp"

#include <scree/segregation/species_segregation.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// Three sizes in the layer that flows down a bounded heap while it is filled, with the velocity of Fan et al. (2014),
// against finite volumes. Derivation and figures: docs/theory/verification.md.
namespace scree::test::filled_heap_of_species_tests {
using namespace fields;
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

filled_heap::Compared<N> fill(Heap const& heap, int rows, double time, filled_heap::Volumes<N> const& fine,
                              filled_heap::Volumes<N> const& coarse) {
  return filled_heap::fill(
      heap, SpeciesSegregation<Sheared>{.closure = {heap, speeds()}}, rows, time, fine, coarse,
      [](auto& solver) { solver.set(concentrations<N>, [](auto const&) { return fed; }); },
      [](auto const& solver) { return solver.material().to_host(concentrations<N>); });
}

}  // namespace

TEST_CASE("three sizes in the layer on a heap that is filled are sorted as finite volumes say") {
  Heap const heap;
  double const time = 2;  // then the layer is steady up to x = 0.5
  filled_heap::Volumes<N> finer(heap, fed, speeds(), 120, 60), coarser(heap, fed, speeds(), 60, 30);
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
