// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

// Where loops run and their arrays lie.
namespace scree {

template <class P>
using memory_of = typename P::space::memory_space;

/// Whether loops run where the host's memory is.
template <class P>
inline constexpr bool runs_on_host = Kokkos::SpaceAccessibility<Kokkos::HostSpace, memory_of<P>>::accessible;

}  // namespace scree
