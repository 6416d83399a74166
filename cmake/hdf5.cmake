# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Defines hdf5::hdf5, the C library, when it is found. CMake's own FindHDF5 would need the C language switched on in every
# project that uses scree. HDF5_ROOT names another place to look. Installed beside screeConfig.cmake.

if(NOT TARGET hdf5::hdf5)
  find_path(HDF5_C_INCLUDE_DIR hdf5.h HINTS "${HDF5_ROOT}" ENV HDF5_ROOT PATH_SUFFIXES include hdf5/serial)
  find_library(HDF5_C_LIBRARY NAMES hdf5 hdf5_serial HINTS "${HDF5_ROOT}" ENV HDF5_ROOT PATH_SUFFIXES lib hdf5/serial)
  mark_as_advanced(HDF5_C_INCLUDE_DIR HDF5_C_LIBRARY)
  if(HDF5_C_INCLUDE_DIR AND HDF5_C_LIBRARY)
    add_library(hdf5::hdf5 UNKNOWN IMPORTED)
    set_target_properties(hdf5::hdf5 PROPERTIES IMPORTED_LOCATION "${HDF5_C_LIBRARY}"
                          INTERFACE_INCLUDE_DIRECTORIES "${HDF5_C_INCLUDE_DIR}")
  endif()
endif()
