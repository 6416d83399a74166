# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Defines scree_static_hdf5, the archive of HDF5: programs that link it run on systems without HDF5, or with one of another name
# (libhdf5-103-1 on Debian 12, libhdf5-310 on Debian 13). Nothing is defined if there is no archive, or if it needs more than
# zlib and szip: the archive of Debian 13 also needs libcurl.

include(CheckCXXSourceCompiles)

set(archives "")
foreach(names IN ITEMS "libhdf5_serial.a libhdf5.a" libsz.a libaec.a libz.a)
  string(REPLACE " " ";" names "${names}")
  list(GET names 0 first)
  find_library(SCREE_ARCHIVE_${first} NAMES ${names} HINTS "${HDF5_ROOT}" ENV HDF5_ROOT PATH_SUFFIXES lib)
  mark_as_advanced(SCREE_ARCHIVE_${first})
  if(SCREE_ARCHIVE_${first})
    list(APPEND archives "${SCREE_ARCHIVE_${first}}")
  endif()
endforeach()
list(APPEND archives ${CMAKE_DL_LIBS})

if(SCREE_ARCHIVE_libhdf5_serial.a)
  set(CMAKE_REQUIRED_INCLUDES "${HDF5_C_INCLUDE_DIR}")
  set(CMAKE_REQUIRED_LIBRARIES ${archives})
  set(CMAKE_REQUIRED_QUIET ON)
  check_cxx_source_compiles([[
#include <hdf5.h>
int main() { return H5Fclose(H5Fcreate("file.h5", H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) < 0; }
]] SCREE_STATIC_HDF5_LINKS)
  unset(CMAKE_REQUIRED_INCLUDES)
  unset(CMAKE_REQUIRED_LIBRARIES)
  unset(CMAKE_REQUIRED_QUIET)
endif()

if(SCREE_STATIC_HDF5_LINKS)
  add_library(scree_static_hdf5 INTERFACE)
  target_link_libraries(scree_static_hdf5 INTERFACE ${archives})
  target_include_directories(scree_static_hdf5 SYSTEM INTERFACE "${HDF5_C_INCLUDE_DIR}")
else()
  message(STATUS "scree: HDF5 is not linked statically, so packages of the applications need the HDF5 of this system")
endif()
