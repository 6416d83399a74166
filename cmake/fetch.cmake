# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree_fetch(<archive> NAME kokkos VERSION 5.0.2 URL ... SHA256 ... DEBIAN pool/... DEBIAN_SHA256 ...)
#
# Sets <archive> to a tarball whose checksum was verified. Looked at in this order:
#   the per-user cache, the folder SCREE_TARBALLS, the upstream release, the Debian archive.
# The last one uses apt's own downloader and the mirrors this machine is configured with.

include_guard(GLOBAL)
cmake_policy(VERSION 3.24)

if(NOT SCREE_TARBALLS AND DEFINED ENV{SCREE_TARBALLS})
  set(SCREE_TARBALLS "$ENV{SCREE_TARBALLS}")
endif()

# The per-user cache: ${SCREE_CACHE}, else ${XDG_CACHE_HOME}/scree, else ~/.cache/scree.
function(scree_cache_directory result)
  if(DEFINED ENV{SCREE_CACHE})
    set(directory "$ENV{SCREE_CACHE}")
  elseif(DEFINED ENV{XDG_CACHE_HOME})
    set(directory "$ENV{XDG_CACHE_HOME}/scree")
  else()
    set(directory "$ENV{HOME}/.cache/scree")
  endif()
  file(MAKE_DIRECTORY "${directory}")
  set(${result} "${directory}" PARENT_SCOPE)
endfunction()

# True when the file exists and has one of the checksums.
function(scree_has_checksum result file)
  set(${result} FALSE PARENT_SCOPE)
  if(EXISTS "${file}")
    file(SHA256 "${file}" found)
    if(found IN_LIST ARGN)
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

function(scree_fetch_from_folder target folder)
  cmake_parse_arguments(arg "" "" "NAMES;CHECKSUMS" ${ARGN})
  foreach(name IN LISTS arg_NAMES)
    scree_has_checksum(good "${folder}/${name}" ${arg_CHECKSUMS})
    if(good)
      file(COPY_FILE "${folder}/${name}" "${target}")
      return()
    elseif(EXISTS "${folder}/${name}")
      message(WARNING "scree: ${folder}/${name} has the wrong SHA-256 and is not used.")
    endif()
  endforeach()
endfunction()

function(scree_fetch_from_url target url)
  file(DOWNLOAD "${url}" "${target}" STATUS status TIMEOUT 120 INACTIVITY_TIMEOUT 10)
  list(GET status 0 code)
  list(GET status 1 text)
  if(NOT code EQUAL 0)
    message(STATUS "scree: ${url}: ${text}")
    file(REMOVE "${target}")
  endif()
endfunction()

function(scree_fetch_from_debian target path checksum)
  find_program(SCREE_APT_GET apt-get)
  find_program(SCREE_APT_HELPER apt-helper PATHS /usr/lib/apt)
  mark_as_advanced(SCREE_APT_GET SCREE_APT_HELPER)
  if(NOT SCREE_APT_GET OR NOT SCREE_APT_HELPER)
    return()
  endif()
  execute_process(COMMAND "${SCREE_APT_GET}" indextargets --format "$(REPO_URI)" OUTPUT_VARIABLE mirrors ERROR_QUIET)
  string(REGEX MATCHALL "[^\n]+" mirrors "${mirrors}")
  list(REMOVE_DUPLICATES mirrors)
  foreach(mirror IN LISTS mirrors)
    execute_process(COMMAND "${SCREE_APT_HELPER}" -o APT::Sandbox::User=root
                            download-file "${mirror}${path}" "${target}" "SHA256:${checksum}"
                    RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
    if(code EQUAL 0)
      return()
    endif()
    file(REMOVE "${target}" "${target}.FAILED")
  endforeach()
endfunction()

function(scree_fetch result)
  cmake_parse_arguments(arg "" "NAME;VERSION;URL;SHA256;DEBIAN;DEBIAN_SHA256" "" ${ARGN})
  set(checksums ${arg_SHA256} ${arg_DEBIAN_SHA256})
  set(file_name "${arg_NAME}-${arg_VERSION}.tar.gz")
  cmake_path(GET arg_URL FILENAME upstream_name)
  cmake_path(GET arg_DEBIAN FILENAME debian_name)

  scree_cache_directory(cache)
  set(archive "${cache}/tarballs/${file_name}")
  set(${result} "${archive}" PARENT_SCOPE)
  file(LOCK "${archive}.lock" GUARD FUNCTION)

  set(partial "${archive}.partial")
  file(REMOVE "${partial}")
  foreach(source IN ITEMS cache folder upstream debian)
    if(source STREQUAL "folder" AND SCREE_TARBALLS)
      scree_fetch_from_folder("${partial}" "${SCREE_TARBALLS}"
                              NAMES "${file_name}" "${upstream_name}" "${debian_name}" CHECKSUMS ${checksums})
    elseif(source STREQUAL "upstream" AND NOT SCREE_NO_UPSTREAM)
      message(STATUS "scree: fetching ${arg_NAME} ${arg_VERSION} from ${arg_URL}")
      scree_fetch_from_url("${partial}" "${arg_URL}")
    elseif(source STREQUAL "debian")
      message(STATUS "scree: fetching ${arg_NAME} ${arg_VERSION} from the Debian archive")
      scree_fetch_from_debian("${partial}" "${arg_DEBIAN}" "${arg_DEBIAN_SHA256}")
    endif()

    if(EXISTS "${partial}")
      scree_has_checksum(good "${partial}" ${checksums})
      if(good)
        file(RENAME "${partial}" "${archive}")
      else()
        message(WARNING "scree: ${arg_NAME} ${arg_VERSION} from '${source}' has the wrong SHA-256 and is not used.")
        file(REMOVE "${partial}")
      endif()
    endif()
    scree_has_checksum(good "${archive}" ${checksums})
    if(good)
      return()
    endif()
  endforeach()

  message(FATAL_ERROR
    "scree needs ${arg_NAME} ${arg_VERSION} or newer and could neither find nor download it.\n"
    "Do one of these:\n"
    "  - install it and pass -D${arg_NAME}_ROOT=<its prefix>;\n"
    "  - put ${arg_URL} into a folder and pass -DSCREE_TARBALLS=<that folder>,\n"
    "    or set the environment variable SCREE_TARBALLS (SHA-256 ${arg_SHA256}).")
endfunction()
