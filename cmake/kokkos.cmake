# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree_build_kokkos(<prefix> CXX g++ [DEBUG ON] [NVCC nvcc CUDA_ARCH 90])
#
# Sets <prefix> to a Kokkos in the per-user cache, which is built when it is not there.

include_guard(GLOBAL)
cmake_policy(VERSION 3.24)
include("${CMAKE_CURRENT_LIST_DIR}/build_once.cmake")

set(SCREE_KOKKOS_VERSION 5.0.2)

# Kokkos' name of a CUDA compute capability (90 -> HOPPER90).
function(scree_kokkos_cuda_name result arch)
  set(names VOLTA70 TURING75 AMPERE80 AMPERE86 AMPERE87 ADA89 HOPPER90 BLACKWELL100 BLACKWELL120)
  foreach(name IN LISTS names)
    if(name MATCHES "^[A-Z]+${arch}$")
      set(${result} "${name}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "scree: SCREE_CUDA_ARCH=${arch} is not known. Use the compute capability without its dot, such as 90 "
                      "for an H100 or H200 (nvidia-smi --query-gpu=compute_cap --format=csv). Known: ${names}.")
endfunction()

# Writes the full paths of nvcc and of the host compiler into nvcc_wrapper, so that it needs nothing from PATH.
function(scree_fix_nvcc_wrapper source)
  file(READ "${source}/bin/nvcc_wrapper" text)
  string(REPLACE "nvcc_compiler=nvcc\n" "nvcc_compiler=\"${SCREE_WRAPPED_NVCC}\"\n" text "${text}")
  string(REPLACE "DEFAULT_COMPILER:-\"g++\"" "DEFAULT_COMPILER:-\"${SCREE_WRAPPED_CXX}\"" text "${text}")
  file(WRITE "${source}/bin/nvcc_wrapper" "${text}")
endfunction()

function(scree_build_kokkos result)
  cmake_parse_arguments(arg "" "CXX;NVCC;CUDA_ARCH;DEBUG" "" ${ARGN})
  set(name "kokkos-${SCREE_KOKKOS_VERSION}-openmp")
  scree_compiler_tag(compilers "${arg_CXX}")
  set(compiler "${arg_CXX}")
  set(extra)
  set(options
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_STANDARD=20 -DCMAKE_CXX_EXTENSIONS=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON
      -DCMAKE_INSTALL_LIBDIR=lib
      -DKokkos_ENABLE_SERIAL=ON -DKokkos_ENABLE_OPENMP=ON -DKokkos_ENABLE_DEPRECATED_CODE_5=OFF)
  if(arg_DEBUG)
    string(APPEND name "-debug")
    list(APPEND options -DKokkos_ENABLE_DEBUG=ON -DKokkos_ENABLE_DEBUG_BOUNDS_CHECK=ON)
  endif()
  if(arg_NVCC)
    scree_kokkos_cuda_name(arch_name "${arg_CUDA_ARCH}")
    scree_compiler_tag(nvcc_tag "${arg_NVCC}")
    string(APPEND name "-cuda-sm${arg_CUDA_ARCH}")
    string(APPEND compilers "-${nvcc_tag}")
    list(APPEND options -DKokkos_ENABLE_CUDA=ON -DKokkos_ENABLE_CUDA_CONSTEXPR=ON -DKokkos_ARCH_${arch_name}=ON)
    set(SCREE_WRAPPED_NVCC "${arg_NVCC}")
    set(SCREE_WRAPPED_CXX "${arg_CXX}")
    set(compiler "<SOURCE>/bin/nvcc_wrapper")
    set(extra PREPARE scree_fix_nvcc_wrapper KEY "${arg_CXX} ${arg_NVCC}")
  endif()

  set(file "kokkos-${SCREE_KOKKOS_VERSION}.tar.gz")
  scree_fetch(archive NAME Kokkos VERSION ${SCREE_KOKKOS_VERSION}
    URL https://github.com/kokkos/kokkos/releases/download/${SCREE_KOKKOS_VERSION}/${file}
    SHA256 188817bb452ca805ee8701f1c5adbbb4fb83dc8d1c50624566a18a719ba0fa5e
    DEBIAN pool/main/k/kokkos/kokkos_${SCREE_KOKKOS_VERSION}.orig.tar.gz
    DEBIAN_SHA256 188817bb452ca805ee8701f1c5adbbb4fb83dc8d1c50624566a18a719ba0fa5e)
  scree_build_once(prefix NAME "${name}-${compilers}" ARCHIVE "${archive}" CXX "${compiler}" OPTIONS ${options} ${extra})
  set(${result} "${prefix}" PARENT_SCOPE)
endfunction()
