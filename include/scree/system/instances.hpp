// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../core/compiled.hpp"
#include "../kernels/wendland_c2.hpp"
#include "../neighbours/verlet_list.hpp"
#include "neighbourhood.hpp"
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
#define SCREE_INSTANCES(P)                                                                                           \
  SCREE_INSTANCE class scree::CellList<P>;                                                                           \
  SCREE_INSTANCE class scree::SkinWatch<P>;                                                                          \
  SCREE_INSTANCE class scree::detail::ListInRows<P, scree::detail::CandidateRows<P, std::uint32_t>>;                 \
  SCREE_INSTANCE class scree::detail::ListInRows<P, scree::detail::NumberedRows<P, std::uint32_t>>;                  \
  SCREE_INSTANCE class scree::Searches<P, scree::VerletList<P>>;                                                     \
  SCREE_INSTANCE class scree::detail::Neighbourhood<P, scree::VerletList<P>, scree::PeriodicImages<P>>;              \
  SCREE_INSTANCE class scree::AnyParticles<P>;                                                                       \
  SCREE_INSTANCE scree::Array<P, int const> scree::detail::order_along_cells<P>(scree::Positions<P> const&, double); \
  SCREE_INSTANCE class scree::PeriodicImages<P>;                                                                     \
  SCREE_INSTANCE int scree::running_sum(P::space const&, std::string const&, int, scree::detail::FindImages<P> const&)

namespace scree::detail {
template <int Dim, class Real>
using DefaultBasis = Basis<Dim, Real, WendlandC2, Kokkos::DefaultExecutionSpace>;
using DefaultIn2D = DefaultBasis<2, double>;
using DefaultIn3D = DefaultBasis<3, double>;
using FloatIn2D = DefaultBasis<2, float>;
using FloatIn3D = DefaultBasis<3, float>;
}  // namespace scree::detail

SCREE_INSTANCE void scree::detail::run_portions(Kokkos::DefaultHostExecutionSpace const&, std::string const&, int,
                                                scree::detail::Portions const&);
SCREE_INSTANCE class scree::detail::UntypedParticles<Kokkos::DefaultExecutionSpace>;
SCREE_INSTANCE class scree::detail::SavedFields<Kokkos::DefaultExecutionSpace>;
SCREE_INSTANCES(scree::detail::DefaultIn2D);
SCREE_INSTANCES(scree::detail::DefaultIn3D);
SCREE_INSTANCES(scree::detail::FloatIn2D);
SCREE_INSTANCES(scree::detail::FloatIn3D);

#undef SCREE_INSTANCES
#endif
