// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../kernels/default_bases.hpp"
#include "../neighbours/verlet_list.hpp"
#include "neighbourhood.hpp"
#include "periodic.hpp"
#include "saved_fields.hpp"
#include "searches.hpp"
#include "sort.hpp"

#include <cstdint>
#include <string>

// The instances of the templates of systems in the library scree::compiled. src/compiled/instances.cpp makes the
// instances from this list.
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
  SCREE_INSTANCE int scree::running_sum(P::space const&, std::string_view, int, scree::detail::FindImages<P> const&)

SCREE_INSTANCE void scree::detail::run_portions(Kokkos::DefaultHostExecutionSpace const&, std::string_view, int,
                                                scree::detail::Portions const&);
SCREE_INSTANCE class scree::detail::UntypedParticles<Kokkos::DefaultExecutionSpace>;
SCREE_INSTANCE class scree::detail::SavedFields<Kokkos::DefaultExecutionSpace>;
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);

#undef SCREE_INSTANCES
#endif
