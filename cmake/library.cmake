# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree::scree is headers only, everything but include/scree/io, app and gdal; scree::io adds the first and HDF5, scree::app
# (app.cmake) the second, scree::gdal (gdal.cmake) the third. scree::compiled is scree::scree with a library that holds what does
# not depend on a formulation, and the pair loops of default models (docs/style.md).

file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/*.[hi]pp")
set(io_headers ${headers})
set(app_headers ${headers})
set(gdal_headers ${headers})
list(FILTER headers EXCLUDE REGEX "/include/scree/(io|app|gdal)/")
list(FILTER io_headers INCLUDE REGEX "/include/scree/io/")
list(FILTER app_headers INCLUDE REGEX "/include/scree/app/")
list(FILTER gdal_headers INCLUDE REGEX "/include/scree/gdal/")

add_library(scree INTERFACE)
add_library(scree::scree ALIAS scree)
target_compile_features(scree INTERFACE cxx_std_20)
target_link_libraries(scree INTERFACE Kokkos::kokkos Eigen3::Eigen fmt::fmt)
target_sources(scree INTERFACE FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${headers})

set(scree_for_programs scree) # what scree::app and scree's own programs link
if(SCREE_COMPILED)
  file(GLOB compiled_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/compiled/*.cpp")
  add_library(scree_compiled STATIC ${compiled_sources})
  add_library(scree::compiled ALIAS scree_compiled)
  set_target_properties(scree_compiled PROPERTIES EXPORT_NAME compiled POSITION_INDEPENDENT_CODE ON)
  target_compile_definitions(scree_compiled PUBLIC SCREE_COMPILED)
  # The pair loops and solvers are for programs without AVX, whatever else the library is compiled with (granular/instances.hpp).
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    set_source_files_properties("${PROJECT_SOURCE_DIR}/src/compiled/loops.cpp" "${PROJECT_SOURCE_DIR}/src/compiled/loops_of_other_models.cpp"
                                "${PROJECT_SOURCE_DIR}/src/compiled/solvers.cpp"
                                PROPERTIES COMPILE_OPTIONS -mno-avx)
  endif()
  target_link_libraries(scree_compiled PUBLIC scree PRIVATE $<BUILD_INTERFACE:$<TARGET_NAME_IF_EXISTS:scree_own_headers>>)
  if(NOT PROJECT_IS_TOP_LEVEL)
    set_target_properties(scree_compiled PROPERTIES EXCLUDE_FROM_ALL ON) # built where something links it
  endif()
  set(scree_for_programs scree_compiled)
endif()

if(TARGET hdf5::hdf5)
  add_library(scree_io INTERFACE)
  add_library(scree::io ALIAS scree_io)
  set_target_properties(scree_io PROPERTIES EXPORT_NAME io)
  # Applications, which are packed for other systems, take the archive of HDF5.
  set(archive "$<AND:$<TARGET_EXISTS:scree_static_hdf5>,$<BOOL:$<TARGET_PROPERTY:SCREE_STATIC_HDF5>>>")
  target_link_libraries(scree_io INTERFACE scree
    $<BUILD_INTERFACE:$<IF:${archive},scree_static_hdf5,hdf5::hdf5>> $<INSTALL_INTERFACE:hdf5::hdf5>)
  target_sources(scree_io INTERFACE FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${io_headers})
endif()

# Kokkos and Eigen without optimisation: a program runs many times as long, and nothing else says why.
include("${CMAKE_CURRENT_LIST_DIR}/warn_unoptimised.cmake")
