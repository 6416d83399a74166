// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/core/basis.hpp>
#include <scree/kernels/wendland_c2.hpp>

#include <fmt/core.h>

#include <string>
#include <type_traits>
#include <vector>

// Names and sizes of the rows.
namespace scree::bench {

using Space = Kokkos::DefaultExecutionSpace;
inline constexpr bool on_gpu = !std::is_same_v<Space, Kokkos::DefaultHostExecutionSpace>;

/// The basis of the compiled loops: that of a formulation with the same dimension and precision.
template <int Dim, class Real>
using BasisOf = Basis<Dim, Real, WendlandC2, Space>;

/// "3d/f32".
template <class P>
std::string basis_name() {
  return fmt::format("{}d/f{}", P::dim, 8 * sizeof(typename P::real));
}

/// Numbers of particles, to be rounded to a square or cube: those that a machine can run in minutes.
inline std::vector<int> small_sizes() {
  if (on_gpu) return {10'000, 100'000, 1'000'000};
  return {10'000, 100'000};
}
template <class P>
std::vector<int> sizes() {
  auto result = small_sizes();
  if (on_gpu && P::dim == 3) result.push_back(8'000'000);
  return result;
}

/// Smoothing lengths over the spacing: 28 neighbours in 2D; in 3D 66, as in the first measured reference values, and
/// some 110, the usual choice.
template <class P>
std::vector<double> smoothings() {
  if constexpr (P::dim == 2)
    return {1.55};
  else
    return {1.25, 1.5};
}

}  // namespace scree::bench
