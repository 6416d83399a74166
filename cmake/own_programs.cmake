# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree::own is what scree's own tests, examples and benchmarks link: the library and the warnings we want for ourselves.
# scree::own_headers is the same from headers alone.

add_library(scree_own INTERFACE)
add_library(scree::own ALIAS scree_own)
add_library(scree_own_headers INTERFACE)
add_library(scree::own_headers ALIAS scree_own_headers)
target_link_libraries(scree_own INTERFACE scree_own_headers ${scree_for_programs})
target_link_libraries(scree_own_headers INTERFACE scree::scree)
target_compile_options(scree_own_headers INTERFACE -Wall -Wextra -Wshadow)
if(SCREE_WARNINGS_AS_ERRORS)
  target_compile_options(scree_own_headers INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT SCREE_SANITIZE) # which takes much memory itself
  # GCC collects garbage from 128 MB on, which takes a fifth of the time to compile templates; this costs half a gigabyte.
  target_compile_options(scree_own_headers INTERFACE --param=ggc-min-heapsize=$<IF:$<BOOL:$<TARGET_PROPERTY:SCREE_LESS_MEMORY>>,600000,1000000>)
endif()
if(CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
  # 'long double' in Catch2; __device__ at defaulted functions of Eigen.
  target_compile_options(scree_own_headers INTERFACE "SHELL:-Xcudafe --diag_suppress=20208" "SHELL:-Xcudafe --diag_suppress=20012")
  # Behind nvcc, GCC 12 warns of Kokkos's headers too, of the counter of an execution-space instance, without cause; and of
  # parentheses that nvcc writes.
  target_compile_options(scree_own_headers INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-use-after-free> -Wno-parentheses)
endif()
if(SCREE_SANITIZE)
  set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_compile_options(scree_own_headers INTERFACE ${sanitize})
  target_link_options(scree_own_headers INTERFACE ${sanitize})
endif()

# scree_precompiled(<name> <libraries> <options> <headers>...): compiles headers once, for scree_use_precompiled() of targets with
# the same libraries and options. nvcc has no precompiled headers: with it nothing happens.
set(scree_options_of_precompiled $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>) # ccache asks for it
function(scree_precompiled name libraries options)
  if(NOT CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
    file(CONFIGURE OUTPUT ${name}.cpp CONTENT "// only for its precompiled headers\n")
    add_library(${name} OBJECT EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
    target_link_libraries(${name} PRIVATE ${libraries})
    target_compile_options(${name} PRIVATE ${options} ${scree_options_of_precompiled})
    target_precompile_headers(${name} PRIVATE ${ARGN})
    # Not from ccache: it may give those of another clone, which take the headers of the library from there.
    set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "")
  endif()
endfunction()
function(scree_use_precompiled target name)
  if(TARGET ${name})
    target_compile_options(${target} PRIVATE ${scree_options_of_precompiled})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

# The headers that nearly every program of the library alone includes. Programs that use them, those of the course, run for seconds:
# -O1 takes three quarters of the time of -O3 to compile.
set(scree_options_of_small_programs $<$<CONFIG:Release>:-O1>)
if(CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
  set(scree_options_of_small_programs "") # nvcc takes most of the time itself, and it warns of two levels
endif()
scree_precompiled(scree_precompiled_library "scree::own;scree::io" "${scree_options_of_small_programs}" <scree/solver/solver.hpp> <scree/granular/granular.hpp>)
