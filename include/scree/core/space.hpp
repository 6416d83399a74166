// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

// Where loops run and where their arrays are stored.
namespace scree {

/// Whether loops of an execution space work in host memory.
template <class Space>
inline constexpr bool on_host = Kokkos::SpaceAccessibility<Kokkos::HostSpace, typename Space::memory_space>::accessible;

template <class P>
using memory_of = typename P::space::memory_space;

template <class P>
inline constexpr bool runs_on_host = on_host<typename P::space>;

}  // namespace scree
