# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Included before project() when SCREE_CUDA is on: takes a CUDA Kokkos from the per-user cache, and its nvcc_wrapper as the
# compiler. Whoever has a CUDA Kokkos already leaves SCREE_CUDA off and passes Kokkos_ROOT and CMAKE_CXX_COMPILER instead.

include("${CMAKE_CURRENT_LIST_DIR}/kokkos.cmake")

if(CMAKE_CXX_COMPILER AND NOT SCREE_CUDA_PREFIX)
  message(FATAL_ERROR "scree: SCREE_CUDA=ON chooses the compiler itself and needs an empty build folder. Either leave "
                      "CMAKE_CXX_COMPILER out, or leave SCREE_CUDA out and pass Kokkos_ROOT=<a Kokkos built with CUDA>.")
endif()

find_program(SCREE_NVCC nvcc HINTS ENV CUDA_ROOT ENV CUDA_HOME ENV CUDA_PATH PATHS /usr/local/cuda PATH_SUFFIXES bin)
find_program(SCREE_HOST_CXX NAMES $ENV{CXX} g++)
mark_as_advanced(SCREE_NVCC SCREE_HOST_CXX)
if(NOT SCREE_NVCC)
  message(FATAL_ERROR "scree: SCREE_CUDA is on, but there is no nvcc. Install the CUDA toolkit (12.2 or newer), add its bin/ to "
                      "PATH or set CUDA_ROOT; or configure without SCREE_CUDA.")
endif()

scree_build_kokkos(prefix CXX "${SCREE_HOST_CXX}" NVCC "${SCREE_NVCC}" CUDA_ARCH "${SCREE_CUDA_ARCH}" DEBUG "${SCREE_KOKKOS_DEBUG}")
set(SCREE_CUDA_PREFIX "${prefix}" CACHE INTERNAL "Kokkos with CUDA, from the per-user cache")
set(Kokkos_ROOT "${prefix}" CACHE PATH "Where Kokkos is" FORCE)
set(CMAKE_CXX_COMPILER "${prefix}/bin/nvcc_wrapper" CACHE FILEPATH "nvcc behind the command line of a C++ compiler" FORCE)
