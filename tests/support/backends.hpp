// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#include <tuple>

namespace scree::test {

/// The execution spaces of this build, for TEMPLATE_LIST_TEST_CASE: the host and, where there is one, the device.
#ifdef KOKKOS_ENABLE_CUDA
using Backends = std::tuple<Kokkos::DefaultHostExecutionSpace, Kokkos::Cuda>;
#else
using Backends = std::tuple<Kokkos::DefaultHostExecutionSpace>;
#endif

}  // namespace scree::test
