# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree_build_once(<prefix> NAME kokkos-5.0.2-openmp ARCHIVE kokkos-5.0.2.tar.gz CXX g++ OPTIONS -DA=B ...)
#
# Builds a CMake project once per user, compiler and option set, and sets <prefix> to its install prefix.
# PREPARE names a function to call with the unpacked source; <SOURCE> in CXX stands for that folder; KEY is whatever else
# makes two builds differ.
# The prefix appears by one rename after a complete install, so an interrupted build leaves nothing that looks finished.

include_guard(GLOBAL)
cmake_policy(VERSION 3.24)
include("${CMAKE_CURRENT_LIST_DIR}/fetch.cmake")

# "gcc-12.2.0" for a compiler, from what it says with --version.
function(scree_compiler_tag result compiler)
  execute_process(COMMAND "${compiler}" --version OUTPUT_VARIABLE text ERROR_QUIET)
  if(text MATCHES "NVIDIA")
    set(name nvcc)
  elseif(text MATCHES "clang")
    set(name clang)
  elseif(text MATCHES "Free Software Foundation")
    set(name gcc)
  else()
    cmake_path(GET compiler FILENAME name)
  endif()
  string(REGEX MATCH "[0-9]+\\.[0-9]+(\\.[0-9]+)?" version "${text}")
  set(${result} "${name}-${version}" PARENT_SCOPE)
endfunction()

# Runs one step of a build; stops with the end of its log when it fails.
function(scree_run_step log)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_FILE "${log}" ERROR_FILE "${log}")
  if(NOT code EQUAL 0)
    file(STRINGS "${log}" lines ENCODING UTF-8)
    list(REVERSE lines)
    list(SUBLIST lines 0 30 lines)
    list(REVERSE lines)
    list(JOIN lines "\n  " text)
    message(FATAL_ERROR "scree: building a dependency failed (${code}). The whole log is ${log}; it ends with\n  ${text}")
  endif()
endfunction()

function(scree_build_once result)
  cmake_parse_arguments(arg "" "NAME;ARCHIVE;CXX;KEY;PREPARE" "OPTIONS" ${ARGN})
  scree_cache_directory(cache)
  string(SHA256 hash "${arg_OPTIONS} ${arg_KEY}")
  string(SUBSTRING "${hash}" 0 8 hash)
  set(prefix "${cache}/prefix/${arg_NAME}-${hash}")
  set(${result} "${prefix}" PARENT_SCOPE)
  if(EXISTS "${prefix}")
    return()
  endif()

  file(LOCK "${prefix}.lock" GUARD FUNCTION TIMEOUT 0 RESULT_VARIABLE busy)
  if(busy)
    message(STATUS "scree: waiting for another process that builds ${arg_NAME}; its log is ${prefix}.log")
    file(LOCK "${prefix}.lock" GUARD FUNCTION)
  endif()
  if(EXISTS "${prefix}") # another configure finished it while this one waited
    return()
  endif()

  file(GLOB abandoned "${prefix}.work-*")
  if(abandoned)
    file(REMOVE_RECURSE ${abandoned})
  endif()
  string(RANDOM LENGTH 6 unique) # what an interrupted build left running writes elsewhere
  set(work "${prefix}.work-${unique}")
  set(log "${prefix}.log")
  file(ARCHIVE_EXTRACT INPUT "${arg_ARCHIVE}" DESTINATION "${work}/unpacked")
  file(GLOB source "${work}/unpacked/*") # the single folder in a release tarball
  if(arg_PREPARE)
    cmake_language(CALL "${arg_PREPARE}" "${source}")
  endif()
  find_program(SCREE_NINJA ninja)
  mark_as_advanced(SCREE_NINJA)
  if(SCREE_NINJA)
    list(APPEND arg_OPTIONS -G Ninja "-DCMAKE_MAKE_PROGRAM=${SCREE_NINJA}")
  endif()
  cmake_host_system_information(RESULT jobs QUERY NUMBER_OF_LOGICAL_CORES)

  message(STATUS "scree: building ${arg_NAME} once for this user; log in ${log}")
  string(REPLACE "<SOURCE>" "${source}" compiler "${arg_CXX}")
  set(clean_environment "${CMAKE_COMMAND}" -E env --unset=CXXFLAGS --unset=LDFLAGS --unset=DESTDIR)
  scree_run_step("${log}" ${clean_environment} "${CMAKE_COMMAND}" -S "${source}" -B "${work}/build"
                 "-DCMAKE_CXX_COMPILER=${compiler}" "-DCMAKE_INSTALL_PREFIX=${prefix}" ${arg_OPTIONS})
  scree_run_step("${log}" ${clean_environment} "${CMAKE_COMMAND}" --build "${work}/build" --parallel ${jobs})
  scree_run_step("${log}" "${CMAKE_COMMAND}" -E env "DESTDIR=${work}/stage"
                 "${CMAKE_COMMAND}" --install "${work}/build")
  file(RENAME "${work}/stage${prefix}" "${prefix}")
  file(REMOVE_RECURSE "${work}")
  message(STATUS "scree: ${arg_NAME} is ready in ${prefix}")
endfunction()
