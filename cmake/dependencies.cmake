# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# What the library needs. An installed copy wins; what is missing comes from the per-user cache (build_once.cmake).

include("${CMAKE_CURRENT_LIST_DIR}/kokkos.cmake")

if(NOT SCREE_HOST_CXX)
  set(SCREE_HOST_CXX "${CMAKE_CXX_COMPILER}") # with SCREE_CUDA: the compiler behind nvcc_wrapper
endif()

# --- Kokkos --------------------------------------------------------------------------------------
if(NOT TARGET Kokkos::kokkos)
  if(NOT SCREE_KOKKOS_DEBUG OR SCREE_CUDA)
    find_package(Kokkos ${SCREE_KOKKOS_VERSION} CONFIG QUIET)
  endif()
  if(NOT Kokkos_FOUND)
    scree_build_kokkos(kokkos_prefix CXX "${CMAKE_CXX_COMPILER}" DEBUG "${SCREE_KOKKOS_DEBUG}")
    find_package(Kokkos ${SCREE_KOKKOS_VERSION} CONFIG REQUIRED PATHS "${kokkos_prefix}" NO_DEFAULT_PATH)
  endif()
  message(STATUS "scree: Kokkos ${Kokkos_VERSION} (${Kokkos_DEVICES}; ${Kokkos_ARCH}) in ${Kokkos_DIR}")
endif()

# --- Eigen ---------------------------------------------------------------------------------------
if(NOT TARGET Eigen3::Eigen)
  find_package(Eigen3 CONFIG QUIET) # Eigen 3.4 refuses ranges of versions
  if(NOT Eigen3_FOUND OR Eigen3_VERSION VERSION_LESS 3.4 OR Eigen3_VERSION VERSION_GREATER_EQUAL 6)
    message(FATAL_ERROR "scree needs Eigen 3.4 or 5 (found: '${Eigen3_VERSION}'). On Debian or Ubuntu: apt-get install "
                        "libeigen3-dev; elsewhere pass -DEigen3_ROOT=<its prefix>.")
  endif()
endif()
set(SCREE_EIGEN_VERSION 3.4) # for screeConfig.cmake
if(Eigen3_VERSION VERSION_GREATER_EQUAL 5)
  set(SCREE_EIGEN_VERSION 5)
endif()

# --- fmt: its compiled library, because each source file compiles a tenth longer without; at least 10.1, because older ones
# do not compile as CUDA C++20 -----------------------------------------------------------------------
if(NOT TARGET fmt::fmt)
  find_package(fmt 10.1 CONFIG QUIET)
  if(NOT fmt_FOUND)
    scree_fetch(archive NAME fmt VERSION 10.1.1
      URL https://github.com/fmtlib/fmt/archive/refs/tags/10.1.1.tar.gz
      SHA256 78b8c0a72b1c35e4443a7e308df52498252d1cefc2b08c9a97bc9ee6cfe61f8b
      DEBIAN pool/main/f/fmtlib/fmtlib_10.1.1+ds1.orig.tar.gz
      DEBIAN_SHA256 7000f214d2628f04174822f8048c573f1608194408d7931121595a03f1c18a17)
    scree_compiler_tag(tag "${SCREE_HOST_CXX}")
    scree_build_once(fmt_prefix NAME "fmt-10.1.1-${tag}" ARCHIVE "${archive}" CXX "${SCREE_HOST_CXX}"
                     OPTIONS -DCMAKE_BUILD_TYPE=Release -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DFMT_DOC=OFF -DFMT_TEST=OFF
                             -DCMAKE_INSTALL_LIBDIR=lib)
    find_package(fmt 10.1 CONFIG REQUIRED PATHS "${fmt_prefix}" NO_DEFAULT_PATH)
  endif()
endif()

# --- HDF5: its C library, for scree::io ----------------------------------------------------------
include("${CMAKE_CURRENT_LIST_DIR}/hdf5.cmake")
if(NOT TARGET hdf5::hdf5)
  if(SCREE_BUILD_TESTS OR SCREE_BUILD_EXAMPLES)
    message(FATAL_ERROR "scree's tests and examples need HDF5. On Debian or Ubuntu: apt-get install libhdf5-dev; elsewhere pass "
                        "-DHDF5_ROOT=<its prefix>, or -DSCREE_BUILD_TESTS=OFF -DSCREE_BUILD_EXAMPLES=OFF.")
  endif()
  message(STATUS "scree: no HDF5, so scree::io is left out")
endif()
