// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "interaction.hpp"

#include <vector>

namespace by_hand {

/// Particles, list and sums of the motion pass.
template <int Dim, class Real>
struct Motion {
  using Quads = Array<Quad<Real> * [quads<Dim>]>;
  Constants<Real> is;
  Quads particles;
  PaddedList list;
  Array<Real * [Sums<Dim, Real>::count]> sums;

  Motion(Constants<Real> const& constants, std::vector<Particle<Dim, Real>> const& from, Real length, Real list_radius)
      : is(constants), particles("by_hand::particles", from.size()), sums("by_hand::sums", from.size()) {
    int const n = static_cast<int>(from.size());
    auto const packed = Kokkos::create_mirror_view(particles);
    for (int i = 0; i < n; ++i)
      pack(
          from[static_cast<std::size_t>(i)], [&](int k) -> auto& { return packed(i, k); });
    Kokkos::deep_copy(particles, packed);

    Cells<Dim, Real> const cells(n, length, list_radius);
    Array<Quad<Real>*> const x("by_hand::x", n);
    Kokkos::deep_copy(x, Kokkos::subview(particles, Kokkos::ALL, 0));
    sort(cells, x);
    list = padded_list(cells, list_radius, Dim == 2 ? 48 : 192);
  }

 private:
  template <class At>
  static void pack(Particle<Dim, Real> const& p, At const& at) {
    if constexpr (Dim == 2) {
      at(0) = {p.x[0], p.x[1], p.V, p.C};
      at(1) = {p.u[0], p.u[1], p.D, 0};
      at(2) = {p.s[0], p.s[1], p.s[2], 0};
    } else {
      at(0) = {p.x[0], p.x[1], p.x[2], p.V};
      at(1) = {p.u[0], p.u[1], p.u[2], p.C};
      at(2) = {p.s[0], p.s[1], p.s[2], p.D};
      at(3) = {p.s[3], p.s[4], p.s[5], 0};
    }
  }
};

/// The pass in plain Kokkos.
template <int Dim, class Real>
void run(Motion<Dim, Real> const& motion) {
  auto const is = motion.is;
  auto const particles = motion.particles;
  auto const list = motion.list;
  auto const sums = motion.sums;
  Kokkos::parallel_for(
      "by_hand::motion", Kokkos::RangePolicy<Space>(0, static_cast<int>(particles.extent(0))), KOKKOS_LAMBDA(int i) {
        Particle<Dim, Real> const self = unpack<Dim, Real>(particles(i, 0), [&](int k) { return particles(i, k); });
        Sums<Dim, Real> sum;
        int const length = list.lengths(i);
        for (int k = 0; k < length; ++k) {
          int const j = list.rows(i, k);
          consider(
              self, [&](int quad) { return particles(j, quad); }, is, sum);
        }
        for (int k = 0; k < sum.count; ++k) sums(i, k) = sum.v[k];
      });
}

}  // namespace by_hand
