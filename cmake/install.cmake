# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# cmake --install, and the package that find_package(scree) reads.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/scree")
install(TARGETS scree EXPORT scree FILE_SET HEADERS)
if(TARGET scree_io)
  install(TARGETS scree_io EXPORT scree FILE_SET HEADERS)
endif()
set(independent ARCH_INDEPENDENT)
if(TARGET scree_compiled) # if it was built: its library may be missing, and then the package has no component compiled
  install(TARGETS scree_compiled EXPORT scree_compiled ARCHIVE OPTIONAL)
  install(EXPORT scree_compiled NAMESPACE scree:: FILE screeCompiledTargets.cmake DESTINATION "${package_directory}")
  set(compiled_library
      "${CMAKE_INSTALL_LIBDIR}/${CMAKE_STATIC_LIBRARY_PREFIX}scree_compiled${CMAKE_STATIC_LIBRARY_SUFFIX}")
  set(independent)
endif()
if(TARGET scree_app) # if it was built: its library may be missing, and then the package has no component app
  install(TARGETS scree_app EXPORT scree_app ARCHIVE OPTIONAL FILE_SET HEADERS)
  install(EXPORT scree_app NAMESPACE scree:: FILE screeAppTargets.cmake DESTINATION "${package_directory}")
  set(app_library "${CMAKE_INSTALL_LIBDIR}/${CMAKE_STATIC_LIBRARY_PREFIX}scree_app${CMAKE_STATIC_LIBRARY_SUFFIX}")
  set(independent)
endif()
if(TARGET scree_gdal)
  install(TARGETS scree_gdal EXPORT scree_gdal FILE_SET HEADERS)
  install(EXPORT scree_gdal NAMESPACE scree:: FILE screeGdalTargets.cmake DESTINATION "${package_directory}")
endif()
install(EXPORT scree NAMESPACE scree:: FILE screeTargets.cmake DESTINATION "${package_directory}")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/screeConfig.cmake.in" "${PROJECT_BINARY_DIR}/screeConfig.cmake"
                              INSTALL_DESTINATION "${package_directory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/screeConfigVersion.cmake" COMPATIBILITY SameMinorVersion
                                 ${independent})
install(FILES "${PROJECT_BINARY_DIR}/screeConfig.cmake" "${PROJECT_BINARY_DIR}/screeConfigVersion.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/hdf5.cmake" "${CMAKE_CURRENT_LIST_DIR}/warn_unoptimised.cmake"
        DESTINATION "${package_directory}")
