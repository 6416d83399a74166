// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#ifdef KOKKOS_ENABLE_CUDA

#include <stdexcept>
#include <string>

namespace scree::detail {

/// Throws std::runtime_error if a CUDA call has failed.
inline void check_cuda(cudaError_t result, char const* what) {
  if (result == cudaSuccess) return;
  (void)cudaGetLastError();  // clears the error, which CUDA would otherwise report again
  throw std::runtime_error(std::string("scree: ") + what + ": " + cudaGetErrorString(result));
}

}  // namespace scree::detail

#endif
