// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../kernels/wendland_c2.hpp"
#include "../neighbours/verlet_list.hpp"
#include "periodic.hpp"
#include "saved_fields.hpp"
#include "searches.hpp"
#include "sort.hpp"

#include <cstdint>
#include <string>

// The instances of templates that the library scree::compiled has: those for the default kernel and the default
// execution space. A program that links it does not compile them again; instances for other kernels and spaces it
// compiles itself. src/compiled/instances.cpp makes them from this list.
#ifdef SCREE_COMPILED
#ifndef SCREE_INSTANCE
#define SCREE_INSTANCE extern template
#endif
#define SCREE_INSTANCES(P)                                                                      \
  SCREE_INSTANCE class CellList<P>;                                                             \
  SCREE_INSTANCE class SkinWatch<P, 2>;                                                         \
  SCREE_INSTANCE class detail::ListInRows<P, detail::CandidateRows<P, std::uint32_t>>;          \
  SCREE_INSTANCE class detail::ListInRows<P, detail::NumberedRows<P, std::uint32_t>>;           \
  SCREE_INSTANCE class Searches<P, VerletList<P>, 2>;                                           \
  SCREE_INSTANCE Array<P, int const> detail::order_along_cells<P>(Positions<P> const&, double); \
  SCREE_INSTANCE class PeriodicImages<P>;                                                       \
  SCREE_INSTANCE int running_sum(P::space const&, std::string const&, int, detail::FindImages<P> const&)

namespace scree {
namespace detail {
template <int Dim, class Real>
using DefaultBasis = Basis<Dim, Real, WendlandC2, Kokkos::DefaultExecutionSpace>;
using DefaultIn2D = DefaultBasis<2, double>;
using DefaultIn3D = DefaultBasis<3, double>;
using FloatIn2D = DefaultBasis<2, float>;
using FloatIn3D = DefaultBasis<3, float>;
}  // namespace detail

SCREE_INSTANCE void detail::run_portions(Kokkos::DefaultHostExecutionSpace const&, std::string const&, int,
                                         detail::Portions const&);
SCREE_INSTANCE class detail::UntypedParticles<Kokkos::DefaultExecutionSpace>;
SCREE_INSTANCE class detail::SavedFields<Kokkos::DefaultExecutionSpace>;
SCREE_INSTANCES(detail::DefaultIn2D);
SCREE_INSTANCES(detail::DefaultIn3D);
SCREE_INSTANCES(detail::FloatIn2D);
SCREE_INSTANCES(detail::FloatIn3D);
}  // namespace scree

#undef SCREE_INSTANCES
#endif
