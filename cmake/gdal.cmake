# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree::gdal, for programs that read GeoTIFF and other rasters through GDAL: the headers in include/scree/gdal. Programs
# that link it are compiled with SCREE_HAS_GDAL.

find_package(GDAL QUIET)
if(NOT TARGET GDAL::GDAL)
  message(STATUS "scree: without GDAL (Debian: libgdal-dev), so rasters are read from ESRI ASCII grids only")
  return()
endif()
add_library(scree_gdal INTERFACE)
add_library(scree::gdal ALIAS scree_gdal)
set_target_properties(scree_gdal PROPERTIES EXPORT_NAME gdal)
target_compile_definitions(scree_gdal INTERFACE SCREE_HAS_GDAL)
target_link_libraries(scree_gdal INTERFACE scree GDAL::GDAL)
target_sources(scree_gdal INTERFACE FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${gdal_headers})
