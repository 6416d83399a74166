# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree::own is what scree's own tests, examples and benchmarks link: the library and the warnings we want for ourselves.

add_library(scree_own INTERFACE)
add_library(scree::own ALIAS scree_own)
target_link_libraries(scree_own INTERFACE scree::scree)
target_compile_options(scree_own INTERFACE -Wall -Wextra -Wshadow)
if(SCREE_WARNINGS_AS_ERRORS)
  target_compile_options(scree_own INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT SCREE_SANITIZE) # which takes much memory itself
  # GCC collects garbage from 128 MB on, which takes a fifth of the time to compile templates; this costs half a gigabyte.
  target_compile_options(scree_own INTERFACE --param=ggc-min-heapsize=1000000)
endif()
if(CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
  # 'long double' in Catch2; __device__ at defaulted functions of Eigen.
  target_compile_options(scree_own INTERFACE "SHELL:-Xcudafe --diag_suppress=20208" "SHELL:-Xcudafe --diag_suppress=20012")
  # Behind nvcc, GCC 12 warns of Kokkos's headers too, of the counter of an execution-space instance, without cause; and of
  # parentheses that nvcc writes.
  target_compile_options(scree_own INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-use-after-free> -Wno-parentheses)
endif()
if(SCREE_SANITIZE)
  set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_compile_options(scree_own INTERFACE ${sanitize})
  target_link_options(scree_own INTERFACE ${sanitize})
endif()

# scree_host_only(target): its sources know nothing of devices, so in a CUDA build the host compiler alone compiles them. That
# is quicker, and nvcc 13 does not get through some of them (its front end never ends on HDF5 and variant code).
function(scree_host_only target)
  if(CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
    target_compile_options(${target} PRIVATE --host-only)
  endif()
endfunction()
