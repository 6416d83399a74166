// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../core/compiled.hpp"
#include "wendland_c2.hpp"

#include <type_traits>

// The library scree::compiled contains template instances for the default kernel and the default execution space. A
// header that declares such instances lists them in a macro with one argument, a basis, and passes this macro to
// SCREE_FOR_DEFAULT_BASES. A program that links the library does not compile these instances again, but compiles
// instances for other kernels and execution spaces itself.
#ifdef SCREE_COMPILED
namespace scree::detail {
template <int Dim, class Real>
using DefaultBasis = Basis<Dim, Real, WendlandC2, Kokkos::DefaultExecutionSpace>;
using DefaultIn2D = DefaultBasis<2, double>;
using DefaultIn3D = DefaultBasis<3, double>;
using FloatIn2D = DefaultBasis<2, float>;
using FloatIn3D = DefaultBasis<3, float>;
template <class P>
inline constexpr bool is_default_basis = std::is_same_v<P, DefaultBasis<P::dim, typename P::real>>;
}  // namespace scree::detail

#define SCREE_FOR_DEFAULT_BASES(INSTANCES) \
  INSTANCES(scree::detail::DefaultIn2D);   \
  INSTANCES(scree::detail::DefaultIn3D);   \
  INSTANCES(scree::detail::FloatIn2D);     \
  INSTANCES(scree::detail::FloatIn3D)
#endif
