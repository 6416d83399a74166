// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#if __has_include(<mpi.h>)  // programs that use this header need the headers and the library of MPI

#include "messages_arrive.hpp"
#include "mpi.hpp"

#if __has_include(<mpi-ext.h>)
#include <mpi-ext.h>
#endif

#include <cstddef>
#include <vector>

// Tests of whether MPI can read and write GPU memory.
namespace scree::detail {

/// Whether the MPI library reports that it can read and write memory of NVIDIA GPUs.
inline bool says_gpu_aware() {
  int says = 0;
#if defined(MPIX_GPU_SUPPORT_CUDA)
  MPIX_GPU_query_support(MPIX_GPU_SUPPORT_CUDA, &says);
#elif defined(MPIX_CUDA_AWARE_SUPPORT)
  says = MPIX_Query_cuda_support();
#endif
  return says == 1;
}

/// Whether `yes` is true on all ranks.
inline bool all_say(Mpi& mpi, bool yes) {
  char const mine = yes ? 1 : 0;
  std::vector<char> all(std::size_t(mpi.ranks()));
  mpi.gather(&mine, 1, all.data());
  for (char const each : all) yes = yes && each == 1;
  return yes;
}

/// Whether short and long messages between GPUs arrive without staging through host memory. An MPI library that does
/// not support this may abort the program. All ranks call this function together.
template <class Space>
bool is_gpu_aware(MPI_Comm communicator, Space const& space) {
  Mpi direct(communicator, DeviceMessages::direct);
  return all_say(direct, short_and_long_arrive(direct, space));
}

}  // namespace scree::detail

#endif
