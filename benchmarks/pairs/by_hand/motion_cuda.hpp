// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "motion.hpp"

// The pass in plain CUDA, with several lanes of a warp for each particle.
namespace by_hand {
#ifdef KOKKOS_ENABLE_CUDA

/// The list for groups of `lanes`: candidate k of particle i at [k/lanes][i][k%lanes], so that the reads of a warp
/// coalesce.
inline Array<int*> interleaved(PaddedList const& list, int lanes) {
  int const n = static_cast<int>(list.rows.extent(0)), room = static_cast<int>(list.rows.extent(1));
  Array<int*> const result(Kokkos::view_alloc("by_hand::interleaved", Kokkos::WithoutInitializing),
                           std::size_t(n) * std::size_t((room + lanes - 1) / lanes * lanes));
  Kokkos::parallel_for(
      "by_hand::interleave", Kokkos::RangePolicy<Space>(0, n), KOKKOS_LAMBDA(int i) {
        for (int k = 0; k < list.lengths(i); ++k)
          result((std::size_t(k / lanes) * n + i) * lanes + k % lanes) = list.rows(i, k);
      });
  return result;
}

template <int Dim, class Real>
struct RawArrays {
  int n;
  int const* lengths;
  int const* candidates;
  Quad<Real> const* particles;  // first quads of all particles, then their second ones, ...
  Real* sums;                   // likewise
};

template <int Lanes, int Dim, class Real>
__global__ void __launch_bounds__(128) motion_pass(RawArrays<Dim, Real> const at, Constants<Real> const is) {
  int const thread = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x), lane = thread % Lanes;
  int const i = min(thread / Lanes, at.n - 1);  // all threads must reach the shuffles
  auto const quad_of = [&](int j) {
    return [&at, j](int k) {
      auto const* const from = reinterpret_cast<float4 const*>(at.particles + std::size_t(k) * at.n + j);
      Quad<Real> quad;
      for (std::size_t part = 0; part < sizeof(quad) / sizeof(float4); ++part)
        reinterpret_cast<float4*>(&quad)[part] = __ldg(from + part);
      return quad;
    };
  };
  auto const load_self = quad_of(i);
  Particle<Dim, Real> const self = unpack<Dim, Real>(load_self(0), load_self);
  Sums<Dim, Real> sum;
  int const length = at.lengths[i];
  for (int k = lane; k < length; k += Lanes)
    consider(self, quad_of(__ldg(at.candidates + (std::size_t(k / Lanes) * at.n + i) * Lanes + lane)), is, sum);
  for (int k = 0; k < sum.count; ++k) {
    Real total = sum.v[k];
    for (int step = Lanes / 2; step > 0; step /= 2) total += __shfl_down_sync(0xffffffffu, total, step, Lanes);
    if (lane == 0 && thread / Lanes < at.n) at.sums[std::size_t(k) * at.n + i] = total;
  }
}

/// `candidates` is interleaved(motion.list, Lanes).
template <int Lanes, int Dim, class Real>
void run_cuda(Motion<Dim, Real> const& motion, Array<int*> const& candidates) {
  int const n = static_cast<int>(motion.particles.extent(0));
  RawArrays<Dim, Real> const arrays{n, motion.list.lengths.data(), candidates.data(), motion.particles.data(),
                                    motion.sums.data()};
  int const threads = 128, blocks = (n * Lanes + threads - 1) / threads;
  motion_pass<Lanes><<<blocks, threads, 0, Space().cuda_stream()>>>(arrays, motion.is);
}

#endif
}  // namespace by_hand
